// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

struct ImportOptions {
    std::filesystem::path photos; ///< Folder of the photos.
    /// CSV file, see positions_csv.h. Without one, all JPEGs of the folder come in, in the order of their
    /// names. Each gets a station of its own, whose place is not known.
    std::filesystem::path positions;
    /// A photo belongs to a planned station within this distance. Otherwise it gets a station of its own.
    double stationToleranceM = 0.05;
    /// Photos that the survey has at another place move to the place in the file. Otherwise their lines are
    /// refused.
    bool move = false;
};

/// A line of the positions file that brought no photo.
struct RefusedLine {
    int line = 0;
    std::string file;
    std::string sentence; ///< Says why, and names the line.
};

struct ImportReport {
    int imported = 0;
    int alreadyThere = 0;  ///< Number of photos that the survey had, with the same bytes.
    int newStations = 0;   ///< Number of stations made for photos that no planned station is near to.
    int unknownPlaces = 0; ///< Number of those stations whose place is not known.
    int withRotation = 0;  ///< Number of listed photos whose rotation is given.
    int outsideOutline = 0;
    int moved = 0; ///< Number of photos that the survey had, and that are at another place now.
    std::vector<RefusedLine> refused;
    std::vector<std::string> notes; ///< Sentences about photos that share a place, or are one photo twice.
};

/// Takes photos from elsewhere into the survey. Only their position tag changes. Rotations that the file
/// gives become a solution, the active one. It takes over what the solution that was active before says of
/// other photos, and is that alignment with some poses imported if there was one; else it is called
/// "imported". A line whose photo cannot be taken in is refused, with a warning, and
/// the others are taken in. A run after a stop goes on where it was.
///
/// Errors: those of readPositions(); if every line is refused, the error of the first one.
/// Stop: Stopped before the next photo. Photos so far are kept, their moves and rotations are not yet.
ImportReport importPhotos(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress,
                          const std::stop_token& stop);

Json toJson(const ImportReport& report);

} // namespace spherewalk::jobs
