// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/measure/colour_fit.h"
#include "spherewalk/measure/pose_fit.h"
#include "spherewalk/render/renderer.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

struct CompareOptions {
    std::vector<RobotPicture> pictures; ///< with poses that may be approximate
    bool refinesPoses = false;
    bool fitsColour = false;
    render::ViewOptions view; ///< scene model, sampling and threads of the views
    std::size_t shown = 0;    ///< pictures that are kept beside their views, spread evenly
};

/// How like a robot's picture one view is.
struct PictureLikeness {
    double psnrDb = 0;
    std::optional<double> medianPx; ///< of matched features' displacements; nothing without matches
    std::optional<double> p95Px;
    std::size_t matches = 0;
    std::optional<double> colourError; ///< measure::colourError(); nothing where nothing is even
};

struct ComparedPicture {
    std::filesystem::path file;
    std::string photo; ///< that the view from the given pose is made from
    Rigid3 given;
    std::optional<measure::PoseFit> refined; ///< if poses are refined
    PictureLikeness before;                  ///< from the given pose, in the photos' colours
    PictureLikeness
        after; ///< from the refined pose, if there is one, in corrected colours, if there is a correction

    Rigid3 used() const { return refined ? refined->roomFromCamera : given; }
};

/// A picture beside its views, small.
struct ShownPicture {
    std::string name;
    RgbImage picture;
    RgbImage before;
    RgbImage after;
    RgbImage difference; ///< of after, four times, on grey
};

/// Means over the pictures that have a value.
struct CompareSummary {
    double psnrDb = 0;
    std::optional<double> medianPx;
    std::optional<double> p95Px;
    std::optional<double> colourError;
};

struct CompareReport {
    std::vector<ComparedPicture> pictures;
    std::size_t refined = 0; ///< pictures whose pose could be
    CompareSummary before;
    CompareSummary after;
    std::optional<measure::ColourFit> fit; ///< if a correction was to be fitted
    /// What the fit comes to on pictures that it was not made from, each half of them by the other half; from
    /// four pictures on.
    std::optional<double> heldOutColourError;
    std::optional<render::ColourCorrection> colour; ///< of "after": fitted, or the dataset's own
    std::vector<ShownPicture> shown;
    double seconds = 0;
};

/// Compares the dataset's views with the pictures of a robot's camera. A picture whose pose cannot be
/// refined is compared from the given one, and no colours are taken from it. Errors: InvalidInput for no
/// pictures, and pictures that have not the camera's size; those of rendering, reading and writing pictures;
/// Stopped.
CompareReport compareRobot(const render::Renderer& renderer, const CameraModel& camera,
                           const CompareOptions& options, ProgressSink& progress,
                           const std::stop_token& stop);

/// A line a picture, the means, and what was fitted.
std::string compareText(const CompareReport& report);

Json toJson(const CompareReport& report);

/// Writes report.html (which needs no network), its pictures beside, the same as report.pdf, and report.json
/// into the folder, which is made if need be. Errors: Io, Full; Internal.
void writeComparison(const CompareReport& report, const std::filesystem::path& folder);

/// The poses that were used, as readRobotPictures() takes them; files are named from where it stands. Errors:
/// Io, Full.
void writePoses(const CompareReport& report, const std::filesystem::path& file);

/// Puts a colour correction into a dataset's description, in place of an earlier one; all else stays.
/// Datasets that are open keep what they have read. Errors: those of ColourCorrection::validate(); NotFound,
/// Io, Full, Corrupt.
void storeColour(const std::filesystem::path& dataset, const render::ColourCorrection& correction);

} // namespace spherewalk::jobs
