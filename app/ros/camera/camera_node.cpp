// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_node.h"

#include "camera_options.h"
#include "transform_tree.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>

namespace spherewalk::ros {

using simulator::CameraCounters;
using simulator::OverlayPart;
using simulator::Refusal;

namespace {

/// The options, if they name what nobody can guess.
const NodeOptions& complete(const NodeOptions& options) {
    if (options.dataset.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "The parameter dataset is missing: set it to the dataset's folder.");
    }
    if (options.cameraInfoUrl.empty() && options.rig.empty()) {
        throw Error(ErrorKind::InvalidInput, "The parameter camera_info_url is missing: set it to the "
                                             "camera-info YAML of the robot's camera, or rig to that of "
                                             "several cameras.");
    }
    if (!options.cameraInfoUrl.empty() && !options.rig.empty()) {
        throw Error(ErrorKind::InvalidInput, "The parameters camera_info_url and rig are both set: the rig's "
                                             "file names the cameras, so leave camera_info_url out.");
    }
    return options;
}

render::Renderer openRenderer(const NodeOptions& options) {
    render::RendererOptions renderer;
    renderer.cacheBytes = static_cast<std::uint64_t>(options.cacheMb) << 20U;
    renderer.verify = render::VerifyPhotos::InBackground;
    return render::Renderer(std::make_shared<const render::Dataset>(render::Dataset::open(options.dataset)),
                            renderer);
}

/// The cameras of the rig; without a rig, one that sits at the camera's frame.
std::vector<render::RigCamera> readCameras(const NodeOptions& options) {
    complete(options);
    if (!options.rig.empty()) {
        return render::readRig(fileOf(options.rig, "rig"));
    }
    const std::string name = "camera";
    return {
        {name, options.cameraFrame, render::readCameraInfo(fileOf(options.cameraInfoUrl, name)), Rigid3()}};
}

std::vector<simulator::MountedCamera> mounted(const std::vector<render::RigCamera>& cameras) {
    std::vector<simulator::MountedCamera> result;
    for (const render::RigCamera& camera : cameras) {
        result.push_back({CameraModel(camera.camera), camera.rigFromOptical.value_or(Rigid3())});
    }
    return result;
}

std::vector<PublishedCamera> published(const std::vector<render::RigCamera>& cameras,
                                       const NodeOptions& options) {
    const DepthEncoding depth = depthEncoding(options.depth);
    std::vector<PublishedCamera> result;
    for (const render::RigCamera& camera : cameras) {
        result.push_back(
            {camera.name, camera.frameId,
             depth == DepthEncoding::None
                 ? ""
                 : text(camera.name, depth == DepthEncoding::Metres ? "/depth/image" : "/depth/image_raw"),
             options.overlay == "none" ? "" : camera.name + "/labels/image_raw",
             options.overlay == "none" ? "" : camera.name + "/labels/detections"});
    }
    return result;
}

OverlayPart partOf(OverlayTopic topic) {
    switch (topic) {
    case OverlayTopic::Depth:
        return OverlayPart::Depth;
    case OverlayTopic::Labels:
        return OverlayPart::Labels;
    case OverlayTopic::Colour:
        break;
    }
    return OverlayPart::Colour;
}

std::uint64_t sum(const simulator::Refusals::Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// frames: that the cameras sit on.
std::string waitingFor(const CameraCounters& counters, const std::string& roomFrame,
                       const std::vector<std::string>& frames) {
    std::string list;
    for (auto frame = frames.begin(); frame != frames.end(); ++frame) {
        const bool isKnown = std::find(frames.begin(), frame, *frame) != frame;
        list += isKnown ? "" : text(list.empty() ? "" : ", ", *frame);
    }
    return counters.poses == 0 ? text("waiting for transforms from ", roomFrame, " to ", list)
                               : "nobody listens, or no pose comes";
}

} // namespace

/// Collects what a node tells about its frames once a second. Threads: one at a time.
class CameraDiagnostics {
  public:
    /// Takes a frame that was published just now.
    void add(const simulator::Frame& frame);

    /// Tells what happened since the last call.
    /// idle: what to say if there were no frames and nothing else.
    Diagnostics since(const simulator::CameraCounters& counters, const std::string& idle);

