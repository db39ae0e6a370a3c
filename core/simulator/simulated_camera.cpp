// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/simulated_camera.h"

#include "frame_schedule.h"
#include "object_overlay.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/camera_info.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace spherewalk::simulator {

namespace {

constexpr double kFarthestM = 1e7;
constexpr double kUnitTolerance = 0.01;

OverlayParts partOf(OverlayPart part, const RawPicture& picture, const CameraIntrinsics& camera) {
    OverlayParts parts;
    switch (part) {
    case OverlayPart::Colour:
        parts.colour = colourOf(picture, camera);
        break;
    case OverlayPart::Depth:
        parts.depth = depthOf(picture, camera);
        break;
    case OverlayPart::Labels:
        parts.labels = labelsOf(picture, camera);
        break;
    }
    return parts;
}

std::string componentsOf(const Eigen::Quaterniond& q) {
    return text("w ", q.w(), ", x ", q.x(), ", y ", q.y(), ", z ", q.z());
}

} // namespace

/// What makes frames with one camera model; used by the rendering thread alone.
struct FrameMaker {
    FrameMaker(const render::Renderer& renderer, const CameraModel& model, const CameraOptions& options,
               std::size_t index)
        : stream(renderer, model, options.stream) {
        if (options.overlay) {
            objects.emplace(*options.overlay, options.wantsLabels, renderer.dataset().info(),
                            options.overlay->camera.value_or(model.intrinsics()), options.view.threads);
        }
        if (options.sensor) {
            sensor.emplace(options.sensor->ofCamera(index), model, options.view.threads);
        }
    }

    render::ViewStream stream;
    std::optional<ObjectOverlay> objects;
    std::optional<render::Sensor> sensor;
};

double secondsOf(Stamp stamp) {
    return std::chrono::duration<double>(stamp).count();
}

/// A camera's pose about a frame's time, counted from the frame's stamp. A jump is no motion.
Rigid3 poseAbout(const DueFrame& due, std::size_t index, double afterS) {
    constexpr double kFastestMS = 100;
    const Rigid3& now = due.roomFromCameras[index];
    const double lengthS = due.before ? secondsOf(due.stamp - due.before->stamp) : 0;
    if (!(lengthS > 0)) {
        return now;
    }
    const Rigid3& before = due.before->roomFromCameras[index];
    const bool isJump = (now.translation - before.translation).norm() > kFastestMS * lengthS;
    return isJump ? now : interpolated(before, now, 1 + afterS / lengthS);
}

struct SimulatedCamera::State {
    State(render::Renderer sharedRenderer, const std::vector<MountedCamera>& wantedCameras,
          const CameraOptions& wanted, GiveFrame give, Refusals::Tell tell)
        : renderer(std::move(sharedRenderer)),
          options(checked(wanted, wantedCameras)),
          giveFrame(std::move(give)),
          refusals(std::move(tell)),
          schedule(options, wantedCameras.size()) {
        for (const MountedCamera& camera : wantedCameras) {
            rigFromOptical.push_back(camera.rigFromOptical);
            makers.push_back(std::make_shared<FrameMaker>(renderer, camera.model, options, makers.size()));
            cameras.push_back(camera.model.intrinsics());
        }
        frames.resize(cameras.size());
        thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
    }

    static const CameraOptions& checked(const CameraOptions& options,
                                        const std::vector<MountedCamera>& cameras) {
        options.validate();
        if (cameras.empty()) {
            throw Error(ErrorKind::InvalidInput, "A rig has one camera or more.");
        }
        for (const MountedCamera& camera : cameras) {
            if (!isPose(camera.rigFromOptical)) {
                throw Error(ErrorKind::InvalidInput,
                            "A camera's place on its rig must be finite metres and a "
                            "unit quaternion.");
            }
        }
        return options;
    }

    const CameraIntrinsics& overlayCamera(std::size_t index) const {
        return options.overlay->camera ? *options.overlay->camera : cameras[index];
    }

    void putPart(OverlayPart part, Stamp stamp, const RawPicture& picture, std::size_t index);
    void work(const std::stop_token& stop);
    void make(FrameMaker& with, DueFrame& due, std::size_t index);
    void countFrames();
    void countStreams(const std::vector<std::shared_ptr<FrameMaker>>& of);

    render::Renderer renderer;
    const CameraOptions options;
    GiveFrame giveFrame;
    Refusals refusals;
    std::atomic<bool> isListening = false;

    mutable std::mutex mutex; ///< of what follows
    std::condition_variable_any changed;
    FrameSchedule schedule;
    CameraCounters counters;
    std::vector<CameraIntrinsics> cameras;           ///< of the makers
    std::vector<std::shared_ptr<FrameMaker>> makers; ///< one a camera
    bool isBusy = true;                              ///< something may be there to be rendered

    std::vector<Rigid3> rigFromOptical; ///< of each camera; constant
    std::vector<Frame> frames;          ///< of the rendering thread, one a camera
    std::jthread thread;
};

