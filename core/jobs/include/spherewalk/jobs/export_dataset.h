// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jobs/depth_survey.h"
#include "spherewalk/render/scene_model.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

struct ExportOptions {
    dataset::WriteOptions write;
    /// The richest scene model of the dataset; the cheaper ones come with it. Room and Depth take some
    /// seconds a photo.
    render::SceneKind scene = render::SceneKind::Sphere;
    DepthOptions depth;
};

struct ExportReport {
    dataset::WriteReport written;
    int withoutPhoto = 0;     ///< stations that the dataset lacks
    int withoutRotation = 0;  ///< photos whose heading is not known
    double sphereRadiusM = 0; ///< 0 if no photo stands inside of the outline
    std::optional<render::RoomShape> roomShape;
    DepthReport depth;
};

/// Exports the chosen photo of every station with the active solution's poses. A photo that the solution
/// lacks gets the tilt that it states itself and the heading 0, and says so. Errors: those of
/// dataset::writeDataset().
ExportReport exportDataset(const store::SurveyStore& store, const std::filesystem::path& folder,
                           const ExportOptions& options, ProgressSink& progress, const std::stop_token& stop);

Json toJson(const ExportReport& report);

} // namespace spherewalk::jobs
