// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "messages.h"
#include "program/camera_summary.h"

#include "spherewalk/simulator/simulated_camera.h"

#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

struct Topics {
    std::vector<std::string> poses;
    std::string image; ///< of two levels: camera_info and report go beside it
    std::string overlayColour;
    std::string overlayDepth;
    std::string overlayLabels;

    /// Of the level above the image.
    std::string beside(const std::string& name) const;

    /// Errors: InvalidInput for topics that cannot be, and an image's that has one level only.
    void validate() const;
};

struct BridgeOptions {
    Topics topics;
    std::string frame;   ///< whose poses are the camera's: "robot::base::camera"
    std::string frameId; ///< what the pictures' headers say: the optical frame's name
};

/// A camera beside Gazebo: takes poses and pictures of objects from topics, and publishes what it sees.
/// Threads: made, run and destroyed in one; messages come in others.
class Bridge {
  public:
    /// Errors: those of Topics::validate() and of SimulatedCamera; Network for topics that cannot be
    /// subscribed or advertised.
    Bridge(const render::Renderer& renderer, const CameraModel& camera,
           const simulator::CameraOptions& cameraOptions, const BridgeOptions& options,
           simulator::Refusals::Tell tell);

    /// Returns when it is to stop.
    void run(const std::stop_token& stop);

    simulator::CameraCounters counters() const { return m_camera.counters(); }

    /// Until the picture is handed to the transport. Range: after run() only.
    const program::Latencies& latencies() const { return m_latencies; }

  private:
    template <class Message>
    void takePoses(const Message& message);
    void takePicture(simulator::OverlayPart part, const msgs::Image& message);
    void publish(const simulator::Frame& frame);
    bool hasListeners() const;
    void followListeners();
    void subscribeToPoses();
    void subscribeToOverlay();
    void unsubscribeFromOverlay();

    const BridgeOptions m_options;
    const bool m_hasOverlay;
    std::mutex m_mutex; ///< of what poses come to
    PoseTree m_tree;
    bool m_isRunning = true; ///< false: what still comes is not used
    std::uint64_t m_sequence = 0;
    program::Latencies m_latencies;
    msgs::Image m_image;
    msgs::CameraInfo m_info;
    msgs::Param m_report;
    bool m_isOverlaySubscribed = false;
    transport::Node::Publisher m_imagePublisher;
    transport::Node::Publisher m_infoPublisher;
    transport::Node::Publisher m_reportPublisher;
    simulator::SimulatedCamera m_camera;
    transport::Node m_node; ///< last: its callbacks use the others
};

} // namespace spherewalk::gazebo
