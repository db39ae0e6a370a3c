// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

struct ImportOptions {
    std::filesystem::path photos;    ///< Folder of the photos.
    std::filesystem::path positions; ///< CSV file, see positions_csv.h.
    /// A photo belongs to a planned station within this distance. Otherwise it gets a station of its own.
    double stationToleranceM = 0.05;
};

struct ImportReport {
    int imported = 0;
    int alreadyThere = 0; ///< Number of photos that the survey had, with the same bytes.
    int newStations = 0;  ///< Number of stations made for photos that no planned station is near to.
    int withRotation = 0; ///< Number of listed photos whose rotation is given.
    int outsideOutline = 0;
};

/// Takes photos from elsewhere into the survey. Only their position tag changes. Rotations that the file
/// gives become a solution named "imported", and the active one. A run after a stop goes on where it was.
///
/// Errors: those of readPositions(); NotFound or Corrupt for a photo, whose line the sentence names.
/// Stop: Stopped before the next photo. Photos so far are kept, their rotations are not yet.
ImportReport importPhotos(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress,
                          const std::stop_token& stop);

Json toJson(const ImportReport& report);

} // namespace spherewalk::jobs
