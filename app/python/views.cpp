// SPDX-License-Identifier: Apache-2.0
#include "views.h"

#include "arrays.h"

#include "spherewalk/base/text.h"
#include "spherewalk/render/view.h"

namespace spherewalk::python {

namespace {

using render::PixelFlag;
using render::View;
using render::ViewReport;

/// A member of a view as an array that shares its memory; None where it is empty, since it was not asked for.
template <class Picture>
auto arrayOf(Picture member) {
    return [member](const py::object& self) -> py::object {
        auto& picture = std::invoke(member, self.cast<View&>());
        if (picture.empty()) {
            return py::none();
        }
        return sharedArray(picture, self);
    };
}

py::object trustOf(const View& view) {
    const Image<float, 1>& error = view.trust.errorPx;
    if (error.empty()) {
        return py::none();
    }
    py::array_t<float> trust({error.height(), error.width()});
    std::transform(error.values().begin(), error.values().end(), trust.mutable_data(), render::trust);
    return trust;
}

template <class Named>
auto nameOf(Named ViewReport::*member) {
    return [member](const ViewReport& self) { return std::string(render::name(self.*member)); };
}

void bindReport(py::module_& module) {
    py::class_<ViewReport>(module, "ViewReport", "What a view was made from, and how far it can be trusted.")
        .def_readonly("photo", &ViewReport::photo, "Index into Dataset.photos.")
        .def_readonly("file", &ViewReport::file, "Of the photo.")
        .def_property_readonly("scene", nameOf(&ViewReport::scene), "The scene model that was used.")
        .def_property_readonly("sampling", nameOf(&ViewReport::sampling), "That was used, never \"auto\".")
        .def_property_readonly(
            "origin", nameOf(&ViewReport::origin),
            "\"photo\"; \"thumbnail\" or \"previous\" where a stream's photo was not decoded yet.")
        .def_readonly("late", &ViewReport::isLate, "Something was not in memory when it was asked for.")
        .def_readonly("offset_m", &ViewReport::offsetM, "Between the camera and the photo.")
        .def_readonly(
            "parallax_px", &ViewReport::parallaxPx,
            "By how much a thing at half or twice the distance that the scene model assumes would be "
            "displaced at the picture's centre.")
        .def_readonly("filled_share", &ViewReport::filledShare,
                      "Of the pixels, that had to come from another photo.")
        .def_readonly("blur_px", &ViewReport::blurPx, "Of a thumbnail.")
        .def_readonly(
            "trust", &ViewReport::trust,
            "1 / (1 + parallax_px + blur_px): 1 at a photo's own place, 0.5 with one pixel in doubt.")
        .def_readonly("decode_ms", &ViewReport::decodeMs, "Waiting for the photo to be decoded.")
        .def_readonly("decoded_tiles", &ViewReport::decodedTiles, "That it waited for.")
        .def_readonly("whole_decode", &ViewReport::isWholeDecode, "The photo has no restart markers.")
        .def_readonly("verified", &ViewReport::isVerified, "The photo's hash is that of dataset.json.")
        .def_readonly("render_ms", &ViewReport::renderMs)
        .def("__repr__", [](const ViewReport& self) {
            return text("<spherewalk.ViewReport ", printable(self.file), ", ", fixed(100 * self.offsetM, 1),
                        " cm away, scene ", render::name(self.scene), ", trust ", fixed(self.trust, 2), ">");
        });
}

} // namespace

void bindViews(py::module_& module) {
    bindReport(module);
    py::class_<View>(module, "View",
                     "One image of a camera. Its arrays share its memory; None: not asked for.")
        .def_property_readonly(
            "picture", arrayOf(&View::picture),
            "Red, green, blue; black where the lens sees nothing. Shape: (height, width, 3) uint8.")
        .def_property_readonly("depth", arrayOf(&View::depth),
                               "Of the scene model without overlays: metres along the optical axis (z), inf "
                               "where there is none. Shape: "
                               "(height, width) float32; None with the scene model \"none\".")
        .def_property_readonly(
            "trust", &trustOf,
            "1 / (1 + error_px), 0 where the lens sees nothing. Shape: (height, width) float32.")
        .def_property_readonly(
            "error_px", arrayOf([](View & view) -> auto& { return view.trust.errorPx; }),
            "By how many pixels what is shown may be off its place. Shape: (height, width) float32.")
        .def_property_readonly("flags", arrayOf([](View & view) -> auto& { return view.trust.flags; }),
                               "Bits of PixelFlag. Shape: (height, width) uint8.")
        .def_property_readonly(
            "overlaid", arrayOf(&View::overlaid),
            "How much of each pixel overlays cover, 255 for all of it. Shape: (height, width) uint8.")
        .def_readonly("report", &View::report)
        .def("__repr__", [](const View& self) {
            return text("<spherewalk.View ", self.picture.width(), " x ", self.picture.height(), " from ",
                        printable(self.report.file), ">");
        });
    module.attr("pixel_flags") = [] {
        py::dict flags;
        flags["UNSEEN"] = static_cast<int>(PixelFlag::Unseen);
        flags["POLE"] = static_cast<int>(PixelFlag::Pole);
        flags["STITCHING"] = static_cast<int>(PixelFlag::Stitching);
        flags["SEAM"] = static_cast<int>(PixelFlag::Seam);
        flags["COARSE"] = static_cast<int>(PixelFlag::Coarse);
        flags["OVERLAY"] = static_cast<int>(PixelFlag::Overlay);
        return flags;
    }();
}

} // namespace spherewalk::python
