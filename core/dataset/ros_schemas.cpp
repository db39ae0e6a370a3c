// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of the messages, without comments, as ROS's tools gather them for bags.
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/ros_messages.h"

namespace spherewalk::dataset {

namespace {

struct Part {
    std::string_view package;
    std::string_view name;
    std::string_view fields; ///< of ROS 2
};

constexpr Part kTime{"builtin_interfaces", "Time", "int32 sec\nuint32 nanosec\n"};
constexpr Part kHeader{"std_msgs", "Header", "builtin_interfaces/Time stamp\nstring frame_id\n"};
constexpr Part kRegion{"sensor_msgs", "RegionOfInterest",
                       "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n"};
constexpr Part kPoint{"geometry_msgs", "Point", "float64 x\nfloat64 y\nfloat64 z\n"};
constexpr Part kVector{"geometry_msgs", "Vector3", "float64 x\nfloat64 y\nfloat64 z\n"};
constexpr Part kQuaternion{"geometry_msgs", "Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"};
constexpr Part kPose{"geometry_msgs", "Pose",
                     "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"};
constexpr Part kTransform{"geometry_msgs", "Transform",
                          "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"};
constexpr Part kTransformStamped{
    "geometry_msgs", "TransformStamped",
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"};
constexpr Part kImage{"sensor_msgs", "Image",
                      "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 "
                      "is_bigendian\nuint32 step\nuint8[] data\n"};
constexpr Part kCompressed{"sensor_msgs", "CompressedImage",
                           "std_msgs/Header header\nstring format\nuint8[] data\n"};
constexpr Part kCamera{
    "sensor_msgs", "CameraInfo",
    "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] "
    "d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\nuint32 "
    "binning_y\nsensor_msgs/RegionOfInterest roi\n"};
constexpr Part kPoseStamped{"geometry_msgs", "PoseStamped",
                            "std_msgs/Header header\ngeometry_msgs/Pose pose\n"};
constexpr Part kTf{"tf2_msgs", "TFMessage", "geometry_msgs/TransformStamped[] transforms\n"};

struct Type {
    std::vector<Part> parts; ///< itself first
    std::string_view md5;    ///< ROS 1's, of its own spelling of the fields
};

Type typeOf(RosType type) {
    switch (type) {
    case RosType::CompressedImage:
        return {{kCompressed, kHeader}, "8f7a12909da2c9d3332d540a0977563f"};
    case RosType::CameraInfo:
        return {{kCamera, kHeader, kRegion}, "c9a58c1b0b154e0e6da7578cb991d214"};
    case RosType::PoseStamped:
        return {{kPoseStamped, kHeader, kPose, kPoint, kQuaternion}, "d3812c3cbc69362b77dc0b19b345f8f5"};
    case RosType::TfMessage:
        return {{kTf, kTransformStamped, kHeader, kTransform, kVector, kQuaternion},
                "94810edda583a504dfda3829e70d7eec"};
    case RosType::Image:
        break;
    }
    return {{kImage, kHeader}, "060021388200f6f0f447d0fcd9c64743"};
}

/// ROS 1 has a time of its own, counts headers, and gives the camera's matrices capital letters.
std::string fieldsOfRos1(const Part& part) {
    std::string fields(part.fields);
    const auto replace = [&](std::string_view from, std::string_view by) {
        if (const std::size_t at = fields.find(from); at != std::string::npos) {
            fields.replace(at, from.size(), by);
        }
    };
    if (part.name == "Header") {
        return "uint32 seq\ntime stamp\nstring frame_id\n";
    }
    if (part.name == "CameraInfo") {
        replace(" d\n", " D\n");
        replace(" k\n", " K\n");
        replace(" r\n", " R\n");
        replace(" p\n", " P\n");
    }
    return fields;
}

} // namespace

RosSchema rosSchema(Ros ros, RosType type) {
    Type parts = typeOf(type);
    if (ros == Ros::Two) {
        parts.parts.push_back(kTime);
    }
    RosSchema schema;
    for (const Part& part : parts.parts) {
        if (schema.name.empty()) {
            schema.name = text(part.package, ros == Ros::Two ? "/msg/" : "/", part.name);
        } else {
            schema.definition += text(std::string(80, '='), "\nMSG: ", part.package, "/", part.name, "\n");
        }
        schema.definition += ros == Ros::Two ? std::string(part.fields) : fieldsOfRos1(part);
    }
    schema.md5 = ros == Ros::One ? parts.md5 : "";
    return schema;
}

} // namespace spherewalk::dataset
