// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/measure_comparison.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/measure_report.h"

#include <map>

namespace spherewalk::jobs {

/// Puts the views of one scene model together.
class SceneSummary {
  public:
    SceneSummary(render::SceneKind scene, render::Sampling sampling, Places places);

    /// view: what is known of the view besides the comparison.
    void add(const Comparison& comparison, ViewLikeness view);
    SceneLikeness result() const;

  private:
    Places m_places;
    SceneLikeness m_result;
    PlaceErrors m_features;
    std::vector<int> m_exact;
    std::map<std::size_t, PlaceErrors> m_ofPhotos;
};

/// Puts together how samplings displace what views show.
class SamplingSummary {
  public:
    void add(const SamplingErrors& errors);

    /// The error with a sampling, from the error that was found with the usual one. Displacements of
    /// samplings are independent of it, so squares add. Nothing if it is not known.
    std::optional<double> errorWith(render::Sampling sampling, render::Sampling usual,
                                    const std::optional<double>& usualPx) const;

  private:
    SamplingErrors m_errors;
};

/// The median distance from places between the photos to the nearest photo, in metres. Places lie evenly,
/// at the photos' mean height, no farther from a photo than the middle of a square of neighbours. It is 0 for
/// a single photo.
double betweenPhotosM(const std::vector<Eigen::Vector3d>& photos);

ShownView shownView(const ViewLikeness& likeness, Places places, const RgbImage& truth, const RgbImage& view);

/// Length in metres of the offset across the camera's axis that displaces things as much as this offset does.
/// Parallax along the axis is small in the middle of the picture and grows towards its edge.
double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis);

/// The median error in pixels that photos which were left out foretell of another view of the same scene
/// model. Nothing if none of them was compared.
///
/// If their views list things, the things in the view's frame count: each error is scaled by the ratio of
/// parallaxes, and things seen from near weigh most. The result is the median over parts of the frame, of
/// the medians in them with scene models that have surfaces, else of the means. With depths, the errors count
/// less, since those of the photos that were left out are estimated, too.
/// Otherwise it is the mean error per metre of offset, times the view's offset. Views that stood near and
/// looked the same way weigh most.
std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                 const CameraModel& camera);

/// One prediction for each scene model that both reports have.
std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot,
                                    const CameraModel& camera);

} // namespace spherewalk::jobs
