// SPDX-License-Identifier: Apache-2.0
#include "cameras.h"
#include "datasets.h"
#include "errors.h"
#include "poses.h"
#include "renderers.h"
#include "view_options.h"
#include "views.h"

#include "spherewalk/render/simd_target.h"

PYBIND11_MODULE(_core, module) {
    using namespace spherewalk::python;
    module.doc() = "The render library of Spherewalk; use the package spherewalk, which shows all of it.";
    module.attr("__version__") = SPHEREWALK_VERSION;
    translateErrors();
    bindPoses(module);
    bindCameras(module);
    bindDatasets(module);
    bindViewOptions(module);
    bindViews(module);
    bindRenderers(module);
    module.def(
        "simd_target", &spherewalk::render::simdTarget,
        "The processor's instructions that views are made with on this machine; the pixels are the same "
        "with any.");
}
