// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace spherewalk::ui {

/// What every page wants to know of a survey, in memory: the database answers late while somebody writes it.
struct SurveyState {
    survey::Room room;
    survey::PlanOptions options;
    std::optional<survey::CaptureProfile> profile; ///< how the camera is set for the photos
    survey::Plan plan;
    std::vector<store::StationRecord> stations; ///< in walking order
    std::set<std::int64_t> missing;             ///< stations where a photo is still to be taken
    store::Counts counts;
};

/// Errors: those of the store.
SurveyState readState(const store::SurveyStore& store);

} // namespace spherewalk::ui
