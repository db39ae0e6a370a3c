// SPDX-License-Identifier: GPL-3.0-or-later
#include "position_sentences.h"

#include "spherewalk/base/text.h"

namespace spherewalk::align {

namespace {

std::string shows(const std::string& station) {
    return text("it shows what is seen from ", station, ".");
}

/// Whether some photo tagged with the first planned position was taken at the second.
bool isTaken(int tagged, int taken, std::span<const PhotoPrior> photos, const Places& places,
             const PlannedLines& lines) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (places[i] == taken && lines.tag(photos[i]) == tagged) {
            return true;
        }
    }
    return false;
}

std::string shifted(const Finding& finding) {
    const std::string where = finding.stopsFarther > 0 ? "one stop farther along its rail than its tag says"
                                                       : "one stop before the one that its tag says";
    return finding.together > 1 ? text("It is one of ", finding.together, " photos taken ", where, ": ")
                                : text("It was taken ", where, ": ");
}

} // namespace

std::string sentence(int photo, std::span<const PhotoPrior> photos, const Places& places,
                     const Finding& finding, const Eigen::Vector3d& takenM, const PlannedLines& lines) {
    const PhotoPrior& prior = photos[static_cast<std::size_t>(photo)];
    const int taken = places[static_cast<std::size_t>(photo)];
    const int tagged = lines.tag(prior);
    if (taken < 0) {
        const std::string where = text("It was taken about ", fixed((takenM - prior.positionM).norm(), 2),
                                       " m from where its tag says, where no photo is planned");
        return finding.blunder == Blunder::Shifted ? text(where, ": one stop off the end of its rail.")
                                                   : text(where, ".");
    }
    const std::string& station = lines[taken].name;
    if (finding.blunder == Blunder::Reversed) {
        return text("Its rail was walked from the other end: ", shows(station));
    }
    if (finding.blunder == Blunder::Shifted && finding.together > 1) {
        return shifted(finding) + shows(station);
    }
    if (tagged >= 0 && isTaken(taken, tagged, photos, places, lines)) {
        return text("It shows what is seen from ", station, "; the photo tagged so shows ",
                    lines[tagged].name, ": they are swapped.");
    }
    return finding.blunder == Blunder::Shifted ? shifted(finding) + shows(station)
                                               : text("It shows what is seen from ", station, ".");
}

} // namespace spherewalk::align
