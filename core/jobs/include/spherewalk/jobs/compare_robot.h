// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/compare/colour_fit.h"
#include "spherewalk/compare/pose_fit.h"
#include "spherewalk/compare/sensor_fit.h"
#include "spherewalk/compare/steadiness.h"
#include "spherewalk/compare/tag_pose.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/render/view.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::render {
class Renderer;
}

namespace spherewalk::jobs {

struct CompareOptions {
    std::vector<RobotPicture> pictures; ///< Their poses may be approximate, or missing where tags are seen.
    bool refinesPoses = false;
    bool fitsColour = false;
    bool fitsSensor = false;
    render::ViewOptions view; ///< Scene model, sampling and threads of the views.
    std::size_t shown = 0;    ///< Number of pictures that the report keeps, spread evenly.
};

/// How like a robot's picture one view is.
struct PictureLikeness {
    Looks looks;
    /// Median displacement of the picture's features. Those that the view does not show are endlessly far
    /// off. Nothing without features.
    std::optional<double> medianPx;
    std::optional<double> p95Px;       ///< 95th percentile of the same features.
    std::size_t matches = 0;           ///< Number of features that were found.
    std::size_t missed = 0;            ///< Number of features that were not.
    std::optional<double> colourError; ///< As compare::colourError(); nothing if no spot is even.
};

struct ComparedPicture {
    std::filesystem::path file;
    std::string photo; ///< The photo that the view from the given pose is made from.
    Rigid3 given;
    std::optional<compare::PoseFit> refined; ///< Nothing unless poses are refined.
    PictureLikeness before;                  ///< The view from the given pose, in the photos' colours.
    /// The view from the refined pose and in corrected colours, as far as these are known.
    PictureLikeness after;
    /// How steady the view is from the picture before to this one, as `after` shows them. Nothing for the
    /// first picture.
    std::optional<compare::Steadiness> steadiness;

    Rigid3 used() const { return refined ? refined->roomFromCamera : given; }
};

/// A picture beside its views, small.
struct ShownPicture {
    std::string name;
    RgbImage picture;
    RgbImage before;
    RgbImage after;
    RgbImage difference; ///< Four times the difference of `after` and `picture`, on grey.
};

/// What the AprilTags in a picture without a pose told of its pose.
struct TagRegistered {
    std::filesystem::path file;
    std::string why;       ///< If it has no pose, a sentence that says why.
    compare::TagPose pose; ///< If it has one.
};

/// All pictures together.
struct CompareSummary {
    LooksSummary looks;
    std::optional<double> medianPx; ///< Over the features of all pictures, those missed too.
    std::optional<double> p95Px;
    double missedShare = 0;            ///< Share of those features that views do not show.
    std::optional<double> colourError; ///< Mean of the pictures that have one.
};

struct CompareReport {
    std::vector<ComparedPicture> pictures;
    std::vector<TagRegistered> registered; ///< One for each picture that had no pose.
    std::size_t refined = 0;               ///< Number of pictures whose pose was refined.
    CompareSummary before;
    CompareSummary after;
    std::optional<double> steadyMedianPx;  ///< Median over the pictures' steadiness; nothing without any.
    std::optional<double> steadyP95Px;     ///< Of the 95th percentiles likewise.
    std::optional<compare::ColourFit> fit; ///< Nothing unless colours are fitted.
    /// Error of the fit on pictures that it was not made from: each half of the pictures by the other half.
    /// Nothing below four pictures.
    std::optional<double> heldOutColourError;
    /// Nothing unless a sensor is fitted. It takes views in corrected colours, if `colour` has a correction.
    std::optional<compare::SensorFit> sensor;
    std::optional<render::ColourCorrection> colour; ///< Correction of `after`: fitted, or the dataset's own.
    std::vector<ShownPicture> shown;
    double seconds = 0;
};

/// Gives pictures without a pose one, by the AprilTags that they show and the dataset knows. Where a tag
/// allows two poses, the one whose view is more like the picture is taken. Pictures that remain without a
/// pose are taken out of the list. Errors: those of rendering, and of reading pictures. Stop: between
/// pictures.
std::vector<TagRegistered> registerPictures(const render::Renderer& renderer, const CameraModel& camera,
                                            const render::ViewOptions& view,
                                            std::vector<RobotPicture>& pictures, ProgressSink& progress,
                                            const std::stop_token& stop);

/// Compares the dataset's views with the pictures of a robot's camera. Pictures without a pose are registered
/// by their tags first; those that cannot be are named and not compared. If a pose cannot be refined, the
/// comparison keeps the given one and takes no colours from that picture.
///
/// Errors: InvalidInput for no pictures, for none with a pose, and for pictures that have not the camera's
/// size; those of rendering, and of reading pictures. Stop: Stopped, between two pictures.
CompareReport compareRobot(const render::Renderer& renderer, const CameraModel& camera,
                           const CompareOptions& options, ProgressSink& progress,
                           const std::stop_token& stop);

/// A table with a line for each picture and the means, and sentences about what was fitted.
std::string compareText(const CompareReport& report);

Json toJson(const CompareReport& report);

/// Writes report.html with its pictures beside it, the same as report.pdf, and report.json. The page needs no
/// network. The folder is made if need be. Errors: Io, Full; Internal.
void writeComparison(const CompareReport& report, const std::filesystem::path& folder);

/// Writes the poses that were used as a positions file that readRobotPictures() reads. Its names of pictures
/// are relative to the file's folder. Errors: Io, Full.
void writePoses(const CompareReport& report, const std::filesystem::path& file);

/// A picture beside the dataset's view from its pose, and beside what another program rendered for it.
struct ComparedRendering {
    std::filesystem::path picture;
    std::filesystem::path rendering;
    Looks ours;
    Looks theirs;
};

struct RenderingsReport {
    std::vector<ComparedRendering> pictures; ///< In the order that they were given.
    LooksSummary ours;
    LooksSummary theirs;
    /// Theirs beside ours, picture by picture. Nothing for few pictures, see looksBeside().
    std::optional<LooksBeside> theirsBesideOurs;
    std::vector<std::string> unused; ///< Names of renderings that no picture has, in their order.
};

/// Compares another program's renderings and the dataset's views with the same pictures. A rendering has its
/// picture's name and ends in .png, .jpg or .jpeg. Pictures may be photos that the dataset was exported
/// without, see ExportOptions::testEvery. Views are in the photos' colours.
///
/// Errors: NotFound for a folder that is not there, and for a picture without a rendering; InvalidInput for
/// no pictures, for names that stand for two files, for a rendering whose size is not the picture's, and for
/// a picture at whose very place the dataset has a photo, since that photo is in our view; those of reading
/// pictures and of rendering. Stop: Stopped. The result is the same for any number of threads.
RenderingsReport compareRenderings(const render::Renderer& renderer, const CameraModel& camera,
                                   const std::vector<RobotPicture>& pictures,
                                   const std::filesystem::path& renderings, const render::ViewOptions& view,
                                   ProgressSink& progress, const std::stop_token& stop);

/// A table for people, and sentences.
std::string renderingsText(const RenderingsReport& report);

Json toJson(const RenderingsReport& report);

} // namespace spherewalk::jobs
