// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"

#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::render {
class Dataset;
}

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

/// Checks that the program says one place of every photo, wherever it says it. The position tag in the file
/// names the survey, station and position that the survey's record has. The active solution does not put the
/// photo nearer to another station.
///
/// Returns a sentence for each photo that breaks the rule. Files that cannot be read are left to
/// SurveyStore::check(). Stop: Stopped.
std::vector<std::string> checkPlaces(const store::SurveyStore& store, ProgressSink& progress,
                                     const std::stop_token& stop);

/// The same of a dataset: the tag in each photo names the station, position and rotation that the dataset's
/// description has. A photo without a tag breaks no rule, because other programs make datasets, too. Errors:
/// those of Dataset::readPhoto(). Stop: Stopped.
std::vector<std::string> checkPlaces(const render::Dataset& dataset, ProgressSink& progress,
                                     const std::stop_token& stop);

} // namespace spherewalk::jobs
