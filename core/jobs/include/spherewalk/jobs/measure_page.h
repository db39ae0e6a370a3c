// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/ladder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::render {
struct DatasetInfo;
}

namespace spherewalk::jobs {

struct GridStudy;
struct MeasureReport;

/// What a report page shows. Owner: the objects that it points to must outlive it.
struct ReportContents {
    const render::DatasetInfo* dataset = nullptr; ///< Never null.
    const MeasureReport* measured = nullptr;      ///< Null if nothing was measured.
    const GridStudy* grid = nullptr;              ///< Null if no grid was studied.
};

/// Writes report.html with its pictures beside it, the same as report.pdf, and all figures as report.json.
/// The page needs no network. The folder is made if need be. Errors: Io, Full; Internal.
void writeReport(const ReportContents& contents, const std::filesystem::path& folder);

/// How far views are off that replace a photo which was left out.
struct MeasuredPhoto {
    std::string file; ///< Name in the dataset, such as "photos/R0010008.jpg".
    /// Nothing if the photo was not left out, or had no places; +infinity if more than 5 of 100 of them were
    /// not found.
    std::optional<double> p95Px;
};

/// What a report says of the photos of a dataset.
struct MeasuredPhotos {
    std::string surveyId; ///< The survey that the dataset was made of.
    std::string dataset;  ///< Name of the dataset.
    double tolerancePx = 0;
    double focalPx = 0;                                ///< Focal length of the camera.
    render::SceneKind scene = render::SceneKind::None; ///< The chosen scene model; the errors are its own.
    std::vector<MeasuredPhoto> photos;                 ///< All photos of the dataset.
};

/// Reads a report.json that writeReport() wrote. Errors: those of reading the file; Corrupt if it is no such
/// report; InvalidInput if nothing was measured in it.
MeasuredPhotos readMeasuredPhotos(const std::filesystem::path& reportFile);

} // namespace spherewalk::jobs
