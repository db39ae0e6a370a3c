// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/measure_report.h"

namespace spherewalk::jobs {

/// How far a camera must be moved across its axis to displace things as much as this offset does: parallax
/// along the axis is small in the middle of the picture and grows towards its edge.
double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis);

/// What views of photos that were left out foretell of the median error of another view of the same scene
/// model: the mean over the nearest of them, those that look the same way counting most, of their errors per
/// offset, times the view's offset. Nothing if none was compared.
std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view);

/// One a scene model that both have.
std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot);

} // namespace spherewalk::jobs
