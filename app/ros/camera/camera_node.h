// SPDX-License-Identifier: GPL-3.0-or-later
// What adapters see, in C++17: ROS 1's messages do not compile as C++20.
#pragma once

#include "spherewalk/geometry/calibration.h"
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

/// What a node is told, whatever the middleware. Parameters are called like the fields.
struct NodeOptions {
    std::string dataset;                        ///< folder
    std::string cameraInfoUrl;                  ///< camera-info YAML; a "file://" in front is left out
    std::string roomFrame = "map";              ///< the dataset's room
    std::string cameraFrame = "camera_optical"; ///< z forward, x right, y down
    double rate = 30;                           ///< frames a second; 0: one for each pose
    std::string scene = "auto";
    std::string sampling = "footprint";
    std::string late = "wait";            ///< wait, coarse or previous
    std::string pace = "newest";          ///< newest or every
    std::string overlay = "none";         ///< none, or how objects are told: labels, depth or alone
    std::vector<int> roomLabels = {0, 1}; ///< with labels: what shows the photo
    double overlayWait = 0.5;             ///< seconds
    int threads = 0;                      ///< 0: all
    int cacheMb = 512;                    ///< of decoded photos
};

/// A transform as it came in a message.
struct Transform {
    std::string parent;
    std::string child;
    Stamp stamp{};
    Rigid3 parentFromChild;
};

/// A picture as it came in a message. Owner: refers to the message.
struct Picture {
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::uint64_t stepBytes = 0;
    const std::string& encoding;
    bool isBigEndian = false;
    const std::uint8_t* bytes = nullptr;
    std::size_t sizeBytes = 0;
};

/// A frame to be published. Shape: width * height * 3 bytes, rgb8, rows without padding.
struct PublishedFrame {
    Stamp stamp{}; ///< of the pose that it shows
    int width = 0;
    int height = 0;
    const std::uint8_t* rgb = nullptr;
    Calibration calibration;
};

/// What diagnostic_msgs/DiagnosticStatus says.
struct Diagnostics {
    std::uint8_t level = 0; ///< 0: all is well, 1: warning
    std::string message;
    std::vector<std::pair<std::string, std::string>> values;
};

enum class OverlayTopic { Colour, Depth, Labels };

/// Relative to the camera's name space.
const char* nameOf(OverlayTopic topic);

/// A node without its middleware, which hands over what comes and publishes what is given. Each time for
/// which the camera's place in the room becomes known is a pose. What comes is not believed: what cannot be
/// used is counted and told of. Threads: all functions may be called from any thread; frames are handed over
/// in one of its own.
class CameraNode {
  public:
    using GiveFrame = std::function<void(const PublishedFrame&)>;
    using Tell = std::function<void(const std::string& sentence)>;

    /// Opens the dataset. tell: for the node's log, from any thread. Errors: those of opening, and
    /// InvalidInput for options that are none.
    CameraNode(const NodeOptions& options, GiveFrame giveFrame, Tell tell);
    ~CameraNode();
    CameraNode(const CameraNode&) = delete;
    CameraNode& operator=(const CameraNode&) = delete;

    const NodeOptions& options() const;
    /// Whose pictures are wanted; none without an overlay.
    std::vector<OverlayTopic> overlayTopics() const;

    /// isStatic: of /tf_static.
    void takeTransform(const Transform& transform, bool isStatic);

    /// What time it is: a pose, if nothing moves between the room and the camera, so that no transform tells.
    void takeTime(Stamp now);

    /// A pose of the camera's frame that comes by itself. frame: that it is in; the room's, or one that
    /// transforms connect with it.
    void takePose(const std::string& frame, Stamp stamp, const Rigid3& frameFromCamera);

    void takeOverlay(OverlayTopic topic, Stamp stamp, const Picture& picture);

    void setListening(bool isListening);

    /// Another camera from now on. Errors: those of intrinsicsOf().
    void setCamera(const Calibration& calibration);

    /// What happened since the call before.
    Diagnostics diagnostics();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::ros
