// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/renderer.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A picture of the robot's camera, to compare views with.
struct RobotPicture {
    std::filesystem::path file;
    std::filesystem::path depthFile; ///< PNG of 16 bits, millimetres along the axis; empty: not known
    Rigid3 roomFromCamera;           ///< of the optical frame
};

/// Reads a positions file (readPositions()) in which each line has a rotation, and optionally a depth; files
/// are relative to it. Errors: as readPositions().
std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv);

struct MeasureOptions {
    std::vector<RobotPicture> pictures; ///< none: photos are left out and compared with the others' views
    int mostPhotos = 40;                ///< that are left out, spread evenly
    int directions = 4;                 ///< of each, spread evenly about the horizon
    double tolerancePx = 2;             ///< of the robot's camera
    render::Sampling sampling = render::Sampling::Footprint;
    int threads = 0;
};

/// How like the truth one view is.
struct ViewLikeness {
    std::string subject; ///< the photo left out and the direction, or the robot's picture
    std::string photo;   ///< it was made from
    double offsetM = 0;
    double psnrDb = 0;
    double ssim = 0;
    std::optional<double> medianPx; ///< of matched features' displacements; nothing without matches
    std::optional<double> p95Px;
    std::size_t matches = 0;
    std::optional<double> exactMedianPx; ///< of all pixels with a true depth
    std::optional<double> exactP95Px;
    double renderMs = 0;
};

struct SceneLikeness {
    render::SceneKind scene = render::SceneKind::None;
    std::vector<ViewLikeness> views;
    double meanPsnrDb = 0;
    double worstPsnrDb = 0;
    double meanSsim = 0;
    std::optional<double> medianPx; ///< mean of the views' medians
    std::optional<double> p95Px;    ///< of all views' displacements together
    std::optional<double> exactMedianPx;
    std::optional<double> exactP95Px;
    double medianRenderMs = 0;
};

struct MeasureReport {
    bool isLeaveOneOut = true;
    std::size_t photos = 0;
    std::optional<double> sphereRadiusM;
    std::vector<SceneLikeness> scenes; ///< cheap to exact, those that the dataset has
    double tolerancePx = 0;
    std::optional<render::SceneKind> choice; ///< the cheapest whose 95th percentile is within the tolerance
    std::string reason;                      ///< a sentence
    double seconds = 0;
};

/// Compares the views of each scene model of the dataset with the truth. Left out photos are compared as a
/// camera at their place would see them. Errors: those of rendering and of reading the pictures; Stopped.
MeasureReport measureDataset(const render::Renderer& renderer, const CameraModel& camera,
                             const MeasureOptions& options, ProgressSink& progress,
                             const std::stop_token& stop);

/// The views' errors for people, one line a scene model.
std::string measureText(const MeasureReport& report);

Json toJson(const MeasureReport& report);

/// One page that needs no network. Errors: Io, Full.
void writeMeasurePage(const MeasureReport& report, const std::filesystem::path& folder);

} // namespace spherewalk::jobs
