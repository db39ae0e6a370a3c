// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.h"

#include "spherewalk/base/error.h"

#include <array>
#include <chrono>
#include <string_view>
#include <utility>

namespace spherewalk::gazebo {

namespace {

constexpr std::int64_t kMostSeconds = 9'000'000'000; ///< that nanoseconds of 64 bits can hold

/// The first value of a header's entry; "" without one. Segmentation cameras append theirs every frame.
std::string entryOf(const msgs::Header& header, std::string_view key) {
    for (const auto& entry : header.data()) {
        if (entry.key() == key && entry.value_size() > 0) {
            return entry.value(0);
        }
    }
    return "";
}

NamedPose namedPose(const msgs::Pose& message, const msgs::Header& header) {
    NamedPose pose;
    const std::string child = entryOf(message.header(), "child_frame_id");
    pose.child = child.empty() ? message.name() : child;
    pose.parent = child.empty() ? "" : entryOf(message.header(), "frame_id");
    pose.stamp = stampOf(header);
    if (message.has_position()) {
        pose.parentFromChild.translation = {message.position().x(), message.position().y(),
                                            message.position().z()};
    }
    if (message.has_orientation()) {
        const auto& q = message.orientation();
        pose.parentFromChild.rotation = {q.w(), q.x(), q.y(), q.z()};
    }
    return pose;
}

std::string_view encodingOf(msgs::PixelFormatType format) {
    switch (format) {
    case msgs::L_INT8:
        return "mono8";
    case msgs::L_INT16:
        return "16UC1";
    case msgs::RGB_INT8:
        return "rgb8";
    case msgs::RGBA_INT8:
        return "rgba8";
    case msgs::BGRA_INT8:
        return "bgra8";
    case msgs::BGR_INT8:
        return "bgr8";
    case msgs::R_FLOAT32:
        return "32FC1";
    default:
        return "another pixel format";
    }
}

void addEntry(msgs::Header& header, const char* key, const std::string& value) {
    auto* entry = header.add_data();
    entry->set_key(key);
    entry->add_value(value);
}

void put(msgs::Param& message, const char* key, double value) {
    msgs::Any& any = (*message.mutable_params())[key];
    any.set_type(msgs::Any::DOUBLE);
    any.set_double_value(value);
}

void put(msgs::Param& message, const char* key, const std::string& value) {
    msgs::Any& any = (*message.mutable_params())[key];
    any.set_type(msgs::Any::STRING);
    any.set_string_value(value);
}

void put(msgs::Param& message, const char* key, bool value) {
    msgs::Any& any = (*message.mutable_params())[key];
    any.set_type(msgs::Any::BOOLEAN);
    any.set_bool_value(value);
}

const char* nameOf(simulator::OverlayUse use) {
    constexpr std::array kNames{"not wanted", "laid", "missing"};
    return kNames[static_cast<std::size_t>(use)];
}

} // namespace

simulator::Stamp stampOf(const msgs::Header& header) {
    const auto& stamp = header.stamp();
    if (!header.has_stamp() || stamp.sec() < 0 || stamp.sec() > kMostSeconds || stamp.nsec() < 0 ||
        stamp.nsec() >= 1'000'000'000) {
        throw Error(ErrorKind::InvalidInput,
                    "A message came whose header has no simulation time, and was not used.");
    }
    return std::chrono::seconds(stamp.sec()) + std::chrono::nanoseconds(stamp.nsec());
}

std::vector<NamedPose> posesOf(const msgs::Pose& message) {
    return {namedPose(message, message.header())};
}

std::vector<NamedPose> posesOf(const msgs::Pose_V& message) {
    std::vector<NamedPose> poses;
    poses.reserve(static_cast<std::size_t>(message.pose_size()));
    for (const msgs::Pose& pose : message.pose()) {
        poses.push_back(namedPose(
            pose, message.has_header() && message.header().has_stamp() ? message.header() : pose.header()));
    }
    return poses;
}

simulator::RawPicture pictureOf(const msgs::Image& message) {
    const std::string& data = message.data();
    return {message.width(), message.height(),
            message.step(),  encodingOf(message.pixel_format_type()),
            false,           {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()}};
}

void setHeader(msgs::Header& header, simulator::Stamp stamp, const std::string& frameId,
               std::uint64_t sequence) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(stamp);
    header.Clear();
    header.mutable_stamp()->set_sec(seconds.count());
    header.mutable_stamp()->set_nsec(static_cast<std::int32_t>((stamp - seconds).count()));
    addEntry(header, "frame_id", frameId);
    addEntry(header, "seq", std::to_string(sequence));
}

