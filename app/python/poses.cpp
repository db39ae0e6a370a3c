// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "path_caster.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/geometry/trajectory.h"

namespace spherewalk::python {

namespace {

enum class Frame { Optical, Body };
constexpr EnumNames<Frame, 2> kFrames{{{Frame::Optical, "optical"}, {Frame::Body, "body"}}};

using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// Which of the two ways the last dimensions of poses are written in.
enum class Form { Matrix, PositionQuaternion };

Form formOf(const Numbers& numbers, py::ssize_t leading) {
    const py::ssize_t own = numbers.ndim() - leading;
    if (own == 2 && numbers.shape(leading) == 4 && numbers.shape(leading + 1) == 4) {
        return Form::Matrix;
    }
    if (own == 1 && numbers.shape(leading) == 7) {
        return Form::PositionQuaternion;
    }
    const std::string_view many = leading > 0 ? "n, " : "";
    throw Error(ErrorKind::InvalidInput,
                text("The ", leading > 0 ? "poses have" : "pose has", " the shape ", shapeText(numbers),
                     "; give matrices, (", many, "4, 4), or x y z qx qy qz qw, (", many,
                     leading > 0 ? "7)." : "7,)."));
}

Rigid3 fromMatrix(const double* values) {
    constexpr double kTolerance = 1e-3; // as isPose()
    const RowMajor4 m = Eigen::Map<const RowMajor4>(values);
    const Eigen::Matrix3d rotation = m.topLeftCorner<3, 3>();
    const bool isRotation =
        (rotation * rotation.transpose()).isIdentity(kTolerance) && rotation.determinant() > 0;
    if (!isRotation || !m.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), kTolerance)) {
        throw Error(
            ErrorKind::InvalidInput,
            "The pose's matrix is not a rotation and a translation above 0 0 0 1; check that it is not "
            "transposed, scaled or mirrored.");
    }
    return {Eigen::Quaterniond(rotation).normalized(), m.topRightCorner<3, 1>()};
}

Rigid3 optical(const double* values, Form form, Frame frame) {
    const Rigid3 given =
        form == Form::Matrix
            ? fromMatrix(values)
            : Rigid3{checkedQuaternion(values[6], values[3], values[4], values[5], "the pose"),
                     {values[0], values[1], values[2]}};
    return frame == Frame::Body ? given * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()} : given;
}

py::tuple readTumFile(const std::filesystem::path& file) {
    const std::vector<TimedPose> path = readTum(file);
    const auto count = static_cast<py::ssize_t>(path.size());
    py::array_t<double> times(count);
    py::array_t<double> poses({count, py::ssize_t{4}, py::ssize_t{4}});
    for (std::size_t i = 0; i < path.size(); ++i) {
        times.mutable_data()[i] = path[i].timeS;
        const py::array_t<double> matrix = matrixOf(path[i].roomFromCamera);
        std::copy_n(matrix.data(), 16, poses.mutable_data(static_cast<py::ssize_t>(i)));
    }
    return py::make_tuple(times, poses);
}

} // namespace

Rigid3 opticalPose(const py::object& pose, std::string_view frame) {
    const Numbers numbers = numbersFrom(pose, "pose");
    return optical(numbers.data(), formOf(numbers, 0), valueOf(kFrames, "The frame", frame));
}

std::vector<Rigid3> opticalPoses(const py::object& poses, std::string_view frame) {
    const Numbers numbers = numbersFrom(poses, "poses");
    const Form form = formOf(numbers, 1);
    const Frame of = valueOf(kFrames, "The frame", frame);
    std::vector<Rigid3> result;
    for (py::ssize_t i = 0; i < numbers.shape(0); ++i) {
        result.push_back(optical(numbers.data(i), form, of));
    }
    return result;
}

py::array_t<double> matrixOf(const Rigid3& pose) {
    py::array_t<double> matrix({4, 4});
    Eigen::Map<RowMajor4> m(matrix.mutable_data());
    m.setIdentity();
    m.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
    m.topRightCorner<3, 1>() = pose.translation;
    return matrix;
}

void bindPoses(py::module_& module) {
    module.def(
        "pose_matrix",
        [](const py::object& pose, const std::string& frame) { return matrixOf(opticalPose(pose, frame)); },
        py::arg("pose"), py::kw_only(), py::arg("frame") = "optical",
        "room_from_camera of the optical frame (z forward, x right, y down) as a (4, 4) matrix.\n\n"
        "pose: (4, 4), or x y z qx qy qz qw, metres (the order of TUM files, of ROS, and of spherewalk-cli "
        "--pose); frame: which frame it is the pose of, \"optical\" or \"body\" (x forward, y left, z up).");
    module.def(
        "read_tum", &readTumFile, py::arg("file"),
        "The times, (n,) seconds, and the poses, (n, 4, 4), of a TUM file: lines of \"time x y z qx qy qz "
        "qw\". The poses are of the frame that the file is about.");
}

} // namespace spherewalk::python
