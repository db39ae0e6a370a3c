// SPDX-License-Identifier: GPL-3.0-or-later
// What adapters see, in C++17: ROS 1's messages do not compile as C++20.
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::ros {

/// Time since ROS's zero.
using Stamp = std::chrono::nanoseconds;

/// The parameters of a node in every middleware. ROS spells their names with underscores: room_frame.
struct NodeOptions {
    std::string dataset;           ///< Folder of the dataset.
    std::string cameraInfoUrl;     ///< ROS camera-info YAML: a path, or file:// or package://.
    std::string rig;               ///< YAML of a rig of cameras, in place of one camera.
    std::string roomFrame = "map"; ///< Frame of the dataset's room.
    /// Optical frame: z forward, x right, y down. Of a rig, the frame in which its file places cameras.
    std::string cameraFrame = "camera_optical";
    double rate = 30; ///< Frames a second; 0: one for each pose.
    std::string scene = "auto";
    std::string sampling = "best";
    std::string late = "wait";            ///< "wait", "coarse" or "previous".
    std::string pace = "newest";          ///< "newest" or "every".
    std::string overlay = "none";         ///< "none", or what tells objects: "labels", "depth" or "alone".
    std::vector<int> roomLabels = {0, 1}; ///< With "labels": the labels of the room.
    double overlayWait = 0.5;             ///< Seconds that a frame waits for its overlay, [0, 10].
    int threads = 0;                      ///< Threads to render with; 0: all.
    int cacheMb = 512;                    ///< Megabytes of decoded photos.
    std::string sensor;                   ///< YAML of the sensor; empty for one that is perfect.
    std::string depth = "none";           ///< Encoding of a depth image: "none", "32FC1" or "16UC1".
};

/// A transform of a message, unchecked.
struct Transform {
    std::string parent;
    std::string child;
    Stamp stamp{};
    Rigid3 parentFromChild;
};

/// A picture of a message, unchecked. Owner: refers to the message.
struct Picture {
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::uint64_t stepBytes = 0;
    const std::string& encoding;
    bool isBigEndian = false;
    const std::uint8_t* bytes = nullptr;
    std::size_t sizeBytes = 0;
};

/// A picture to be published. Shape: width * height * pixelBytes bytes, rows without padding, numbers with
/// their lowest byte first.
struct PublishedPicture {
    int width = 0;
    int height = 0;
    const char* encoding = "";
    int pixelBytes = 0;
    const std::uint8_t* bytes = nullptr; ///< Null without a picture.
};

/// The content of a vision_msgs/Detection2D: the box about all visible pixels of a label. Units: pixels;
/// whole numbers are pixels' centres, so the box about a single pixel is 1 x 1 about that pixel's own
/// coordinates.
struct Detection {
    std::string classId; ///< The label in decimal digits.
    double centreX = 0;
    double centreY = 0;
    double sizeX = 0;
    double sizeY = 0;
};

/// A camera whose frames are published. Topics are relative to the name space of the node.
struct PublishedCamera {
    std::string name;    ///< Of the topics: "camera", or the camera's name in its rig.
    std::string frameId; ///< Of the headers.
    /// Depth images: camera/depth/image for 32FC1 and camera/depth/image_raw for 16UC1 (REP 118). Empty
    /// without depth images.
    std::string depthTopic;
    /// Pictures that tell the laid-in object of each pixel: the overlay's labels, 65535 for an object without
    /// one, 0 for the room. Empty without an overlay.
    std::string labelsTopic;
    std::string detectionsTopic; ///< Boxes about the labels. Empty without an overlay.
};

/// A frame to be published. Its messages have the same stamp, which is that of all cameras of a rig.
struct PublishedFrame {
    std::size_t camera = 0;  ///< Index in CameraNode::cameras().
    Stamp stamp{};           ///< Time of the pose that the frame shows.
    PublishedPicture image;  ///< rgb8
    PublishedPicture depth;  ///< As REP 118 says; none without NodeOptions::depth.
    PublishedPicture labels; ///< 16UC1; none without NodeOptions::overlay.
    std::vector<Detection>
        detections; ///< Of all labels but the room's; they come with the picture of labels.
    Calibration calibration;
};

/// The content of a diagnostic_msgs/DiagnosticStatus.
struct Diagnostics {
    std::uint8_t level = 0; ///< 0: all is well; 1: warning.
    std::string message;
    std::vector<std::pair<std::string, std::string>> values;
};

enum class OverlayTopic { Colour, Depth, Labels };

/// The topic's name, relative to the name space of a node with one camera. Those of a rig's cameras begin
/// with the camera's name: left/overlay/depth.
const char* nameOf(OverlayTopic topic);

/// A node without its middleware: an adapter hands over messages and publishes frames. Each time at which the
/// pose of the camera in the room becomes known gives a frame, at most NodeOptions::rate a second. The node
/// checks all input; it counts and reports what it cannot use. Threads: all functions may be called from any
/// thread; the node calls GiveFrame from a thread of its own.
class CameraNode {
  public:
    using GiveFrame = std::function<void(const PublishedFrame&)>;
    using Tell = std::function<void(const std::string& sentence)>;

    /// Opens the dataset. tell: writes to the node's log, from any thread. Errors: those of
    /// render::Dataset::open() and render::readCameraInfo(); InvalidInput for unknown words and numbers out
    /// of range.
    CameraNode(const NodeOptions& options, GiveFrame giveFrame, Tell tell);
    ~CameraNode();
    CameraNode(const CameraNode&) = delete;
    CameraNode& operator=(const CameraNode&) = delete;

    const NodeOptions& options() const;
    /// One camera, or those of the rig in the order of its file.
    const std::vector<PublishedCamera>& cameras() const;
    /// The pictures that the adapter subscribes for each camera's overlay; empty without an overlay.
    std::vector<OverlayTopic> overlayTopics() const;
    /// The topic of such pictures of a camera.
    std::string overlayTopic(OverlayTopic topic, std::size_t camera) const;

    /// isStatic: the transform came on /tf_static and holds at all times.
    void takeTransform(const Transform& transform, bool isStatic);

    /// Tells the time. Where only static transforms connect room and camera, each call gives a pose. Zero
    /// stands for a time that is not known, as in ROS, and gives none.
    void takeTime(Stamp now);

    /// Takes a pose of the camera, or of the frame of its rig, that is no transform. frame: the frame of
    /// reference, the room or a frame that transforms connect with the room.
    void takePose(const std::string& frame, Stamp stamp, const Rigid3& frameFromCamera);

    void takeOverlay(OverlayTopic topic, Stamp stamp, const Picture& picture, std::size_t camera = 0);

    /// Frames are rendered only while somebody listens.
    void setListening(bool isListening);

    /// Replaces a camera for the following frames. Errors: those of intrinsicsOf().
    void setCamera(const Calibration& calibration, std::size_t camera = 0);

    /// What happened since the last call.
    Diagnostics diagnostics();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::ros
