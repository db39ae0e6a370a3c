// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "messages.h"

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

/// Topics of a camera's pictures, and of the pictures of objects that it lays in.
struct Topics {
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

/// Errors: InvalidInput for what cannot be a topic's name.
void requireTopic(const std::string& name);

/// Throws Error{Network} with a sentence that says what could not be done with the topic: "subscribe to".
[[noreturn]] void failWith(const std::string& what, const std::string& topic);

/// What a camera in Gazebo is made of, besides its dataset.
struct CameraSetup {
    Topics topics;
    std::vector<render::RigCamera> cameras; ///< Of a rig, or the one.
    simulator::CameraOptions options;
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

/// A camera in Gazebo, wherever its poses come from. It takes pictures of objects from topics, and publishes
/// its views. Threads: one at a time makes, moves and destroys it.
class PublishedCamera {
  public:
    /// Errors: those of Topics::validate() and of SimulatedCamera; Network where a topic cannot be
    /// advertised.
    PublishedCamera(const render::Renderer& renderer, const CameraSetup& setup,
                    simulator::Refusals::Tell tell);
    /// Waits for the frame that is being rendered.
    ~PublishedCamera();
    PublishedCamera(const PublishedCamera&) = delete;
    PublishedCamera& operator=(const PublishedCamera&) = delete;

    /// Looks whether somebody wants the pictures. While nobody does, the simulator need not render pictures
    /// of objects either. Errors: Network where their topics cannot be subscribed.
    void followListeners();

    /// Takes poses of the frame that carries the cameras, and what is wrong with them. Threads: any.
    simulator::SimulatedCamera& camera() { return m_camera; }

    /// Returns whether somebody wants the pictures. Threads: any.
    bool hasListeners() const;

    /// Drops what waits, and hands over the frame that is being rendered. Range: followListeners() is not
    /// called any more.
    void end();

    simulator::CameraCounters counters() const { return m_camera.counters(); }

    /// Range: after end() only.
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

    Outgoing advertised(const Topics& topics, const std::string& frameId);
    void takePicture(simulator::OverlayPart part, const msgs::Image& message, std::size_t camera);
    void publish(const simulator::Frame& frame);
    void subscribeToOverlay();
    void unsubscribeFromOverlay();

    const bool m_hasOverlay;
    const bool m_hasDepth;
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
