// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/render/dataset.h"

#include <memory>
#include <pybind11/pybind11.h>

namespace spherewalk::python {

/// A dataset, and whether the hashes of its photos were compared when it was opened.
struct OpenDataset {
    std::shared_ptr<const render::Dataset> dataset;
    bool isVerified = false;
};

void bindDatasets(pybind11::module_& module);

} // namespace spherewalk::python
