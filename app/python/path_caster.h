// SPDX-License-Identifier: Apache-2.0
// Paths as arguments and results, which pybind11 has by itself as of 2.7.
#pragma once

#include <pybind11/pybind11.h>

#if PYBIND11_VERSION_MAJOR > 2 || PYBIND11_VERSION_MINOR >= 7
#include <pybind11/stl/filesystem.h>
#else
#include <filesystem>
#include <string>

namespace pybind11::detail {

template <>
struct type_caster<std::filesystem::path> {
    PYBIND11_TYPE_CASTER(std::filesystem::path, _("os.PathLike"));

    bool load(handle source, bool /*convert*/) {
        PyObject* bytes = nullptr;
        if (PyUnicode_FSConverter(source.ptr(), &bytes) == 0) {
            PyErr_Clear();
            return false;
        }
        value = std::string(reinterpret_steal<pybind11::bytes>(bytes));
        return true;
    }

    static handle cast(const std::filesystem::path& path, return_value_policy /*policy*/, handle /*parent*/) {
        const auto text = reinterpret_steal<object>(PyUnicode_DecodeFSDefault(path.c_str()));
        return module_::import("pathlib").attr("Path")(text).release();
    }
};

} // namespace pybind11::detail
#endif
