// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"

#include <pybind11/numpy.h>
#include <string>
#include <string_view>
#include <vector>

/// NumPy arrays as pictures and numbers, and back.
namespace spherewalk::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style>;

/// The picture's own memory as an array of shape (height, width), and channels if there are several. Owner:
/// `owner`, which the array keeps alive, must keep the picture where it is.
template <class Value, int kChannels>
py::array sharedArray(Image<Value, kChannels>& picture, const py::object& owner) {
    std::vector<py::ssize_t> shape{picture.height(), picture.width()};
    if constexpr (kChannels > 1) {
        shape.push_back(kChannels);
    }
    return py::array_t<Value>(shape, picture.values().data(), owner);
}

/// Real, finite numbers of whatever NumPy makes an array of. what: it is, for the sentence. Errors:
/// InvalidInput.
Numbers numbersFrom(const py::object& values, std::string_view what);

/// The shape as NumPy writes it: "(480, 640, 3)".
std::string shapeText(const py::array& array);

/// The pixels of an array of uint8 of shape (height, width, channels), with any strides: a copy. Of red,
/// green and blue alone, alpha is 255 where the depth is finite and above zero, and 0 elsewhere. Errors:
/// InvalidInput for another type or shape, or a depth of another size.
RgbaImage rgbaFrom(const py::object& array, const DepthImage& depth, std::string_view what);

/// The same of float32 or float64 of shape (height, width); any values.
DepthImage depthFrom(const py::object& array, std::string_view what);

} // namespace spherewalk::python
