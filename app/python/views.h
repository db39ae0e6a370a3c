// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace spherewalk::python {

/// Views and their reports.
void bindViews(pybind11::module_& module);

} // namespace spherewalk::python
