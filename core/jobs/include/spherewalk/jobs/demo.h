// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/alignment_truth.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/walk.h"

#include <cstdint>
#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

struct DemoOptions {
    int photoWidth = 5376; ///< of the practice camera's photos, as a Theta V's
    double stepM = 0.6;    ///< coarse, so that it is over in a minute or two
    int frames = 72;       ///< of the walk
    std::uint64_t seed = 1;
};

struct DemoReport {
    std::filesystem::path folder;
    int placements = 0;
    CaptureSurveyReport capture;
    AlignReport aligned;
    AlignmentError alignmentError; ///< against the practice camera's truth
    ExportReport exported;
    WalkReport walk;
    double atPhotosDb = 0; ///< median likeness of views at the photos' own positions to the exact pictures
    double betweenDb = 0;  ///< the same along the walk, between the photos
};

/// A new survey of the practice room, as an operator would have drawn it, planned at this step. Errors: those
/// of store::SurveyStore::create().
store::SurveyStore newPracticeSurvey(const std::filesystem::path& folder, double stepM);

/// The whole way on the practice room: plan, photos over HTTP from a practice camera, alignment (compared
/// with where the camera really was), export, a walk, and how alike the views are to pictures that are ray
/// cast from the same poses. Everything is left in the folder, which must not exist yet.
DemoReport demo(const std::filesystem::path& folder, const DemoOptions& options, ProgressSink& progress,
                const std::stop_token& stop);

Json toJson(const DemoReport& report);

} // namespace spherewalk::jobs
