// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arrays.h"

#include "spherewalk/geometry/rigid3.h"

#include <string_view>
#include <vector>

namespace spherewalk::python {

/// The pose of the optical frame that an array stands for: a matrix of shape (4, 4), or the seven numbers x y
/// z qx qy qz qw. frame: that the array is the pose of, "optical" or "body". Errors: InvalidInput.
Rigid3 opticalPose(const py::object& pose, std::string_view frame);

/// The same for each of several, of shape (n, 4, 4) or (n, 7).
std::vector<Rigid3> opticalPoses(const py::object& poses, std::string_view frame);

/// Shape: (4, 4).
py::array_t<double> matrixOf(const Rigid3& pose);

void bindPoses(py::module_& module);

} // namespace spherewalk::python
