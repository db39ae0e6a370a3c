// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jobs/depth_survey.h"
#include "spherewalk/render/scene_model.h"
#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

struct ExportOptions {
    dataset::WriteOptions write;
    /// The richest scene model of the dataset; the cheaper ones come with it. Room takes a
    /// minute or two, Depth some seconds a photo.
    render::SceneKind scene = render::SceneKind::Sphere;
    DepthOptions depth;
};

struct ExportReport {
    dataset::WriteReport written;
    int withoutPhoto = 0;     ///< stations that the dataset lacks
    int rejected = 0;         ///< photos that a person rejected, and that are left out
    int withoutRotation = 0;  ///< photos whose heading is not known
    double sphereRadiusM = 0; ///< 0 if no photo stands inside of the outline
    std::optional<render::RoomShape> roomShape;
    DepthReport depth;
};

/// Exports the chosen photo of every station, unless it was rejected, with the active solution's poses. A
/// photo that the solution lacks gets the tilt that it states itself and the heading 0, and says so. Errors:
/// those of dataset::writeDataset().
ExportReport exportDataset(const store::SurveyStore& store, const std::filesystem::path& folder,
                           const ExportOptions& options, ProgressSink& progress, const std::stop_token& stop);

/// The richest scene model that an export makes without estimating depths: Depth if all are known from an
/// earlier one with these options, or else Sphere.
render::SceneKind knownScene(const store::SurveyStore& store, const DepthOptions& options);

/// What an export would make, and what is to be known before.
struct ExportCheck {
    std::size_t photos = 0;
    std::uint64_t totalBytes = 0; ///< about; those of the photos and what one of them was found to grow by
    std::uint64_t freeBytes = 0;  ///< where it is to be written
    double seconds = 0;           ///< about; what one photo took, on all threads, and depths
    std::vector<std::string> obstacles; ///< sentences: why it cannot be done
    std::vector<std::string> doubts;    ///< sentences: what the dataset would lack

    bool isPossible() const { return obstacles.empty(); }
};

/// Looks before an export. Exports one photo to a temporary folder, and estimates the depth of one where
/// depths are wanted, to know what the photos of this survey cost on this machine. Errors: those of reading
/// photos; Stopped.
ExportCheck checkExport(const store::SurveyStore& store, const std::filesystem::path& folder,
                        const ExportOptions& options, ProgressSink& progress, const std::stop_token& stop);

Json toJson(const ExportReport& report);
Json toJson(const ExportCheck& check);

} // namespace spherewalk::jobs
