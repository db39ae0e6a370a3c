// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "path_caster.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/camera_info.h"

#include <limits>

namespace spherewalk::python {

namespace {

LensModel lensModel(std::string_view lens) {
    static const auto kNames = [] {
        EnumNames<LensModel, 4> names;
        constexpr std::array kLenses{LensModel::Pinhole, LensModel::PlumbBob, LensModel::RationalPolynomial,
                                     LensModel::Equidistant};
        std::transform(kLenses.begin(), kLenses.end(), names.begin(),
                       [](LensModel model) { return std::pair(model, name(model)); });
        return names;
    }();
    return valueOf(kNames, "The lens model", lens);
}

CameraModel fromMatrix(int width, int height, const py::object& matrix, const py::object& distortion,
                       const std::string& lens) {
    const Numbers k = numbersFrom(matrix, "camera matrix K");
    if (k.ndim() != 2 || k.shape(0) != 3 || k.shape(1) != 3) {
        throw Error(ErrorKind::InvalidInput,
                    text("The camera matrix K has the shape ", shapeText(k), "; it must be (3, 3)."));
    }
    if (k.at(0, 1) != 0 || k.at(1, 0) != 0 || k.at(2, 0) != 0 || k.at(2, 1) != 0 || k.at(2, 2) != 1) {
        throw Error(ErrorKind::InvalidInput,
                    "The camera matrix K must be fx 0 cx, 0 fy cy, 0 0 1: cameras have no skew here.");
    }
    const Numbers d = numbersFrom(distortion, "distortion");
    return CameraModel({width, height, k.at(0, 0), k.at(1, 1), k.at(0, 2), k.at(1, 2), lensModel(lens),
                        std::vector<double>(d.data(), d.data() + d.size())});
}

py::array_t<double> cameraMatrixOf(const CameraModel& camera) {
    const CameraIntrinsics& c = camera.intrinsics();
    const std::array<double, 9> values{c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1};
    return py::array_t<double>({3, 3}, values.data());
}

/// What `map` makes of each row of kIn numbers; rows of NaN where that is nothing.
template <int kIn, int kOut, class Map>
py::array_t<double> mappedRows(const py::object& rows, std::string_view what, const Map& map) {
    const Numbers in = numbersFrom(rows, what);
    if (in.ndim() < 1 || in.shape(in.ndim() - 1) != kIn) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ", what, " have the shape ", shapeText(in), "; it must be (..., ", kIn, ")."));
    }
    std::vector<py::ssize_t> shape(in.shape(), in.shape() + in.ndim());
    shape.back() = kOut;
    py::array_t<double> out(shape);
    using In = Eigen::Matrix<double, kIn, 1>;
    using Out = Eigen::Matrix<double, kOut, 1>;
    for (py::ssize_t i = 0; i < in.size() / kIn; ++i) {
        const std::optional<Out> mapped = map(In(Eigen::Map<const In>(in.data() + i * kIn)));
        Eigen::Map<Out>(out.mutable_data() + i * kOut) =
            mapped.value_or(Out::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    return out;
}

std::string described(const CameraModel& camera) {
    const CameraIntrinsics& c = camera.intrinsics();
    return text("<spherewalk.Camera ", c.width, " x ", c.height, ", fx ", c.fx, ", fy ", c.fy, ", cx ", c.cx,
                ", cy ", c.cy, ", ", name(c.lens), ">");
}

py::dict readRigFile(const std::filesystem::path& file) {
    py::dict cameras;
    for (const render::RigCamera& camera : render::readRig(file)) {
        const py::object pose =
            camera.rigFromOptical ? py::object(matrixOf(*camera.rigFromOptical)) : py::object(py::none());
        cameras[py::str(camera.name)] = py::make_tuple(CameraModel(camera.camera), pose);
    }
    return cameras;
}

void bindProperties(py::class_<CameraModel>& camera) {
    camera.def_property_readonly("width", &CameraModel::width, "Pixels.")
        .def_property_readonly("height", &CameraModel::height, "Pixels.")
        .def_property_readonly("K", &cameraMatrixOf,
                               "fx 0 cx, 0 fy cy, 0 0 1, pixels. Shape: (3, 3), a copy.")
        .def_property_readonly(
            "distortion",
            [](const CameraModel& self) {
                const std::vector<double>& d = self.intrinsics().distortion;
                return py::array_t<double>(static_cast<py::ssize_t>(d.size()), d.data());
            },
            "The lens model's parameters. Shape: (n,), a copy.")
        .def_property_readonly(
            "lens", [](const CameraModel& self) { return std::string(name(self.intrinsics().lens)); },
            "\"none\", \"plumb_bob\", \"rational_polynomial\" or \"equidistant\", as ROS calls them.")
        .def("__repr__", &described)
        .def("__eq__", [](const CameraModel& self, const py::object& other) {
            return py::isinstance<CameraModel>(other) &&
                   self.intrinsics() == other.cast<const CameraModel&>().intrinsics();
        });
    camera.attr("__hash__") = py::none();
}

} // namespace

void bindCameras(py::module_& module) {
    py::class_<CameraModel> camera(module, "Camera",
                                   "A robot's camera: intrinsic parameters as ROS camera_info and OpenCV "
                                   "have them. The centre of pixel (0, "
                                   "0) has the coordinates (0, 0). Immutable.");
    camera
        .def(py::init(&fromMatrix), py::arg("width"), py::arg("height"), py::arg("K"),
             py::arg("distortion") = py::tuple(), py::arg("lens") = "none",
             "K: (3, 3); distortion: as many numbers as the lens model has: plumb_bob k1 k2 p1 p2 k3, "
             "rational_polynomial k1 k2 p1 p2 k3 k4 k5 k6 and, if wanted, s1 s2 s3 s4 and two tilts, "
             "equidistant k1 k2 k3 k4.")
        .def_static(
            "pinhole",
            [](int width, int height, double fov) {
                return CameraModel(CameraIntrinsics::pinhole(width, height, fov));
            },
            py::arg("width"), py::arg("height"), py::arg("horizontal_fov_rad"),
            "A camera without distortion whose axis meets the picture's centre.")
        .def_static(
            "read",
            [](const std::filesystem::path& file) { return CameraModel(render::readCameraInfo(file)); },
            py::arg("file"), "The camera that a ROS camera-info YAML describes.")
        .def(
            "to_yaml",
            [](const CameraModel& self, const std::string& cameraName) {
                return render::cameraInfoYaml(self.intrinsics(), cameraName);
            },
            py::arg("name") = "camera", "A ROS camera-info YAML of this camera.")
        .def(
            "rays",
            [](const CameraModel& self, const py::object& pixels) {
                return mappedRows<2, 3>(pixels, "pixels",
                                        [&](const Eigen::Vector2d& pixel) { return self.ray(pixel); });
            },
            py::arg("pixels"),
            "The unit directions, in the optical frame, that land on pixels (x, y); NaN where the lens sees "
            "nothing. Shape: (..., 2) to (..., 3).")
        .def(
            "project",
            [](const CameraModel& self, const py::object& points) {
                return mappedRows<3, 2>(points, "points",
                                        [&](const Eigen::Vector3d& point) { return self.project(point); });
            },
            py::arg("points"),
            "The pixels (x, y), inside of the picture or not, on which points of the optical frame land; NaN "
            "for "
            "what the lens cannot see. Shape: (..., 3) to (..., 2).");
    bindProperties(camera);
    module.def(
        "read_rig", &readRigFile, py::arg("file"),
        "The cameras of a rig's YAML by name, in the file's order: a camera and rig_from_camera of its "
        "optical frame, (4, 4), which is None where the file leaves it to tf. A camera's pose is the "
        "rig's times that: room_from_rig @ rig_from_camera.");
}

} // namespace spherewalk::python
