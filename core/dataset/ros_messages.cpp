// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/ros_messages.h"

#include "byte_writer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <cmath>
#include <limits>

namespace spherewalk::dataset {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Fields of a message in their order.
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

    /// Of a pose as of a transform.
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
    MessageWriter message(ros);
    message.header(header);
    message.number(static_cast<std::uint32_t>(picture.height()));
    message.number(static_cast<std::uint32_t>(picture.width()));
    message.string("rgb8");
    message.number(std::uint8_t{0}); // is_bigendian
    message.number(static_cast<std::uint32_t>(RgbImage::kChannels * picture.width()));
    message.sequence(picture.values());
    return message.take();
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

} // namespace spherewalk::dataset
