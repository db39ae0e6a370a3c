// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/standings.h"

#include <algorithm>

namespace spherewalk::ui {

namespace {

Standing standingOf(store::Decision decision, survey::Quality quality) {
    switch (decision) {
    case store::Decision::Accepted:
        return Standing::Accepted;
    case store::Decision::Rejected:
        return Standing::Rejected;
    case store::Decision::Open:
        break;
    }
    switch (quality) {
    case survey::Quality::Good:
        return Standing::Taken;
    case survey::Quality::Doubtful:
        return Standing::Doubtful;
    case survey::Quality::Failed:
        break;
    }
    return Standing::Failed;
}

} // namespace

std::map<std::int64_t, Standing> standings(const store::SurveyStore& store,
                                           const std::optional<jobs::SolutionFindings>& findings) {
    std::map<std::int64_t, survey::Quality> qualities; // by photo: the worse of checks and alignment
    for (const store::PhotoVerdict& verdict : store.verdicts()) {
        qualities[verdict.photo] = verdict.quality;
    }
    if (findings) {
        for (const jobs::PhotoFinding& photo : findings->photos) {
            survey::Quality& worst = qualities[photo.photo];
            worst = std::max(worst, photo.quality.value_or(survey::Quality::Good));
        }
    }
    std::map<std::int64_t, store::Decision> decisions; // by photo
    for (const store::Review& review : store.reviews()) {
        decisions[review.photo] = review.decision;
    }
    std::map<std::int64_t, Standing> result;
    for (const store::StationRecord& station : store.stations()) {
        result[station.id] = Standing::Missing;
    }
    for (const store::PhotoRecord& photo : store.chosenPhotos()) {
        result[photo.station] = standingOf(decisions[photo.id], qualities[photo.id]);
    }
    return result;
}

} // namespace spherewalk::ui
