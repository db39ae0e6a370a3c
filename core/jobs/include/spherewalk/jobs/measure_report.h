// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

struct MeasureReport;

/// The places that a tolerance counts. It holds if 95 of 100 of them are displaced by no more.
enum class Places {
    Features, ///< Features of the true picture; programs follow these from picture to picture. Features that
              ///< the view does not show are endlessly far off.
    Pixels,   ///< All pixels with a known depth. Pixels that the view cannot show right are among them.
};

/// "features" or "pixels".
std::string_view name(Places places);

/// Errors: InvalidInput for another name.
Places places(std::string_view name);

/// The 95th percentile of the places that count; the other one where that is not known. It is infinite where
/// more than 5 of 100 places are missed.
std::optional<double> errorPx(Places places, const std::optional<double>& features,
                              const std::optional<double>& pixels);

/// A thing in the room, and how far a view shows it off.
struct SeenThing {
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< Metres from the camera, along the room's axes.
    double errorPx = 0;
};

/// How like the true picture one view is.
struct ViewLikeness {
    std::string subject;                ///< Name of the true picture: photo and direction, or robot's file.
    std::string photo;                  ///< The photo that the view was made from.
    std::size_t index = 0;              ///< Number of the true picture, counted from 0.
    std::optional<std::size_t> leftOut; ///< Index in the dataset of the photo that was left out.
    Rigid3 roomFromCamera;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< From the photo to the camera, room frame.
    Looks looks;
    std::optional<double> medianPx; ///< Of all features, those missed too; nothing without features.
    std::optional<double> p95Px;
    std::size_t matches = 0; ///< Number of features that were found.
    std::size_t missed = 0;  ///< Number of features that were not.
    /// Displacement of all pixels with a true depth. Photos that are left out have an estimated depth
    /// instead.
    std::optional<double> exactMedianPx;
    std::optional<double> exactP95Px;
    std::vector<SeenThing> things; ///< What some of those pixels show.

    const Eigen::Vector3d& at() const { return roomFromCamera.translation; }

    /// The camera's optical axis, room frame.
    Eigen::Vector3d axis() const { return roomFromCamera.rotation * Eigen::Vector3d::UnitZ(); }

    std::optional<double> errorPx(Places of) const { return jobs::errorPx(of, p95Px, exactP95Px); }
};

/// The error about one photo that was left out, over all directions.
struct PhotoError {
    std::size_t photo = 0; ///< Index in the dataset.
    std::optional<double> p95Px;
    std::size_t places = 0; ///< Number of places that were compared, those missed too.
};

/// How like the truth the views of one scene model with one sampling are.
struct SceneLikeness {
    render::SceneKind scene = render::SceneKind::None;
    render::Sampling sampling = render::Sampling::Footprint;
    std::vector<ViewLikeness> views;
    std::vector<PhotoError> photos; ///< The photos that were left out.
    LooksSummary looks;
    std::optional<double> medianPx; ///< Over all views' features together, those missed too.
    std::optional<double> p95Px;    ///< 95th percentile of the same features.
    double missedShare = 0;         ///< Share of the features that views do not show.
    std::optional<double> exactMedianPx;
    std::optional<double> exactP95Px;

    /// Nothing if there was nothing to compare.
    std::optional<double> errorPx(Places of) const { return jobs::errorPx(of, p95Px, exactP95Px); }
};

/// What a view costs, in multiples of one of the sphere with bilinear sampling. The numbers are stored, so
/// that a choice does not depend on what else the machine does. Range: any sampling but Auto.
double nominalCost(render::SceneKind scene, render::Sampling sampling);

/// What a scene model with a sampling costs, and how far its views are off.
struct Rung {
    render::SceneKind scene = render::SceneKind::None;
    render::Sampling sampling = render::Sampling::Footprint;
    std::optional<double> errorPx; ///< 95th percentile; infinite if more than 5 of 100 places are missed.
    double renderMs = 0;           ///< Median time of a view whose photos are decoded.
    std::uint64_t bytes = 0;       ///< Size of a dataset with this scene model and no richer one.

    double cost() const { return nominalCost(scene, sampling); }
};

/// A scene model that is not chosen, because a cheaper one looks better.
struct PassedOver {
    render::SceneKind scene = render::SceneKind::None;
    render::SceneKind than = render::SceneKind::None; ///< The cheaper one.
    LooksBeside looks;                                ///< Of `scene` beside `than`.
};

