// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include "spherewalk/base/error.h"

#include <pybind11/pybind11.h>

namespace spherewalk::python {

namespace py = pybind11;

namespace {

void raise(const Error& error) {
    const py::object ofKind = py::module_::import("spherewalk._errors").attr("of_kind");
    const py::object raised = ofKind(py::str(std::string(name(error.kind()))), error.sentence());
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

} // namespace

void translateErrors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            std::rethrow_exception(pointer);
        } catch (const Error& error) {
            raise(error);
        }
    });
}

} // namespace spherewalk::python
