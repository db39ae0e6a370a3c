// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"

#include "spherewalk/base/error.h"
#include "spherewalk/render/renderer.h"

namespace spherewalk::python {

namespace {

void raise(const Error& error) {
    const py::object ofKind = py::module_::import("spherewalk._errors").attr("of_kind");
    const py::object raised = ofKind(py::str(std::string(name(error.kind()))), error.sentence());
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

/// From here on, a spherewalk::Error that leaves a function of the module becomes the exception that
/// spherewalk/_errors.py has for its kind, with the same sentence.
void translateErrors() {
#if PYBIND11_VERSION_MAJOR > 2 || PYBIND11_VERSION_MINOR >= 8
    constexpr auto translate = [](auto translator) { py::register_local_exception_translator(translator); };
#else // for all modules of the interpreter, which throw no spherewalk::Error
    constexpr auto translate = [](auto translator) { py::register_exception_translator(translator); };
#endif
    translate([](std::exception_ptr pointer) {
        try {
            std::rethrow_exception(pointer);
        } catch (const Error& error) {
            raise(error);
        }
    });
}

} // namespace

} // namespace spherewalk::python

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