/// The scene models whose views look worse than those of a cheaper one at the same places: lower SSIM or more
/// false edges, beyond the margin of PairedDifference. Each is named once, with the one that beats it by
/// most.
std::vector<PassedOver> passedOver(const MeasureReport& report);

/// The cheapest rung within a tolerance, or the best one if none is. Scene models that are passed over are
/// not chosen.
struct Choice {
    double tolerancePx = 0;
    std::optional<std::size_t> rung; ///< Index in MeasureReport::rungs; nothing if nothing was compared.
    bool isWithin = false;           ///< Whether the rung holds the tolerance.
    std::string reason;              ///< Sentences.
    /// A cheaper scene model for each photo where that is enough. Empty if no photo has one.
    std::vector<std::optional<render::SceneKind>> photoScenes;
    double meanRenderMs = 0; ///< Time with photoScenes, over the photos that were left out.
    std::vector<PassedOver> passedOver;
};

/// How well leaving photos out foretold the errors of a robot's pictures.
struct Prediction {
    render::SceneKind scene = render::SceneKind::None;
    std::vector<double> foretoldPx; ///< Median error of each picture that has both values.
    std::vector<double> foundPx;
    std::optional<double> rankCorrelation; ///< As rankCorrelation() gives it.
    std::optional<double> factor; ///< Median of foretold / found; nothing where nothing was found to be off.
};

/// How much views of one place change where the camera passes from one photo's cell into another's.
struct BorderJump {
    render::SceneKind scene = render::SceneKind::None;
    std::size_t borders = 0; ///< Number of borders that were compared.
    double psnrDb = 0;       ///< Between what both sides show, the mean over borders. Range: at most 99.
    double worstPsnrDb = 0;
    std::optional<double> medianPx; ///< By how much features move, over all borders together.
    std::optional<double> p95Px;    ///< Infinite if more than 5 of 100 features are not found again.
    double missedShare = 0;         ///< Share of the features of one side that the other does not show.
};

/// A view that is among the farthest from the truth.
struct ShownView {
    std::string subject;
    std::optional<double> errorPx;
    Looks looks;
    RgbImage truth;
    RgbImage view;
    RgbImage difference; ///< Grey where truth and view agree.
};

struct MeasureReport {
    std::string dataset; ///< Name of the dataset.
    bool isLeaveOneOut = true;
    std::size_t photos = 0;
    Places places = Places::Features;
    int directions = 0;          ///< Number of directions that each photo was compared in.
    std::size_t reusedViews = 0; ///< Views that an earlier run compared.
    std::optional<double> sphereRadiusM;
    /// Median distance in metres of the compared views from the photos that they were made from.
    double viewM = 0;
    /// Median distance in metres from places between the photos to the nearest photo.
    double betweenM = 0;
    double focalPx = 0;                ///< Focal length of the camera.
    std::vector<SceneLikeness> scenes; ///< The scene models that the dataset has, cheap to exact.
    std::size_t samplingViews = 0;     ///< Number of views that the samplings were compared on.
    std::vector<Rung> rungs;           ///< By scene model, then by sampling, cheap to exact.
    Choice choice;                     ///< For the tolerance that was asked for.
    std::vector<Choice> choices;       ///< For tolerances of 1, 2, 4 and 8 px.
    std::vector<ShownView> worst;
    std::vector<BorderJump> borders; ///< One for each scene model; empty for a single photo.
    double seconds = 0;
    /// Only with a robot's pictures: the report of the photos that were left out.
    std::shared_ptr<const MeasureReport> leaveOneOut;
    std::vector<Prediction> predictions; ///< Only with a robot's pictures: one for each scene model.
};

/// The rung within the tolerance that costs least by nominalCost(). Among rungs within a tenth of that cost,
/// the smallest dataset wins, then the smallest error. Photos whose own views hold the tolerance with a
/// cheaper scene model get that one. The same errors give the same choice on any machine.
Choice chosen(const MeasureReport& report, double tolerancePx);

/// The choice as dataset.json keeps it. Nothing if nothing could be compared.
std::optional<render::ViewChoice> viewChoice(const MeasureReport& report);

/// The median error in pixels that leaving photos out foretells of views between all photos: parallax grows
/// with the distance to the photo. Nothing if it is not known, and for `room`, whose errors are not foretold
/// so.
std::optional<double> betweenPx(const MeasureReport& leaveOneOut, const SceneLikeness& scene);

/// The errors, the choice and the reason, for people.
std::string measureText(const MeasureReport& report);

Json toJson(const MeasureReport& report);

} // namespace spherewalk::jobs
