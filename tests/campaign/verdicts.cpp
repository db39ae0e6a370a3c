// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdicts.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <array>
#include <cmath>
#include <map>

namespace spherewalk::campaign {

namespace {

bool isSame(const Json& wanted, const Json& found) {
    return wanted.is_number() && found.is_number()
               ? std::abs(wanted.get<double>() - found.get<double>()) <= 1e-3 * std::abs(wanted.get<double>())
               : wanted == found;
}

/// That a photo was asked for, and that there is none: of a camera whose files were deleted meanwhile, or
/// that says that it has cancelled what it has not.
constexpr std::array<std::string_view, 2> kNoPhoto{": The camera has taken no photo",
                                                   ": The camera refused to take the photo"};

int count(const std::string& said, const std::string& words) {
    int found = 0;
    for (std::size_t at = said.find(words); at != std::string::npos; at = said.find(words, at + 1)) {
        ++found;
    }
    return found;
}

/// What the survey knows of a station.
struct Known {
    int photos = 0;
    int told = 0; ///< shots that are Unclear, or Taken but not to be had
};

} // namespace

Findings examine(const std::filesystem::path& survey, const std::filesystem::path& truthFile,
                 const Json& exposure, const std::string& said) {
    Findings findings;
    const auto violate = [&](std::string sentence) { findings.violations.push_back(std::move(sentence)); };
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    if (!store.check(noProgress(), {}).isSound()) {
        violate("the survey is not sound");
    }
    for (std::string& sentence : jobs::checkPlaces(store, noProgress(), {})) {
        violate(std::move(sentence));
    }
    std::map<std::string, practice::Truth> truthOf;
    const bool hasTruth = std::filesystem::exists(truthFile);
    for (const practice::Truth& truth :
         hasTruth ? practice::readTruth(truthFile) : std::vector<practice::Truth>()) {
        truthOf[truth.sha256] = truth;
    }
    std::map<std::int64_t, Known> known;
    for (const auto& shots : {store.unclearShots(), store.openShots()}) {
        for (const survey::Shot& shot : shots) {
            ++known[shot.station].told;
            ++findings.toldShots;
        }
    }
    for (const store::PhotoRecord& photo : store.photos()) {
        ++findings.photos;
        ++known[photo.station].photos;
        const store::StationRecord station = store.station(photo.station);
        const auto found = truthOf.find(photo.cameraSha256);
        if (found == truthOf.end()) {
            violate(text("the photo of ", station.name, " is none of the camera's"));
            continue;
        }
        const practice::Truth& truth = found->second;
        // One by the button just then, while the trigger was lost on the way, is as good.
        if (truth.nominalPositionM != station.station.positionM) {
            violate(text("the photo of ", station.name, " was taken elsewhere"));
        }
        for (const auto& [name, value] : exposure.items()) {
            if (!isSame(value, truth.options.value(name, Json()))) {
                violate(text("the photo of ", station.name, " was taken with ", name, " ",
                             truth.options.value(name, Json()).dump()));
            }
        }
    }
    for (const store::StationRecord& station : store.stations()) {
        int exposures = 0;
        for (const auto& [sha256, truth] : truthOf) {
            exposures += truth.nominalPositionM == station.station.positionM && !truth.byButton ? 1 : 0;
        }
        Known& here = known[station.id];
        for (const std::string_view words : kNoPhoto) {
            here.told += count(said, text(station.name, words));
        }
        findings.exposures += exposures;
        if (here.photos == 0) {
            violate(text(station.name, " has no photo after all runs"));
        }
        if (exposures > here.photos + here.told) {
            violate(text(station.name, " was exposed ", exposures, " times, but has ", here.photos,
                         " photos and ", here.told, " shots that the operator was told of"));
        }
    }
    for (const auto& [sha256, truth] : truthOf) {
        findings.buttonPictures += truth.byButton ? 1 : 0;
    }
    return findings;
}

} // namespace spherewalk::campaign