  private:
    double m_leastTrust = 1;
    double m_worstLatencyMs = 0;
    std::string m_photo;
    double m_offsetM = 0;
    simulator::CameraCounters m_last;
};

void CameraDiagnostics::add(const simulator::Frame& frame) {
    const std::chrono::duration<double, std::milli> latency =
        std::chrono::steady_clock::now() - frame.poseTakenAt;
    m_leastTrust = std::min(m_leastTrust, frame.view.report.trust);
    m_worstLatencyMs = std::max(m_worstLatencyMs, latency.count());
    m_photo = frame.view.report.file;
    m_offsetM = frame.view.report.offsetM;
}

Diagnostics CameraDiagnostics::since(const CameraCounters& now, const std::string& idle) {
    Diagnostics status;
    const auto put = [&](const std::string& key, const std::string& value) {
        status.values.emplace_back(key, value);
    };
    const auto warn = [&](std::uint64_t count, const std::string& what) {
        put(what, text(count));
        if (count > 0) {
            status.message += text(status.message.empty() ? "" : "; ", count, " ", what);
            status.level = 1;
        }
    };
    const std::uint64_t frames = now.frames - m_last.frames;
    put("frames", text(frames));
    warn(sum(now.refused) - sum(m_last.refused), "refused");
    warn(now.dropped - m_last.dropped, "left out");
    warn(now.overlaysMissing - m_last.overlaysMissing, "without overlay");
    warn(now.outside - m_last.outside, "from outside the room");
    // A new camera begins to count anew.
    put("late", text(now.stream.late - std::min(now.stream.late, m_last.stream.late)));
    if (frames > 0) {
        put("least trust", fixed(m_leastTrust, 3));
        put("worst latency ms", fixed(m_worstLatencyMs, 1));
        put("photo", m_photo);
        put("offset m", fixed(m_offsetM, 3));
    }
    put("restarts so far", text(now.restarts));
    for (std::size_t kind = 0; kind < simulator::kRefusalKinds; ++kind) {
        put(text("refused so far: ", name(static_cast<simulator::Refusal>(kind))), text(now.refused[kind]));
    }
    if (status.message.empty()) {
        status.message = frames > 0 ? "giving frames" : idle;
    }
    *this = {};
    m_last = now;
    return status;
}

const char* nameOf(OverlayTopic topic) {
    switch (topic) {
    case OverlayTopic::Depth:
        return "overlay/depth";
    case OverlayTopic::Labels:
        return "overlay/labels";
    case OverlayTopic::Colour:
        break;
    }
    return "overlay/image_raw";
}

struct CameraNode::State {
    State(const NodeOptions& wanted, GiveFrame give, Tell tell)
        : options(wanted),
          rig(readCameras(wanted)),
          cameras(published(rig, wanted)),
          frames(framesOf(rig, wanted)),
          giveFrame(std::move(give)),
          camera(
              openRenderer(wanted), mounted(rig), cameraOptions(wanted),
              [this](const simulator::Frame& frame) { publish(frame); }, std::move(tell)) {}

    /// The frame that each camera sits on: the camera's own where transforms tell its place on the rig.
    static std::vector<std::string> framesOf(const std::vector<render::RigCamera>& rig,
                                             const NodeOptions& options) {
        std::vector<std::string> frames;
        for (const render::RigCamera& camera : rig) {
            frames.push_back(camera.rigFromOptical ? options.cameraFrame : camera.frameId);
        }
        return frames;
    }

    void publish(const simulator::Frame& frame) {
        const RgbImage& picture = frame.view.picture;
        giveFrame({frame.index,
                   frame.stamp,
                   {picture.width(), picture.height(), "rgb8", 3, picture.values().data()},
                   depthOf(frame.view.depth),
                   labelsOf(frame.view.labels),
                   detectionsOf(frame.view.labels),
                   render::stereoCalibration(frame.camera, frame.baselineM)});
        const std::scoped_lock lock(mutex);
        diagnostics.add(frame);
    }

    static PublishedPicture labelsOf(const render::LabelImage& labels) {
        if (labels.empty()) {
            return {};
        }
        return {labels.width(), labels.height(), "16UC1", sizeof(labels.values()[0]),
                reinterpret_cast<const std::uint8_t*>(labels.values().data())};
    }

    static std::vector<Detection> detectionsOf(const render::LabelImage& labels) {
        std::vector<Detection> detections;
        for (const simulator::LabelBox& box : simulator::labelBoxes(labels)) {
            detections.push_back({text(box.label), (box.left + box.right) / 2.0, (box.top + box.bottom) / 2.0,
                                  box.right - box.left + 1.0, box.bottom - box.top + 1.0});
        }
        return detections;
    }

    PublishedPicture depthOf(const DepthImage& depth) {
        if (depthKind == DepthEncoding::None || depth.empty()) {
            return {};
        }
        const auto published = [&depth](const char* encoding, const auto& values) {
            return PublishedPicture{depth.width(), depth.height(), encoding, sizeof(values[0]),
                                    reinterpret_cast<const std::uint8_t*>(values.data())};
        };
        if (depthKind == DepthEncoding::Metres) {
            return published("32FC1", depth.values());
        }
        millimetres = render::depthMillimetres(depth);
        return published("16UC1", millimetres.values());
    }

    /// The newest time at which all cameras' places are known; Stamp::max() if they never change. With the
    /// lock held.
    std::optional<Stamp> newest() const {
        Stamp newest = Stamp::max();
        for (const std::string& frame : frames) {
            const std::optional<Stamp> of = tree.newest(options.roomFrame, frame);
            if (!of) {
                return std::nullopt;
            }
            newest = std::min(newest, *of);
        }
        return newest;
    }

