// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

struct ImportOptions {
    std::filesystem::path photos;    ///< folder
    std::filesystem::path positions; ///< CSV, see positions_csv.h
    double stationToleranceM = 0.05; ///< a photo within this distance of a planned station belongs to it
};

struct ImportReport {
    int imported = 0;
    int alreadyThere = 0; ///< photos that the survey had, by their bytes
    int newStations = 0;  ///< made for photos that no planned station is near to
    int withRotation = 0; ///< of the imported ones
    int outsideOutline = 0;
};

/// Takes photos from elsewhere into the survey, unchanged but for their position tag. Rotations that the file
/// gives become a solution named "imported", and the active one. It can be stopped and called again: photos
/// that are there are left out. Errors: those of readPositions(); NotFound or Corrupt for a photo, named with
/// its line; Stopped.
ImportReport importPhotos(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress,
                          const std::stop_token& stop);

Json toJson(const ImportReport& report);

} // namespace spherewalk::jobs