void SimulatedCamera::State::putPart(OverlayPart part, Stamp stamp, const RawPicture& picture,
                                     std::size_t index) {
    CameraIntrinsics taken;
    {
        const std::scoped_lock lock(mutex);
        taken = overlayCamera(index);
    }
    OverlayParts parts = partOf(part, picture, taken); // without the lock, which rendering and poses want too
    const std::scoped_lock lock(mutex);
    OverlayParts* known = taken == overlayCamera(index) ? schedule.partsOf(stamp, index) : nullptr;
    if (known != nullptr) {
        known->take(std::move(parts));
        isBusy = true;
        changed.notify_all();
    }
}

void SimulatedCamera::State::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
        std::optional<DueFrame> due = schedule.next();
        if (!due) {
            isBusy = false;
            changed.notify_all();
            changed.wait(lock, stop, [this] { return isBusy; });
            continue;
        }
        const std::vector<std::shared_ptr<FrameMaker>> with = makers;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            frames[i].camera = cameras[i];
        }
        lock.unlock();
        std::optional<Error> failure;
        try {
            for (std::size_t i = 0; i < frames.size(); ++i) {
                make(*with[i], *due, i);
            }
            for (const Frame& frame : frames) {
                giveFrame(frame);
            }
        } catch (const Error& error) {
            failure = error;
        }
        lock.lock();
        if (failure) {
            refusals.add(Refusal::Rendering, failure->sentence());
        } else {
            countFrames();
        }
        if (with == makers) {
            countStreams(with);
        }
    }
}

void SimulatedCamera::State::make(FrameMaker& with, DueFrame& due, std::size_t index) {
    Frame& frame = frames[index];
    const Rigid3& roomFromCamera = due.roomFromCameras[index];
    std::array<render::Overlay, 1> overlay;
    render::ViewOptions view = options.view;
    view.overlays = {};
    if (!due.overlays.empty()) {
        const render::DatasetInfo& info = renderer.dataset().info();
        const std::size_t photo = renderer.dataset().nearestPhoto(roomFromCamera.translation);
        const render::SceneKind scene = view.scene.value_or(render::autoScene(info, photo, frame.camera));
        overlay[0] = with.objects->overlay(std::move(due.overlays[index]), roomFromCamera, scene);
        view.overlays = overlay;
    }
    frame.index = index;
    frame.stamp = due.stamp;
    frame.roomFromCamera = roomFromCamera;
    frame.baselineM = render::stereoBaselineM(frames.front().camera, frame.camera,
                                              due.roomFromCameras.front().inverse() * roomFromCamera);
    frame.poseTakenAt = due.takenAt;
    frame.overlay = !options.overlay        ? OverlayUse::NotWanted
                    : view.overlays.empty() ? OverlayUse::Missing
                                            : OverlayUse::Laid;
    const double stampS = secondsOf(due.stamp);
    const auto makeView = [&](const Rigid3& pose, double afterS, bool isMain, render::View& into) {
        view.wantsDepth = isMain && (options.wantsDepth || (with.sensor && with.sensor->needsDepth()));
        view.depthShowsOverlays = true;
        view.wantsTrust = isMain && options.view.wantsTrust;
        view.wantsLabels = isMain && options.wantsLabels;
        with.stream.next(pose, stampS + afterS, view, into);
    };
    if (!with.sensor) {
        makeView(roomFromCamera, 0, true, frame.view);
        return;
    }
    const auto number = static_cast<std::uint64_t>(due.stamp.count());
    frame.sensor = with.sensor->take(
        makeView, [&due, index](double afterS) { return poseAbout(due, index, afterS); }, 0, number,
        frame.view);
    with.sensor->measureDepth(number, frame.view.depth);
}

void SimulatedCamera::State::countFrames() {
    const auto any = [this](const auto& is) { return std::any_of(frames.begin(), frames.end(), is) ? 1 : 0; };
    ++counters.frames;
    counters.outside += any([](const Frame& frame) { return frame.view.report.isOutside; });
    counters.overlaysLaid += any([](const Frame& frame) { return frame.overlay == OverlayUse::Laid; });
    counters.overlaysMissing += any([](const Frame& frame) { return frame.overlay == OverlayUse::Missing; });
}

void SimulatedCamera::State::countStreams(const std::vector<std::shared_ptr<FrameMaker>>& of) {
    counters.stream = {};
    for (const std::shared_ptr<FrameMaker>& maker : of) {
        counters.stream += maker->stream.counters();
    }
}

SimulatedCamera::SimulatedCamera(const render::Renderer& renderer, const CameraModel& camera,
                                 const CameraOptions& options, GiveFrame giveFrame, Refusals::Tell tell)
    : SimulatedCamera(renderer, std::vector{MountedCamera{camera, {}}}, options, std::move(giveFrame),
                      std::move(tell)) {
}