    /// With the lock held.
    void takeNewest(Stamp newest) {
        std::vector<Rigid3> poses;
        for (const std::string& frame : frames) {
            const std::optional<Rigid3> pose = tree.at(options.roomFrame, frame, newest);
            if (!pose) {
                return;
            }
            poses.push_back(*pose);
        }
        lastPose = newest;
        camera.takePoses(newest, poses);
    }

    const NodeOptions options;
    const std::vector<render::RigCamera> rig;
    const std::vector<PublishedCamera> cameras;
    const std::vector<std::string> frames;
    const DepthEncoding depthKind = depthEncoding(options.depth);
    GiveFrame giveFrame;
    Image<std::uint16_t, 1> millimetres; ///< of the rendering thread
    std::mutex mutex;                    ///< of what follows
    TransformTree tree;
    std::optional<Stamp> lastPose;
    CameraDiagnostics diagnostics;
    simulator::SimulatedCamera camera; ///< last: its thread uses the others
};

CameraNode::CameraNode(const NodeOptions& options, GiveFrame giveFrame, Tell tell)
    : m_state(std::make_unique<State>(options, std::move(giveFrame), std::move(tell))) {
}

CameraNode::~CameraNode() = default;

const NodeOptions& CameraNode::options() const {
    return m_state->options;
}

std::vector<OverlayTopic> CameraNode::overlayTopics() const {
    if (m_state->options.overlay == "none") {
        return {};
    }
    if (m_state->options.overlay == "labels") {
        return {OverlayTopic::Colour, OverlayTopic::Depth, OverlayTopic::Labels};
    }
    return {OverlayTopic::Colour, OverlayTopic::Depth};
}

const std::vector<PublishedCamera>& CameraNode::cameras() const {
    return m_state->cameras;
}

std::string CameraNode::overlayTopic(OverlayTopic topic, std::size_t camera) const {
    return m_state->options.rig.empty() ? nameOf(topic)
                                        : text(m_state->cameras[camera].name, "/", nameOf(topic));
}

void CameraNode::takeTransform(const Transform& transform, bool isStatic) {
    State& state = *m_state;
    const std::scoped_lock lock(state.mutex);
    if (const auto refused = state.tree.put(transform, isStatic)) {
        state.camera.refuse(refused->kind, refused->sentence);
        return;
    }
    const auto newest = state.newest();
    if (newest && newest != Stamp::max() && newest != state.lastPose) {
        state.takeNewest(*newest);
    }
}

void CameraNode::takeTime(Stamp now) {
    if (now == Stamp::zero()) {
        return; // simulated time of which no /clock has told
    }
    State& state = *m_state;
    const std::scoped_lock lock(state.mutex);
    if (state.newest() == Stamp::max()) {
        state.takeNewest(now);
    }
}

void CameraNode::takePose(const std::string& frame, Stamp stamp, const Rigid3& frameFromCamera) {
    State& state = *m_state;
    const std::scoped_lock lock(state.mutex);
    const std::optional<Rigid3> roomFromFrame = state.tree.at(state.options.roomFrame, frame, stamp);
    if (!roomFromFrame) {
        state.camera.refuse(Refusal::FrameId, text("A pose in the frame \"", printable(frame),
                                                   "\" came and was not used; no transform leads from it to ",
                                                   state.options.roomFrame, " at its time."));
        return;
    }
    std::vector<Rigid3> poses;
    for (const std::string& of : state.frames) {
        const std::optional<Rigid3> rigFromCamera = state.tree.at(state.options.cameraFrame, of, stamp);
        if (!rigFromCamera) {
            state.camera.refuse(Refusal::FrameId, text("A pose of ", state.options.cameraFrame,
                                                       " came and was not used; no "
                                                       "transform leads from it to the camera's frame ",
                                                       printable(of), " at its time."));
            return;
        }
        poses.push_back(*roomFromFrame * frameFromCamera * *rigFromCamera);
    }
    state.camera.takePoses(stamp, poses);
}

void CameraNode::takeOverlay(OverlayTopic topic, Stamp stamp, const Picture& picture, std::size_t camera) {
    m_state->camera.takeOverlay(partOf(topic), stamp,
                                {picture.width,
                                 picture.height,
                                 picture.stepBytes,
                                 picture.encoding,
                                 picture.isBigEndian,
                                 {picture.bytes, picture.sizeBytes}},
                                camera);
}

void CameraNode::setListening(bool isListening) {
    m_state->camera.setListening(isListening);
}

void CameraNode::setCamera(const Calibration& calibration, std::size_t camera) {
    m_state->camera.setCamera(CameraModel(intrinsicsOf(calibration)), camera);
}

Diagnostics CameraNode::diagnostics() {
    const simulator::CameraCounters counters = m_state->camera.counters();
    const std::scoped_lock lock(m_state->mutex);
    return m_state->diagnostics.since(counters,
                                      waitingFor(counters, m_state->options.roomFrame, m_state->frames));
}

} // namespace spherewalk::ros
