// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/store/survey_store.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

/// Where a photo was really taken.
struct PhotoPlace {
    std::int64_t photo = 0;
    std::int64_t station = 0;
    std::optional<Eigen::Vector3d> positionM = {}; ///< of the lens; nothing: the station's
    bool choose = true;                            ///< in place of the photo that the station has chosen

    bool operator==(const PhotoPlace&) const = default;
};

/// Moves photos to other stations, all at once: the survey, and the position tags in the files, which are
/// written anew. Returns the places, as they were, of all photos of the stations concerned: moving them there
/// undoes it. Killed at any instant, it leaves the survey as it was or as it shall be, and at worst files
/// that belong to no photo. Errors: NotFound; InvalidInput for a photo that is named twice; those of reading,
/// tagging and writing; Stopped, with nothing changed.
std::vector<PhotoPlace> retagPhotos(store::SurveyStore& store, const std::vector<PhotoPlace>& places,
                                    ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::jobs