SimulatedCamera::SimulatedCamera(const render::Renderer& renderer, const std::vector<MountedCamera>& cameras,
                                 const CameraOptions& options, GiveFrame giveFrame, Refusals::Tell tell)
    : m_state(std::make_unique<State>(renderer, cameras, options, std::move(giveFrame), std::move(tell))) {
}

SimulatedCamera::~SimulatedCamera() = default;

void SimulatedCamera::setListening(bool isListening) {
    if (m_state->isListening.exchange(isListening) != isListening && !isListening) {
        const std::scoped_lock lock(m_state->mutex);
        m_state->schedule.clear();
    }
}

bool SimulatedCamera::accepts(Stamp stamp, const Rigid3& pose) {
    const Eigen::Vector3d& at = pose.translation;
    if (stamp < Stamp::zero()) {
        refuse(Refusal::Time, text("A pose came for ", stamp.count(),
                                   " ns, before the simulation's beginning, and was not used."));
        return false;
    }
    if (!(at.cwiseAbs().maxCoeff() <= kFarthestM) || !at.allFinite()) {
        refuse(Refusal::Place, text("A pose at x ", at.x(), ", y ", at.y(), ", z ", at.z(),
                                    " came and was not used; places are finite and within 10^7 m."));
        return false;
    }
    if (!isPose(pose, kUnitTolerance)) {
        refuse(Refusal::Rotation, text("A pose with the rotation ", componentsOf(pose.rotation),
                                       " came and was not used; it is not a unit quaternion."));
        return false;
    }
    return true;
}

bool SimulatedCamera::isDue(Stamp stamp) const {
    const std::scoped_lock lock(m_state->mutex);
    return m_state->isListening && m_state->schedule.isDue(stamp);
}

void SimulatedCamera::takePose(Stamp stamp, const Rigid3& worldFromLink) {
    takePoses(stamp, std::vector<Rigid3>(m_state->rigFromOptical.size(), worldFromLink));
}

void SimulatedCamera::takePoses(Stamp stamp, const std::vector<Rigid3>& worldFromLinks) {
    const std::vector<Rigid3>& places = m_state->rigFromOptical;
    if (worldFromLinks.size() != places.size()) {
        throw Error(ErrorKind::InvalidInput, text("A rig of ", places.size(), " cameras cannot be at ",
                                                  worldFromLinks.size(), " poses."));
    }
    RigPose roomFromCameras;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!accepts(stamp, worldFromLinks[i])) {
            return;
        }
        const Rigid3 pose{worldFromLinks[i].rotation.normalized(), worldFromLinks[i].translation};
        roomFromCameras.push_back(m_state->options.mounting.roomFromOptical(pose) * places[i]);
    }
    const auto now = std::chrono::steady_clock::now();
    const std::scoped_lock lock(m_state->mutex);
    ++m_state->counters.poses;
    if (m_state->isListening) {
        m_state->schedule.addPose(stamp, roomFromCameras, now);
        m_state->isBusy = true;
        m_state->changed.notify_all();
    }
}

void SimulatedCamera::takeOverlay(OverlayPart part, Stamp stamp, const RawPicture& picture,
                                  std::size_t index) {
    if (!m_state->options.overlay || !m_state->isListening) {
        return;
    }
    if (stamp < Stamp::zero()) {
        refuse(Refusal::Time, text("A picture came for ", stamp.count(),
                                   " ns, before the simulation's beginning, and was not used."));
        return;
    }
    try {
        m_state->putPart(part, stamp, picture, index);
    } catch (const Error& error) {
        refuse(error.kind() == ErrorKind::Unsupported ? Refusal::Encoding : Refusal::Size, error.sentence());
    }
}

void SimulatedCamera::setCamera(const CameraModel& camera, std::size_t index) {
    State& state = *m_state;
    auto maker = std::make_shared<FrameMaker>(state.renderer, camera, state.options, index);
    const std::scoped_lock lock(state.mutex);
    state.makers[index] = std::move(maker);
    state.cameras[index] = camera.intrinsics();
    state.schedule.forgetOverlays();
}

void SimulatedCamera::refuse(Refusal kind, const std::string& sentence) {
    m_state->refusals.add(kind, sentence);
}

void SimulatedCamera::waitUntilIdle() {
    std::unique_lock lock(m_state->mutex);
    m_state->changed.wait(lock, [this] { return !m_state->isBusy; });
}

CameraCounters SimulatedCamera::counters() const {
    const std::scoped_lock lock(m_state->mutex);
    CameraCounters counters = m_state->counters;
    const FrameSchedule::Counters& schedule = m_state->schedule.counters();
    counters.dropped = schedule.dropped;
    counters.restarts = schedule.restarts;
    counters.overlaysUnused = schedule.overlaysUnused;
    counters.refused = m_state->refusals.counts();
    return counters;
}

} // namespace spherewalk::simulator
