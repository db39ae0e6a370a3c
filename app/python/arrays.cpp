// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::python {

namespace {

constexpr py::ssize_t kMostPixels = 32768; ///< along a side, as a camera's

[[noreturn]] void refuse(std::string_view what, const std::string& why) {
    throw Error(ErrorKind::InvalidInput, text("The ", what, " ", why));
}

/// "uint8", or what it is instead of an array.
std::string typeText(const py::object& value) {
    return py::isinstance<py::array>(value) ? py::str(value.attr("dtype")).cast<std::string>()
                                            : text("a ", Py_TYPE(value.ptr())->tp_name);
}

/// Nothing for what is no array. What else was raised meanwhile, Ctrl-C for one, is the caller's.
std::optional<py::array> arrayFrom(const py::object& values) {
    try {
        return py::array(values);
    } catch (const py::error_already_set& raised) {
        if (raised.matches(PyExc_TypeError) || raised.matches(PyExc_ValueError)) {
            return std::nullopt;
        }
        throw;
    }
}

py::array pixelsOf(const py::object& value, std::string_view types, bool hasType, std::string_view what) {
    if (!hasType) {
        refuse(what, text("must be a NumPy array of ", types, "; it is ", typeText(value), "."));
    }
    py::array array = py::reinterpret_borrow<py::array>(value);
    for (py::ssize_t axis = 0; axis < std::min<py::ssize_t>(2, array.ndim()); ++axis) {
        if (array.shape(axis) < 1 || array.shape(axis) > kMostPixels) {
            refuse(what, text("has the shape ", shapeText(array), "; height and width must be 1 to ",
                              kMostPixels, "."));
        }
    }
    return array;
}

template <class Value>
bool isArrayOf(const py::object& value) {
    return py::isinstance<py::array_t<Value>>(value);
}

/// Range: an array of this type, which no cast copies.
template <class Value>
DepthImage depthOf(const py::array& array) {
    const auto values = array.cast<py::array_t<Value>>().template unchecked<2>();
    DepthImage depth(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    for (int y = 0; y < depth.height(); ++y) {
        float* const row = depth.at(0, y);
        for (int x = 0; x < depth.width(); ++x) {
            row[x] = static_cast<float>(values(y, x));
        }
    }
    return depth;
}

} // namespace

std::string shapeText(const py::array& array) {
    return py::str(array.attr("shape")).cast<std::string>();
}

Numbers numbersFrom(const py::object& values, std::string_view what) {
    const std::optional<py::array> converted = arrayFrom(values);
    constexpr std::string_view kRealKinds = "iuf";
    if (!converted || kRealKinds.find(converted->dtype().kind()) == std::string_view::npos) {
        refuse(what, text("must be real numbers; it is ",
                          typeText(converted ? py::object(*converted) : values), "."));
    }
    const py::array& array = *converted;
    const Numbers numbers = py::cast<py::array_t<double, py::array::c_style | py::array::forcecast>>(array);
    if (!std::all_of(numbers.data(), numbers.data() + numbers.size(),
                     [](double number) { return std::isfinite(number); })) {
        refuse(what, "has values that are not finite.");
    }
    return numbers;
}

RgbaImage rgbaFrom(const py::object& value, const DepthImage& depth, std::string_view what) {
    const py::array array = pixelsOf(value, "uint8", isArrayOf<std::uint8_t>(value), what);
    const py::ssize_t channels = array.ndim() == 3 ? array.shape(2) : 0;
    if (channels != 3 && channels != 4) {
        refuse(what, text("has the shape ", shapeText(array), "; it must be (height, width, 4) or (.., 3)."));
    }
    if (array.shape(0) != depth.height() || array.shape(1) != depth.width()) {
        refuse(what, text("has the shape ", shapeText(array), " and its depth (", depth.height(), ", ",
                          depth.width(), "); they must have the same height and width."));
    }
    const auto pixels = array.cast<py::array_t<std::uint8_t>>().unchecked<3>();
    RgbaImage picture(depth.width(), depth.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            std::uint8_t* const pixel = picture.at(x, y);
            const float z = *depth.at(x, y);
            pixel[3] = std::isfinite(z) && z > 0 ? 255 : 0;
            for (py::ssize_t c = 0; c < channels; ++c) {
                pixel[c] = pixels(y, x, c);
            }
        }
    }
    return picture;
}

DepthImage depthFrom(const py::object& value, std::string_view what) {
    const bool isSingle = isArrayOf<float>(value);
    const py::array array = pixelsOf(value, "float32 or float64", isSingle || isArrayOf<double>(value), what);
    if (array.ndim() != 2) {
        refuse(what, text("has the shape ", shapeText(array), "; it must be (height, width)."));
    }
    return isSingle ? depthOf<float>(array) : depthOf<double>(array);
}

Image<float, 1> sharesFrom(const py::object& value, std::string_view what) {
    const bool isBytes = isArrayOf<std::uint8_t>(value);
    const bool isSingle = isArrayOf<float>(value);
    const bool hasType = isBytes || isSingle || isArrayOf<double>(value);
    const py::array array = pixelsOf(value, "uint8, float32 or float64", hasType, what);
    if (array.ndim() != 2) {
        refuse(what, text("has the shape ", shapeText(array), "; it must be (height, width)."));
    }
    if (!isBytes) {
        return isSingle ? depthOf<float>(array) : depthOf<double>(array);
    }
    Image<float, 1> shares = depthOf<std::uint8_t>(array);
    std::transform(shares.values().begin(), shares.values().end(), shares.values().begin(),
                   [](float share) { return share / 255; });
    return shares;
}

} // namespace spherewalk::python
