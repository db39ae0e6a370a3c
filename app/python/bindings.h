// SPDX-License-Identifier: Apache-2.0
// What the sources of the Python module share: arrays and poses between NumPy and the library, and one
// function a source that declares its classes.
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/view.h"

#include <memory>
#include <pybind11/numpy.h>
#include <string>
#include <string_view>
#include <vector>

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

/// The real, finite numbers of anything that NumPy makes an array of. what: a name of the values, for the
/// sentence. Errors: InvalidInput.
Numbers numbersFrom(const py::object& values, std::string_view what);

/// The shape as NumPy writes it: "(480, 640, 3)".
std::string shapeText(const py::array& array);

/// A copy of the pixels of an array of uint8. Shape: (height, width, 3 or 4), with any strides. Where the
/// array has no alpha, alpha is 255 at pixels whose depth is finite and above zero, and 0 elsewhere. Errors:
/// InvalidInput for another type or shape, or a depth of another size.
RgbaImage rgbaFrom(const py::object& array, const DepthImage& depth, std::string_view what);

/// A copy of an array of float32 or float64 with any values. Shape: (height, width). Errors: InvalidInput.
DepthImage depthFrom(const py::object& array, std::string_view what);

/// A copy of an array of shares: float32 or float64 as they are, or uint8, of which 255 is 1. Shape: (height,
/// width). Errors: InvalidInput.
Image<float, 1> sharesFrom(const py::object& array, std::string_view what);

/// The pose of the optical frame. pose: a matrix of shape (4, 4), or the seven numbers x y z qx qy qz qw.
/// frame: "optical" or "body", the frame whose pose the array is. Errors: InvalidInput.
Rigid3 opticalPose(const py::object& pose, std::string_view frame);

/// The same for several poses. Shape: (n, 4, 4) or (n, 7).
std::vector<Rigid3> opticalPoses(const py::object& poses, std::string_view frame);

/// The homogeneous matrix of the pose. Shape: (4, 4).
py::array_t<double> matrixOf(const Rigid3& pose);

/// A dataset, and whether the hashes of its photos were compared when it was opened.
struct OpenDataset {
    std::shared_ptr<const render::Dataset> dataset;
    bool isVerified = false;
};

/// The overlays of an iterable. An overlay without a camera gets the view's.
std::vector<render::Overlay> overlaysFrom(const py::object& overlays, const CameraIntrinsics& camera);

void bindPoses(py::module_& module);
void bindCameras(py::module_& module);
void bindDatasets(py::module_& module);
/// Declares the options of views, and overlays.
void bindViewOptions(py::module_& module);
/// Declares views and their reports.
void bindViews(py::module_& module);
/// Declares renderers and streams of views.
void bindRenderers(py::module_& module);

} // namespace spherewalk::python
