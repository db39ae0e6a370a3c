// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/view.h"

#include <cmath>
#include <pybind11/stl.h>

namespace spherewalk::python {

namespace {

using render::Alpha;
using render::Edges;
using render::Overlay;
using render::ViewOptions;

constexpr EnumNames<Alpha, 2> kAlphas{
    {{Alpha::Straight, "straight"}, {Alpha::Premultiplied, "premultiplied"}}};
constexpr EnumNames<Edges, 2> kEdges{{{Edges::Soft, "soft"}, {Edges::Hard, "hard"}}};
constexpr int kMostThreads = 4096;

ViewOptions optionsOf(const std::string& scene, const std::string& sampling, double toleranceDb, int threads,
                      bool exact, bool depth, bool trust, std::optional<std::size_t> without,
                      bool correctColour, double overlayToleranceM, double overlayToleranceShare,
                      const std::string& overlayEdges) {
    if (threads < 0 || threads > kMostThreads || !std::isfinite(toleranceDb)) {
        throw Error(ErrorKind::InvalidInput, text("A view is made by 0 (all) to ", kMostThreads,
                                                  " threads, with a finite tolerance_db; these are ", threads,
                                                  " and ", toleranceDb, "."));
    }
    ViewOptions options;
    if (scene != "auto") {
        options.scene = render::sceneKind(scene);
    }
    options.sampling = render::sampling(sampling);
    options.toleranceDb = toleranceDb;
    options.threads = threads;
    options.exact = exact;
    options.wantsDepth = depth;
    options.wantsTrust = trust;
    options.without = without;
    options.correctsColour = correctColour;
    options.compose = {overlayToleranceM, overlayToleranceShare,
                       valueOf(kEdges, "The edges of overlays", overlayEdges)};
    return options;
}

/// An overlay whose camera is the view's if it has none.
struct GivenOverlay {
    Overlay overlay;
    bool hasCamera = false;
};

GivenOverlay overlayOf(const py::object& picture, const py::object& depth, const CameraModel* camera,
                       const py::object& roomDepth, const std::string& alpha, const py::object& shadow) {
    GivenOverlay given;
    given.overlay.depth = depthFrom(depth, "overlay's depth");
    given.overlay.picture = rgbaFrom(picture, given.overlay.depth, "overlay's picture");
    given.overlay.alpha = valueOf(kAlphas, "The alpha", alpha);
    if (!roomDepth.is_none()) {
        given.overlay.roomDepth = depthFrom(roomDepth, "overlay's room_depth");
    }
    if (!shadow.is_none()) {
        given.overlay.shadow = sharesFrom(shadow, "overlay's shadow");
    }
    if (camera != nullptr) {
        given.overlay.camera = camera->intrinsics();
        given.hasCamera = true;
    }
    return given;
}

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
            "By how many pixels things are displaced: the median over the view of what the evidence says.")
        .def_readonly("outside", &ViewReport::isOutside,
                      "The camera is outside of what was scanned; the trust is then 0.")
        .def_readonly("sees_place", &ViewReport::seesPlace,
                      "The photos see the camera's place. If none does, the nearest ones are shown.")
        .def_readonly("seen_share", &ViewReport::seenShare,
                      "Of the pixels, that are neither filled nor unsure.")
        .def_readonly("filled_share", &ViewReport::filledShare,
                      "Of the pixels, that had to come from another photo.")
        .def_readonly("blur_px", &ViewReport::blurPx, "Of a thumbnail.")
        .def_readonly(
            "trust", &ViewReport::trust,
            "1 / (1 + parallax_px + blur_px): 1 at a photo's own place, 0.5 with one pixel in doubt, 0 where "
            "nothing is known.")
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

std::vector<Overlay> overlaysFrom(const py::object& overlays, const CameraIntrinsics& camera) {
    std::vector<Overlay> result;
    for (const py::handle& item : overlays) {
        if (!py::isinstance<GivenOverlay>(item)) {
            throw py::type_error(
                text("Overlays must be spherewalk.Overlay, not ", Py_TYPE(item.ptr())->tp_name, "."));
        }
        const auto& given = item.cast<const GivenOverlay&>();
        result.push_back(given.overlay);
        if (!given.hasCamera) {
            result.back().camera = camera;
        }
    }
    return result;
}

void bindViewOptions(py::module_& module) {
    py::class_<ViewOptions>(module, "ViewOptions", "How views are made. Immutable; use it for many views.")
        .def(
            py::init(&optionsOf), py::kw_only(), py::arg("scene") = "auto", py::arg("sampling") = "best",
            py::arg("tolerance_db") = 40.0, py::arg("threads") = 0, py::arg("exact") = false,
            py::arg("depth") = false, py::arg("trust") = false, py::arg("without") = py::none(),
            py::arg("correct_colour") = true, py::arg("overlay_tolerance_m") = 0.005,
            py::arg("overlay_tolerance_share") = 0.002, py::arg("overlay_edges") = "soft",
            "scene: for places between photos, \"none\", \"sphere\", \"room\", \"depth\", or \"auto\" (what "
            "the "
            "dataset chose, else the best that it has); sampling: \"nearest\", \"bilinear\", \"reduced\", "
            "\"footprint\", \"bicubic\", \"best\" (bicubic where the photo is magnified, else footprint), or "
            "\"auto\" (the cheapest that is expected to be within "
            "tolerance_db); "
            "threads: 0 for all that the machine has, the pixels are the same for any number; exact: every "
            "pixel "
            "by itself in double precision, a hundred times slower; depth, trust: View.depth, and "
            "View.trust, "
            "error_px and flags are wanted; without: a photo that is not to be used; correct_colour: as the "
            "dataset says, False: the photos' own colours; overlay_...: how far an object may lie behind the "
            "room's surface and still be shown, the larger of metres and share of the room's depth, and "
            "whether "
            "the borders of what is hidden are \"soft\" or \"hard\".");
    py::class_<GivenOverlay>(
        module, "Overlay",
        "Objects as a simulator renders them, to be laid into views from the view's own pose.")
        .def(
            py::init(&overlayOf), py::arg("picture"), py::arg("depth"), py::arg("camera") = py::none(),
            py::arg("room_depth") = py::none(), py::arg("alpha") = "straight", py::arg("shadow") = py::none(),
            "picture: (h, w, 4) uint8, red, green, blue, alpha; or (h, w, 3), which is opaque where there "
            "is a "
            "depth. depth: (h, w) float32 or float64, metres along the optical axis (z, not along the ray); "
            "what "
            "is not finite and above zero is none. camera: what took the picture, else the view's. "
            "room_depth: of "
            "the room as the simulator models it, as depth; else the depth of the view's scene model hides "
            "objects. alpha: \"straight\" or \"premultiplied\". shadow: (h, w), the share of light that the "
            "objects leave to what the photos show, float from 0 to 1 or uint8 from 0 to 255; else they cast "
            "no shadow. The arrays are copied.");
}

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
        flags["FILLED"] = static_cast<int>(PixelFlag::Filled);
        flags["UNSURE"] = static_cast<int>(PixelFlag::Unsure);
        return flags;
    }();
}

} // namespace spherewalk::python
