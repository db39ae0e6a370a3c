// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/scene_model.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// How far views that stand for a photo are off, where that photo was left out.
struct MeasuredPhoto {
    std::string file;            ///< as the dataset calls it: "photos/R0010008.jpg"
    std::optional<double> p95Px; ///< nothing if it was not left out, or had no matches
};

/// What a report says of the photos of a dataset.
struct MeasuredPhotos {
    std::string surveyId; ///< that the dataset was made of
    std::string dataset;  ///< its name
    double tolerancePx = 0;
    double focalPx = 0;                                ///< of the camera
    render::SceneKind scene = render::SceneKind::None; ///< that was chosen, and that the errors are of
    std::vector<MeasuredPhoto> photos;                 ///< all of the dataset
};

/// Reads report.json, as writeReport() writes it. Errors: those of reading the file; Corrupt if it is no such
/// report; InvalidInput if nothing was measured in it.
MeasuredPhotos readMeasuredPhotos(const std::filesystem::path& reportFile);

} // namespace spherewalk::jobs
