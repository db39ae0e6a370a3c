// SPDX-License-Identifier: Apache-2.0
#include "view_options.h"

#include "arrays.h"

#include "spherewalk/base/enum_names.h"

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
                       const py::object& roomDepth, const std::string& alpha) {
    GivenOverlay given;
    given.overlay.depth = depthFrom(depth, "overlay's depth");
    given.overlay.picture = rgbaFrom(picture, given.overlay.depth, "overlay's picture");
    given.overlay.alpha = valueOf(kAlphas, "The alpha", alpha);
    if (!roomDepth.is_none()) {
        given.overlay.roomDepth = depthFrom(roomDepth, "overlay's room_depth");
    }
    if (camera != nullptr) {
        given.overlay.camera = camera->intrinsics();
        given.hasCamera = true;
    }
    return given;
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
            py::init(&optionsOf), py::kw_only(), py::arg("scene") = "auto", py::arg("sampling") = "footprint",
            py::arg("tolerance_db") = 40.0, py::arg("threads") = 0, py::arg("exact") = false,
            py::arg("depth") = false, py::arg("trust") = false, py::arg("without") = py::none(),
            py::arg("correct_colour") = true, py::arg("overlay_tolerance_m") = 0.005,
            py::arg("overlay_tolerance_share") = 0.002, py::arg("overlay_edges") = "soft",
            "scene: for places between photos, \"none\", \"sphere\", \"room\", \"depth\", or \"auto\" (what "
            "the "
            "dataset chose, else the best that it has); sampling: \"nearest\", \"bilinear\", \"reduced\", "
            "\"footprint\", \"bicubic\", or \"auto\" (the cheapest that is expected to be within "
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
        .def(py::init(&overlayOf), py::arg("picture"), py::arg("depth"), py::arg("camera") = py::none(),
             py::arg("room_depth") = py::none(), py::arg("alpha") = "straight",
             "picture: (h, w, 4) uint8, red, green, blue, alpha; or (h, w, 3), which is opaque where there "
             "is a "
             "depth. depth: (h, w) float32 or float64, metres along the optical axis (z, not along the ray); "
             "what "
             "is not finite and above zero is none. camera: what took the picture, else the view's. "
             "room_depth: of "
             "the room as the simulator models it, as depth; else the depth of the view's scene model hides "
             "objects. alpha: \"straight\" or \"premultiplied\". The arrays are copied.");
}

} // namespace spherewalk::python
