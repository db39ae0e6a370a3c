// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/render/view.h"

#include <pybind11/pybind11.h>
#include <vector>

namespace spherewalk::python {

/// The overlays of an iterable; their camera is the view's where they have none.
std::vector<render::Overlay> overlaysFrom(const pybind11::object& overlays, const CameraIntrinsics& camera);

void bindViewOptions(pybind11::module_& module);

} // namespace spherewalk::python
