// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/ros_messages.h"

#include "spherewalk/base/byte_writer.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <cmath>
#include <limits>

namespace spherewalk::dataset {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Lays out the fields of a message in their order.
class MessageWriter {
  public:
    explicit MessageWriter(Ros ros) : m_ros(ros) {
        if (ros == Ros::Two) {
            m_out.put(bytesOf(std::string_view("\0\1\0\0", 4))); // CDR, little-endian, no options
        }
    }

    template <class Number>
    void number(Number value) {
        if (m_ros == Ros::Two) {
            m_out.alignFrom(kEncapsulation, sizeof(Number));
        }
        m_out.number(value);
    }

    template <class Numbers>
    void numbers(const Numbers& values) {
        for (const auto value : values) {
            number(value);
        }
    }

    void string(std::string_view value) {
        number(static_cast<std::uint32_t>(value.size() + (m_ros == Ros::Two ? 1 : 0)));
        m_out.put(bytesOf(value));
        if (m_ros == Ros::Two) {
            m_out.number(std::uint8_t{0});
        }
    }

    void sequence(ByteView bytes) {
        number(static_cast<std::uint32_t>(bytes.size()));
        m_out.put(bytes);
    }

    void header(const RosHeader& header) {
        if (m_ros == Ros::One) {
            number(header.sequence);
        }
        number(static_cast<std::uint32_t>(header.stampNs / kSecond));
        number(static_cast<std::uint32_t>(header.stampNs % kSecond));
        string(header.frame);
    }

    /// The fields of a pose, which are those of a transform too.
    void placeAndTurn(const Rigid3& pose) {
        const Eigen::Quaterniond& q = pose.rotation;
        numbers(std::array{pose.translation.x(), pose.translation.y(), pose.translation.z(), q.x(), q.y(),
                           q.z(), q.w()});
    }

    Bytes take() { return m_out.take(); }

  private:
    static constexpr std::size_t kEncapsulation = 4;
    Ros m_ros;
    ByteWriter m_out;
};

/// A message as part of others. The fields have no comments, as ROS's tools gather them for bags.
struct Part {
    std::string_view package;
    std::string_view name;
    std::string_view fields; ///< In the spelling of ROS 2.
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
    std::vector<Part> parts; ///< The message itself comes first.
    std::string_view md5;    ///< ROS 1's hash of its own spelling of the fields.
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

/// Rows without padding.
Bytes imageMessage(Ros ros, const RosHeader& header, int width, int height, std::string_view encoding,
                   ByteView pixels) {
    MessageWriter message(ros);
    message.header(header);
    message.number(static_cast<std::uint32_t>(height));
    message.number(static_cast<std::uint32_t>(width));
    message.string(encoding);
    message.number(std::uint8_t{0}); // is_bigendian
    message.number(static_cast<std::uint32_t>(pixels.size() / static_cast<std::size_t>(height)));
    message.sequence(pixels);
    return message.take();
}

} // namespace

std::int64_t rosStampNs(double timeS) {
    if (!(timeS >= 0 && timeS < std::numeric_limits<std::int32_t>::max())) {
        throw Error(ErrorKind::InvalidInput,
                    text("ROS cannot tell the time ", timeS, " s: its times are from 0 to 2^31 s."));
    }
    const double seconds = std::floor(timeS); // apart from the rest, which then keeps its digits
    const std::int64_t rest = std::llround((timeS - seconds) * static_cast<double>(kSecond));
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(seconds) * kSecond + rest);
}

Bytes imageMessage(Ros ros, const RosHeader& header, const RgbImage& picture) {
    return imageMessage(ros, header, picture.width(), picture.height(), "rgb8", picture.values());
}

Bytes imageMessage(Ros ros, const RosHeader& header, const Image<std::uint16_t, 1>& picture) {
    Bytes little; // lowest bytes first
    little.reserve(2 * picture.values().size());
    for (const std::uint16_t value : picture.values()) {
        little.push_back(static_cast<std::uint8_t>(value & 0xFF));
        little.push_back(static_cast<std::uint8_t>(value >> 8));
    }
    return imageMessage(ros, header, picture.width(), picture.height(), "16UC1", little);
}

Bytes pngMessage(Ros ros, const RosHeader& header, ByteView png) {
    MessageWriter message(ros);
    message.header(header);
    message.string("rgb8; png compressed bgr8"); // as image_transport's plugin writes it
    message.sequence(png);
    return message.take();
}

Bytes cameraInfoMessage(Ros ros, const RosHeader& header, const Calibration& camera) {
    MessageWriter message(ros);
    message.header(header);
    message.number(static_cast<std::uint32_t>(camera.height));
    message.number(static_cast<std::uint32_t>(camera.width));
    message.string(camera.distortionModel);
    message.number(static_cast<std::uint32_t>(camera.d.size()));
    message.numbers(camera.d);
    message.numbers(camera.k);
    message.numbers(camera.r);
    message.numbers(camera.p);
    message.numbers(std::array<std::uint32_t, 6>{}); // binning, and the region: all of the picture
    message.number(std::uint8_t{0});                 // its do_rectify
    return message.take();
}

Bytes poseMessage(Ros ros, const RosHeader& header, const Rigid3& pose) {
    MessageWriter message(ros);
    message.header(header);
    message.placeAndTurn(pose);
    return message.take();
}

Bytes tfMessage(Ros ros, const RosHeader& header, std::string_view child, const Rigid3& parentFromChild) {
    MessageWriter message(ros);
    message.number(std::uint32_t{1});
    message.header(header);
    message.string(child);
    message.placeAndTurn(parentFromChild);
    return message.take();
}

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
