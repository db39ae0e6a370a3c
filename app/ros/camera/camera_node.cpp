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
    if (options.cameraInfoUrl.empty()) {
        throw Error(ErrorKind::InvalidInput, "The parameter camera_info_url is missing: set it to the "
                                             "camera-info YAML of the robot's camera.");
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

CameraModel readCamera(const std::string& urlOrFile) {
    constexpr std::string_view kFile = "file://";
    return CameraModel(
        render::readCameraInfo(urlOrFile.starts_with(kFile) ? urlOrFile.substr(kFile.size()) : urlOrFile));
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

std::string waitingFor(const CameraCounters& counters, const NodeOptions& options) {
    return counters.poses == 0
               ? text("waiting for transforms from ", options.roomFrame, " to ", options.cameraFrame)
               : "nobody listens, or no pose comes";
}

} // namespace

/// Collects what a node tells about its frames once a second. Threads: one at a time.
class CameraDiagnostics {
  public:
    /// Takes a frame that was published just now.
    void add(const simulator::Frame& frame);

    /// Tells what happened since the last call.
    Diagnostics since(const simulator::CameraCounters& counters, const NodeOptions& options);

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

Diagnostics CameraDiagnostics::since(const CameraCounters& now, const NodeOptions& options) {
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
        status.message = frames > 0 ? "giving frames" : waitingFor(now, options);
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
        : options(complete(wanted)),
          giveFrame(std::move(give)),
          camera(
              openRenderer(wanted), readCamera(wanted.cameraInfoUrl), cameraOptions(wanted),
              [this](const simulator::Frame& frame) { publish(frame); }, std::move(tell)) {}

    void publish(const simulator::Frame& frame) {
        const RgbImage& picture = frame.view.picture;
        giveFrame({frame.stamp,
                   {picture.width(), picture.height(), "rgb8", 3, picture.values().data()},
                   depthOf(frame.view.depth),
                   labelsOf(frame.view.labels),
                   calibration(frame.camera)});
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

    /// With the lock held.
    void takeNewest(Stamp newest) {
        if (const auto pose = tree.at(options.roomFrame, options.cameraFrame, newest)) {
            lastPose = newest;
            camera.takePose(newest, *pose);
        }
    }

    const NodeOptions options;
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

std::string CameraNode::depthTopic() const {
    switch (m_state->depthKind) {
    case DepthEncoding::Metres:
        return "camera/depth/image";
    case DepthEncoding::Millimetres:
        return "camera/depth/image_raw";
    case DepthEncoding::None:
        break;
    }
    return "";
}

std::string CameraNode::labelsTopic() const {
    return m_state->options.overlay == "none" ? "" : "camera/labels/image_raw";
}

void CameraNode::takeTransform(const Transform& transform, bool isStatic) {
    State& state = *m_state;
    const std::scoped_lock lock(state.mutex);
    if (const auto refused = state.tree.put(transform, isStatic)) {
        state.camera.refuse(refused->kind, refused->sentence);
        return;
    }
    const auto newest = state.tree.newest(state.options.roomFrame, state.options.cameraFrame);
    if (newest && newest != Stamp::max() && newest != state.lastPose) {
        state.takeNewest(*newest);
    }
}

void CameraNode::takeTime(Stamp now) {
    State& state = *m_state;
    const std::scoped_lock lock(state.mutex);
    if (state.tree.newest(state.options.roomFrame, state.options.cameraFrame) == Stamp::max()) {
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
    state.camera.takePose(stamp, *roomFromFrame * frameFromCamera);
}

void CameraNode::takeOverlay(OverlayTopic topic, Stamp stamp, const Picture& picture) {
    m_state->camera.takeOverlay(partOf(topic), stamp,
                                {picture.width,
                                 picture.height,
                                 picture.stepBytes,
                                 picture.encoding,
                                 picture.isBigEndian,
                                 {picture.bytes, picture.sizeBytes}});
}

void CameraNode::setListening(bool isListening) {
    m_state->camera.setListening(isListening);
}

void CameraNode::setCamera(const Calibration& calibration) {
    m_state->camera.setCamera(CameraModel(intrinsicsOf(calibration)));
}

Diagnostics CameraNode::diagnostics() {
    const simulator::CameraCounters counters = m_state->camera.counters();
    const std::scoped_lock lock(m_state->mutex);
    return m_state->diagnostics.since(counters, m_state->options);
}

} // namespace spherewalk::ros
