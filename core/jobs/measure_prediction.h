// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/measure_report.h"

namespace spherewalk::jobs {

/// How far a camera must be moved across its axis to displace things as much as this offset does: parallax
/// along the axis is small in the middle of the picture and grows towards its edge.
double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis);

/// What views of photos that were left out foretell of the median error of another view of the same scene
/// model. Where they say which things are off: the weighted median of those that the view has in its frame,
/// each in proportion to the parallax between the view and its photo; things that were seen from near the
/// view count most. Otherwise the mean over the views, those that stood near and looked the same way
/// counting most, of their errors per offset, times the view's offset. Nothing if none was compared.
std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                 const CameraModel& camera);

/// One a scene model that both have.
std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot,
                                    const CameraModel& camera);

} // namespace spherewalk::jobs
