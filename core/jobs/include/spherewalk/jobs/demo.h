// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/jobs/walk.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>

namespace spherewalk::jobs {

struct DemoOptions {
    int photoWidth = 5376; ///< Width of the practice camera's photos, as a Theta V's.
    double stepM = 0.6;    ///< Step of the grid; coarse, so that the demo takes a minute or two.
    int frames = 72;       ///< Number of views along the walk.
    std::uint64_t seed = 1;
    /// The richest scene model. Nothing: all are made, and what is measured to be best is the dataset's
    /// choice.
    std::optional<render::SceneKind> scene = {};
};

struct DemoReport {
    std::filesystem::path folder;
    int placements = 0; ///< Placements of the rail in the plan.
    CaptureSurveyReport capture;
    AlignReport aligned;
    AlignmentError alignmentError; ///< Against the practice camera's truth.
    ExportReport exported;
    std::optional<Choice> choice; ///< What was measured, unless the options name a scene model.
    render::SceneKind scene = render::SceneKind::Sphere; ///< That of the views.
    WalkReport walk;
    double atPhotosDb = 0; ///< Median PSNR of views at the photos' own places against exact pictures.
    double betweenDb = 0;  ///< Median PSNR of views along the walk, between the photos.
    double betweenWithSphereDb = 0; ///< The same with the sphere.
};

/// A new survey of the practice room as an operator would have drawn it, planned with this step. Errors:
/// those of store::SurveyStore::create().
store::SurveyStore newPracticeSurvey(const std::filesystem::path& folder, double stepM);

/// Goes the whole way on the practice room: a plan, photos over HTTP from a practice camera, an alignment, a
/// dataset whose scene models are measured, and a walk. Compares the alignment with the camera's true poses,
/// and the views, with the chosen scene model and with the sphere, with pictures that are ray cast from the
/// same poses. Everything stays in the folder, which must not exist yet.
DemoReport demo(const std::filesystem::path& folder, const DemoOptions& options, ProgressSink& progress,
                const std::stop_token& stop);

Json toJson(const DemoReport& report);

} // namespace spherewalk::jobs
