// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// What a tolerance is about, of which 95 of 100 must hold it.
enum class Places {
    Features, ///< that are found again, which is what programs follow from picture to picture
    Pixels,   ///< all with a known depth, also those that the view cannot show right, which are lost as
              ///< features
};

/// "features" and "pixels". Errors of the latter: InvalidInput.
std::string_view name(Places places);
Places places(std::string_view name);

/// The 95th percentile that counts, the other one where it is not known.
std::optional<double> errorPx(Places places, const std::optional<double>& features,
                              const std::optional<double>& pixels);

/// A thing of which a view shows how far it is off.
struct SeenThing {
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< room frame, metres from the camera
    double errorPx = 0;
};

/// How like the truth one view is.
struct ViewLikeness {
    std::string subject;                ///< the photo left out and the direction, or the robot's picture
    std::string photo;                  ///< it was made from
    std::size_t index = 0;              ///< of the picture it was compared with
    std::optional<std::size_t> leftOut; ///< the photo, by its index in the dataset
    Rigid3 roomFromCamera;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< of the camera from the photo, room frame
    double psnrDb = 0;                                ///< at most 99
    double ssim = 0;
    std::optional<double> medianPx; ///< of matched features' displacements; nothing without matches
    std::optional<double> p95Px;
    std::size_t matches = 0;
    /// Of all pixels with a true depth; where a photo was left out, with the depth that was estimated for it.
    std::optional<double> exactMedianPx;
    std::optional<double> exactP95Px;
    std::vector<SeenThing> things; ///< some of those pixels

    const Eigen::Vector3d& at() const { return roomFromCamera.translation; }

    /// Of the camera, room frame.
    Eigen::Vector3d axis() const { return roomFromCamera.rotation * Eigen::Vector3d::UnitZ(); }

    std::optional<double> errorPx(Places of) const { return jobs::errorPx(of, p95Px, exactP95Px); }
};

/// What was found about one photo that was left out, all directions together.
struct PhotoError {
    std::size_t photo = 0; ///< index in the dataset
    std::optional<double> p95Px;
    std::size_t places = 0; ///< that were compared
};

/// How like the truth the views of one scene model with one sampling are.
struct SceneLikeness {
    render::SceneKind scene = render::SceneKind::None;
    render::Sampling sampling = render::Sampling::Footprint;
    std::vector<ViewLikeness> views;
    std::vector<PhotoError> photos; ///< those that were left out
    double meanPsnrDb = 0;
    double worstPsnrDb = 0;
    double meanSsim = 0;
    /// Mean of the medians of the views with 20 matches or more; of all views if none has so many.
    std::optional<double> medianPx;
    std::optional<double> p95Px; ///< of all views' displacements together
    std::optional<double> exactMedianPx;
    std::optional<double> exactP95Px;

    /// Nothing if there was nothing to compare.
    std::optional<double> errorPx(Places of) const { return jobs::errorPx(of, p95Px, exactP95Px); }
};

/// What a scene model with a sampling costs and how far it is off.
struct Rung {
    render::SceneKind scene = render::SceneKind::None;
    render::Sampling sampling = render::Sampling::Footprint;
    std::optional<double> errorPx; ///< 95th percentile
    double renderMs = 0;           ///< median of a view whose photos are decoded
    std::uint64_t bytes = 0;       ///< of a dataset with this scene model and no richer one
};

/// The cheapest rung within a tolerance, or the best one if there is none.
struct Choice {
    double tolerancePx = 0;
    std::optional<std::size_t> rung; ///< index; nothing if nothing could be compared
    bool isWithin = false;
    std::string reason; ///< sentences
    /// A cheaper scene model where that is enough, by photo; empty if no photo has one.
    std::vector<std::optional<render::SceneKind>> photoScenes;
    double meanRenderMs = 0; ///< with photoScenes, over the photos that were left out
};

/// How well leaving photos out foretold the errors of a robot's pictures.
struct Prediction {
    render::SceneKind scene = render::SceneKind::None;
    std::vector<double> foretoldPx; ///< of each picture with both, the median
    std::vector<double> foundPx;
    std::optional<double> rankCorrelation; ///< as measure::rankCorrelation() says
};

/// A view that is among the farthest from the truth.
struct ShownView {
    std::string subject;
    std::optional<double> errorPx;
    double psnrDb = 0;
    RgbImage truth;
    RgbImage view;
    RgbImage difference; ///< grey where they agree
};

struct MeasureReport {
    std::string dataset; ///< its name
    bool isLeaveOneOut = true;
    std::size_t photos = 0;
    Places places = Places::Features; ///< that were counted
    int directions = 0;               ///< that photos were compared in
    std::size_t reusedViews = 0;      ///< from an earlier run
    std::optional<double> sphereRadiusM;
    double focalPx = 0;                ///< of the camera
    std::vector<SceneLikeness> scenes; ///< cheap to exact, those that the dataset has
    std::size_t samplingViews = 0;     ///< that the samplings were compared on
    std::vector<Rung> rungs;           ///< scene models, and in each the samplings, cheap to exact
    Choice choice;
    std::vector<Choice> choices; ///< for tolerances of 1, 2, 4 and 8 px
    std::vector<ShownView> worst;
    double seconds = 0;
    /// With a robot's pictures: what leaving photos out says, and what it foretold of each scene model.
    std::shared_ptr<const MeasureReport> leaveOneOut;
    std::vector<Prediction> predictions;
};

/// The cheapest rung within the tolerance: by time; those within a tenth of it by the dataset's size. Where a
/// photo's own views say that a cheaper scene model is enough about it, that is taken there.
Choice chosen(const MeasureReport& report, double tolerancePx);

/// For dataset.json. Nothing if nothing could be compared.
std::optional<render::ViewChoice> viewChoice(const MeasureReport& report);

/// The errors, the choice and the reason for people.
std::string measureText(const MeasureReport& report);

Json toJson(const MeasureReport& report);

} // namespace spherewalk::jobs
