// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_settings.h"
#include "pose_tree.h"
#include "program/program.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

namespace {

using program::printLine;
using simulator::Refusal;

/// How often one looks whether somebody listens, besides at each pose.
constexpr auto kInterval = std::chrono::milliseconds(20);

/// A pose publisher that is joined in the middle of a step completes the next one, or the one after.
constexpr std::uint64_t kStepsToFindItsPlace = 3;

/// Moves a camera by the poses of topics. Threads: poses come in those of the transport.
class PoseTopics {
  public:
    /// Errors: Network where a topic cannot be subscribed. Owner: the camera must outlive it.
    PoseTopics(PublishedCamera& camera, const std::vector<std::string>& topics, const std::string& frame)
        : m_camera(camera), m_tree(frame) {
        std::function<void(const msgs::Pose&)> one = [this](const msgs::Pose& message) { take(message); };
        std::function<void(const msgs::Pose_V&)> many = [this](const msgs::Pose_V& message) {
            take(message);
        };
        for (const std::string& topic : topics) {
            if (!m_node.Subscribe(topic, one) || !m_node.Subscribe(topic, many)) {
                failWith("subscribe to", topic);
            }
        }
    }

    /// What still comes is not used.
    void end() {
        const std::scoped_lock lock(m_mutex);
        m_isRunning = false;
    }

  private:
    template <class Message>
    void take(const Message& message);

    PublishedCamera& m_camera;
    std::mutex m_mutex; ///< of what poses come to
    PoseTree m_tree;
    bool m_isRunning = true;
    transport::Node m_node; ///< last: its callbacks use the others
};

template <class Message>
void PoseTopics::take(const Message& message) {
    const std::scoped_lock lock(m_mutex);
    if (!m_isRunning) {
        return;
    }
    simulator::SimulatedCamera& camera = m_camera.camera();
    std::vector<NamedPose> poses;
    try {
        poses = posesOf(message);
    } catch (const Error& error) {
        camera.refuse(Refusal::Time, error.sentence());
        return;
    }
    std::erase_if(poses,
                  [&](const NamedPose& pose) { return !camera.accepts(pose.stamp, pose.parentFromChild); });
    if (poses.empty()) {
        return;
    }
    for (NamedPose& pose : poses) {
        pose.parentFromChild.rotation.normalize();
    }
    const std::uint64_t missedBefore = m_tree.missedSteps();
    if (const std::optional<Rigid3> worldFromFrame = m_tree.add(poses)) {
        camera.setListening(m_camera.hasListeners());
        camera.takePose(poses.back().stamp, *worldFromFrame);
    } else if (m_tree.missedSteps() > std::max(missedBefore, kStepsToFindItsPlace)) {
        camera.refuse(Refusal::FrameId, m_tree.trouble());
    }
}

struct Options {
    CameraSettings camera;
    std::vector<std::string> poses;
    std::string frame; ///< Name of the frame whose poses are the camera's: "robot::base::camera".
    bool isJson = false;
};

int run(const Options& options, const std::stop_token& stop) {
    const CameraSetup setup = options.camera.setup(options.frame);
    std::for_each(options.poses.begin(), options.poses.end(), requireTopic);
    const render::Renderer renderer = options.camera.render().renderer(noProgress(), stop);
    PublishedCamera camera(renderer, setup, [](const std::string& sentence) { printLine(stderr, sentence); });
    PoseTopics poses(camera, options.poses, options.frame);
    printLine(stderr, text("Waits for poses of ", options.frame, "; pictures go to ", setup.topics.image,
                           ". Ctrl-C ends it."));
    do {
        camera.followListeners();
    } while (systemClock().sleep(kInterval, stop));
    poses.end();
    camera.end();
    printLine(stdout, options.isJson ? toJson(camera.counters(), camera.latencies()).dump()
                                     : summary(camera.counters(), camera.latencies()));
    return program::kDone;
}

int runProgram(int argc, char** argv) {
    program::CommandLine line("A camera beside Gazebo that sees a room that was scanned.", "spherewalk-gz",
                              "spherewalk-gz " SPHEREWALK_VERSION);
    const program::Command command = line.program();
    Options options;
    options.camera.declare(command);
    command
        .option("--poses", options.poses,
                "Topic of poses: of a model's pose publisher (/model/NAME/pose), or of the scene "
                "(/world/NAME/dynamic_pose/info); can be repeated")
        .required();
    command
        .option("--frame", options.frame,
                "Frame of these poses in which the camera sits, with its scopes: robot::base::camera")
        .required();
    command.flag("--json", options.isJson, "Print the summary at the end as one JSON object");
    if (const std::optional<int> status = line.parse(argc, argv)) {
        return *status;
    }
    const program::StopOnSignal signals;
    return program::guarded([&] { return run(options, signals.token()); });
}

} // namespace

} // namespace spherewalk::gazebo

int main(int argc, char** argv) {
    spherewalk::gazebo::endProgram(spherewalk::gazebo::runProgram(argc, argv));
}