void setImage(msgs::Image& message, const RgbImage& picture) {
    message.set_width(static_cast<std::uint32_t>(picture.width()));
    message.set_height(static_cast<std::uint32_t>(picture.height()));
    message.set_step(static_cast<std::uint32_t>(3 * picture.width()));
    message.set_pixel_format_type(msgs::RGB_INT8);
    message.set_data(picture.values().data(), picture.values().size());
}

void setDepth(msgs::Image& message, const DepthImage& depth) {
    message.set_width(static_cast<std::uint32_t>(depth.width()));
    message.set_height(static_cast<std::uint32_t>(depth.height()));
    message.set_step(static_cast<std::uint32_t>(sizeof(float)) * message.width());
    message.set_pixel_format_type(msgs::R_FLOAT32);
    message.set_data(depth.values().data(), depth.values().size_bytes());
}

void setLabels(msgs::Image& message, const render::LabelImage& labels) {
    message.set_width(static_cast<std::uint32_t>(labels.width()));
    message.set_height(static_cast<std::uint32_t>(labels.height()));
    message.set_step(static_cast<std::uint32_t>(sizeof(std::uint16_t)) * message.width());
    message.set_pixel_format_type(msgs::L_INT16);
    message.set_data(labels.values().data(), labels.values().size_bytes());
}

void setBoxes(msgs::AnnotatedAxisAligned2DBox_V& message, const render::LabelImage& labels) {
    message.clear_annotated_box();
    for (const simulator::LabelBox& box : simulator::labelBoxes(labels)) {
        msgs::AnnotatedAxisAligned2DBox& one = *message.add_annotated_box();
        one.set_label(box.label);
        one.mutable_box()->mutable_min_corner()->set_x(box.left);
        one.mutable_box()->mutable_min_corner()->set_y(box.top);
        one.mutable_box()->mutable_max_corner()->set_x(box.right);
        one.mutable_box()->mutable_max_corner()->set_y(box.bottom);
    }
}

void setCameraInfo(msgs::CameraInfo& message, const Calibration& calibration) {
    using Distortion = msgs::CameraInfo::Distortion;
    message.set_width(static_cast<std::uint32_t>(calibration.width));
    message.set_height(static_cast<std::uint32_t>(calibration.height));
    const std::string& model = calibration.distortionModel;
    message.mutable_distortion()->set_model(model == "equidistant"           ? Distortion::EQUIDISTANT
                                            : model == "rational_polynomial" ? Distortion::RATIONAL_POLYNOMIAL
                                                                             : Distortion::PLUMB_BOB);
    const auto assign = [](auto* field, const auto& values) { field->Assign(values.begin(), values.end()); };
    assign(message.mutable_distortion()->mutable_k(), calibration.d);
    assign(message.mutable_intrinsics()->mutable_k(), calibration.k);
    assign(message.mutable_projection()->mutable_p(), calibration.p);
    assign(message.mutable_rectification_matrix(), calibration.r);
}

void setReport(msgs::Param& message, const simulator::Frame& frame, double latencyMs) {
    const render::ViewReport& report = frame.view.report;
    put(message, "trust", report.trust);
    put(message, "late", report.isLate);
    put(message, "outside", report.isOutside);
    put(message, "overlay", std::string(nameOf(frame.overlay)));
    put(message, "photo", report.file);
    put(message, "origin", std::string(name(report.origin)));
    put(message, "offset_m", report.offsetM);
    put(message, "parallax_px", report.parallaxPx);
    put(message, "render_ms", report.renderMs);
    put(message, "latency_ms", latencyMs);
}

} // namespace spherewalk::gazebo
