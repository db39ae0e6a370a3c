// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/simulated_camera.h"

#include "frame_schedule.h"
#include "object_overlay.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

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
    FrameMaker(const render::Renderer& renderer, const CameraModel& model, const CameraOptions& options)
        : stream(renderer, model, options.stream) {
        if (options.overlay) {
            objects.emplace(*options.overlay, options.wantsLabels, renderer.dataset().info(),
                            options.overlay->camera.value_or(model.intrinsics()), options.view.threads);
        }
        if (options.sensor) {
            sensor.emplace(*options.sensor, model, options.view.threads);
        }
    }

    render::ViewStream stream;
    std::optional<ObjectOverlay> objects;
    std::optional<render::Sensor> sensor;
};

double secondsOf(Stamp stamp) {
    return std::chrono::duration<double>(stamp).count();
}

/// The camera's pose about a frame's time, counted from the frame's stamp. A jump is no motion.
Rigid3 poseAbout(const DueFrame& due, double afterS) {
    constexpr double kFastestMS = 100;
    const double lengthS = due.before ? secondsOf(due.stamp - due.before->stamp) : 0;
    if (!(lengthS > 0) || (due.roomFromCamera.translation - due.before->roomFromCamera.translation).norm() >
                              kFastestMS * lengthS) {
        return due.roomFromCamera;
    }
    return interpolated(due.before->roomFromCamera, due.roomFromCamera, 1 + afterS / lengthS);
}

struct SimulatedCamera::State {
    State(render::Renderer sharedRenderer, const CameraModel& model, const CameraOptions& wanted,
          GiveFrame give, Refusals::Tell tell)
        : renderer(std::move(sharedRenderer)),
          options(checked(wanted)),
          giveFrame(std::move(give)),
          refusals(std::move(tell)),
          schedule(options),
          maker(std::make_shared<FrameMaker>(renderer, model, options)) {
        frame.camera = model.intrinsics();
        camera = model.intrinsics();
        thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
    }

    static const CameraOptions& checked(const CameraOptions& options) {
        options.validate();
        return options;
    }

    const CameraIntrinsics& overlayCamera() const {
        return options.overlay->camera ? *options.overlay->camera : camera;
    }

    void putPart(OverlayPart part, Stamp stamp, const RawPicture& picture);
    void work(const std::stop_token& stop);
    void make(FrameMaker& with, DueFrame due);
    void countFrame();

    render::Renderer renderer;
    const CameraOptions options;
    GiveFrame giveFrame;
    Refusals refusals;
    std::atomic<bool> isListening = false;

    mutable std::mutex mutex; ///< of what follows
    std::condition_variable_any changed;
    FrameSchedule schedule;
    CameraCounters counters;
    CameraIntrinsics camera; ///< of the maker
    std::shared_ptr<FrameMaker> maker;
    bool isBusy = true; ///< something may be there to be rendered

    Frame frame; ///< of the rendering thread
    std::jthread thread;
};

void SimulatedCamera::State::putPart(OverlayPart part, Stamp stamp, const RawPicture& picture) {
    CameraIntrinsics taken;
    {
        const std::scoped_lock lock(mutex);
        taken = overlayCamera();
    }
    OverlayParts parts = partOf(part, picture, taken); // without the lock, which rendering and poses want too
    const std::scoped_lock lock(mutex);
    OverlayParts* known = taken == overlayCamera() ? schedule.partsOf(stamp) : nullptr;
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
        const std::shared_ptr<FrameMaker> with = maker;
        frame.camera = camera;
        lock.unlock();
        std::optional<Error> failure;
        try {
            make(*with, std::move(*due));
            giveFrame(frame);
        } catch (const Error& error) {
            failure = error;
        }
        lock.lock();
        if (failure) {
            refusals.add(Refusal::Rendering, failure->sentence());
        } else {
            countFrame();
        }
        if (with == maker) {
            counters.stream = with->stream.counters();
        }
    }
}

void SimulatedCamera::State::make(FrameMaker& with, DueFrame due) {
    std::array<render::Overlay, 1> overlay;
    render::ViewOptions view = options.view;
    view.overlays = {};
    if (due.overlay) {
        const render::DatasetInfo& info = renderer.dataset().info();
        const std::size_t photo = renderer.dataset().nearestPhoto(due.roomFromCamera.translation);
        const render::SceneKind scene = view.scene.value_or(render::autoScene(info, photo, frame.camera));
        overlay[0] = with.objects->overlay(std::move(*due.overlay), due.roomFromCamera, scene);
        view.overlays = overlay;
    }
    frame.stamp = due.stamp;
    frame.roomFromCamera = due.roomFromCamera;
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
        makeView(due.roomFromCamera, 0, true, frame.view);
        return;
    }
    const auto number = static_cast<std::uint64_t>(due.stamp.count());
    frame.sensor = with.sensor->take(
        makeView, [&due](double afterS) { return poseAbout(due, afterS); }, 0, number, frame.view);
    with.sensor->measureDepth(number, frame.view.depth);
}

void SimulatedCamera::State::countFrame() {
    ++counters.frames;
    counters.outside += frame.view.report.isOutside ? 1 : 0;
    counters.overlaysLaid += frame.overlay == OverlayUse::Laid ? 1 : 0;
    counters.overlaysMissing += frame.overlay == OverlayUse::Missing ? 1 : 0;
}

SimulatedCamera::SimulatedCamera(const render::Renderer& renderer, const CameraModel& camera,
                                 const CameraOptions& options, GiveFrame giveFrame, Refusals::Tell tell)
    : m_state(std::make_unique<State>(renderer, camera, options, std::move(giveFrame), std::move(tell))) {
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

void SimulatedCamera::takePose(Stamp stamp, const Rigid3& worldFromLink) {
    if (!accepts(stamp, worldFromLink)) {
        return;
    }
    const Rigid3 pose{worldFromLink.rotation.normalized(), worldFromLink.translation};
    const Rigid3 roomFromOptical = m_state->options.mounting.roomFromOptical(pose);
    const auto now = std::chrono::steady_clock::now();
    const std::scoped_lock lock(m_state->mutex);
    ++m_state->counters.poses;
    if (m_state->isListening) {
        m_state->schedule.addPose(stamp, roomFromOptical, now);
        m_state->isBusy = true;
        m_state->changed.notify_all();
    }
}

void SimulatedCamera::takeOverlay(OverlayPart part, Stamp stamp, const RawPicture& picture) {
    if (!m_state->options.overlay || !m_state->isListening) {
        return;
    }
    if (stamp < Stamp::zero()) {
        refuse(Refusal::Time, text("A picture came for ", stamp.count(),
                                   " ns, before the simulation's beginning, and was not used."));
        return;
    }
    try {
        m_state->putPart(part, stamp, picture);
    } catch (const Error& error) {
        refuse(error.kind() == ErrorKind::Unsupported ? Refusal::Encoding : Refusal::Size, error.sentence());
    }
}

void SimulatedCamera::setCamera(const CameraModel& camera) {
    State& state = *m_state;
    auto maker = std::make_shared<FrameMaker>(state.renderer, camera, state.options);
    const std::scoped_lock lock(state.mutex);
    state.maker = std::move(maker);
    state.camera = camera.intrinsics();
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
