// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "messages.h"

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <chrono>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

struct Topics {
    std::vector<std::string> poses;
    std::string image; ///< Topic of two levels or more; camera_info, depth_image, labels,
                       ///< boxes and report go beside it.
    std::string overlayColour;
    std::string overlayDepth;
    std::string overlayLabels;

    /// The topic of this name on the level of the image.
    std::string beside(const std::string& name) const;

    /// Those of a camera of a rig: the camera's name comes before the last level of the topics of pictures,
    /// /robot/front/left/image. The same for an empty name.
    Topics of(const std::string& camera) const;

    /// Errors: InvalidInput for impossible topics, and for an image's topic of one level.
    void validate() const;
};

struct BridgeOptions {
    Topics topics;
    std::string frame;   ///< Name of the frame whose poses are the camera's: "robot::base::camera".
    std::string frameId; ///< Name of the optical frame, for the headers of pictures of one camera.
};

/// The times that the latest frames took from the arrival of their poses to the transport. Threads: one at a
/// time.
class Latencies {
  public:
    void add(std::chrono::duration<double, std::milli> latency);

    /// This share of the frames took so many milliseconds at most. Returns 0 without frames. Range: share in
    /// [0, 1].
    double quantile(double share) const;

  private:
    static constexpr std::size_t kKept = 65536;

    std::vector<double> m_latest;
    std::size_t m_next = 0;
};

/// What a camera in a simulator did, in sentences for the end of a program.
std::string summary(const simulator::CameraCounters& counters, const Latencies& latencies);

Json toJson(const simulator::CameraCounters& counters, const Latencies& latencies);

/// A camera beside Gazebo. It takes poses and pictures of objects from topics, and publishes its views.
/// Threads: one thread makes, runs and destroys it.
class Bridge {
  public:
    /// Errors: those of Topics::validate() and of SimulatedCamera; Network where a topic cannot be subscribed
    /// or advertised.
    Bridge(const render::Renderer& renderer, const std::vector<render::RigCamera>& cameras,
           const simulator::CameraOptions& cameraOptions, const BridgeOptions& options,
           simulator::Refusals::Tell tell);
    /// With one camera.
    Bridge(const render::Renderer& renderer, const CameraModel& camera,
           const simulator::CameraOptions& cameraOptions, const BridgeOptions& options,
           simulator::Refusals::Tell tell);

    /// Carries messages until the stop. Stop: returns within 20 ms and the rendering of one frame.
    void run(const std::stop_token& stop);

    simulator::CameraCounters counters() const { return m_camera.counters(); }

    /// Range: after run() only.
    const Latencies& latencies() const { return m_latencies; }

  private:
    /// What is published of one camera.
    struct Outgoing {
        Topics topics;
        std::string frameId;
        transport::Node::Publisher image;
        transport::Node::Publisher depth;  ///< unless depth is not wanted
        transport::Node::Publisher labels; ///< unless there is no overlay
        transport::Node::Publisher boxes;  ///< the same
        transport::Node::Publisher info;
        transport::Node::Publisher report;
    };

    Outgoing advertised(const render::RigCamera& camera);
    template <class Message>
    void takePoses(const Message& message);
    void takePicture(simulator::OverlayPart part, const msgs::Image& message, std::size_t camera);
    void publish(const simulator::Frame& frame);
    bool hasListeners() const;
    void followListeners();
    void subscribeToPoses();
    void subscribeToOverlay();
    void unsubscribeFromOverlay();

    const BridgeOptions m_options;
    const bool m_hasOverlay;
    const bool m_hasDepth;
    std::mutex m_mutex; ///< of what poses come to
    PoseTree m_tree;
    bool m_isRunning = true; ///< false: what still comes is not used
    std::uint64_t m_sequence = 0;
    Latencies m_latencies;
    msgs::Image m_image;
    msgs::Image m_depth;
    msgs::Image m_labels;
    msgs::AnnotatedAxisAligned2DBox_V m_boxes;
    msgs::CameraInfo m_info;
    msgs::Param m_report;
    bool m_isOverlaySubscribed = false;
    std::vector<Outgoing> m_outgoing; ///< one a camera
    simulator::SimulatedCamera m_camera;
    transport::Node m_node; ///< last: its callbacks use the others
};

} // namespace spherewalk::gazebo
