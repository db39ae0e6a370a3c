// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view_stream.h"

#include "engine/tile_supply.h"
#include "engine/view_engine.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <optional>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr int kMostTilesAhead = 6000;
/// See NeedOfView: paths bend.
constexpr double kPredictionReachPx = 24;

constexpr EnumNames<LatePolicy, 3> kPolicyNames{
    {{LatePolicy::Wait, "wait"}, {LatePolicy::Coarse, "coarse"}, {LatePolicy::Previous, "previous"}}};

} // namespace

std::string_view name(LatePolicy policy) {
    return nameOf(kPolicyNames, policy);
}

LatePolicy latePolicy(std::string_view name) {
    return valueOf(kPolicyNames, "The policy for late views", name);
}

struct ViewStream::State {
    /// The camera's pose at a time on the caller's clock.
    struct Step {
        Rigid3 roomFromCamera;
        double timeS = 0;
    };

    /// The way from one photo to another.
    struct Passage {
        std::vector<std::size_t> from; ///< The photos before; empty while there is no passage.
        Eigen::Vector3d pBefore = Eigen::Vector3d::Zero(); ///< The camera of the view before.
        double wayM = 0; ///< How far the camera has come since it left them.
    };

    State(std::shared_ptr<ViewEngine> sharedEngine, const CameraModel& model, const StreamOptions& wanted)
        : engine(std::move(sharedEngine)),
          camera(model),
          options(wanted),
          late(engine->lateViews()),
          prefetcher(engine->store(),
                     [this](const std::stop_token& stop) { return engine->verifyNext(stop); }) {}

    ViewRequest request(const Rigid3& roomFromCamera, const ViewOptions& view);
    FormerPhotos pass(const ViewRequest& request, const std::vector<std::size_t>& shownBefore);
    void prefetch(const ViewRequest& request, double timeS);

    std::shared_ptr<ViewEngine> engine;
    CameraModel camera;
    StreamOptions options;
    LateViews late;
    std::optional<Step> before;
    std::vector<std::size_t> held; ///< The photos of the view before.
    Passage passage;
    Prefetcher prefetcher; ///< The last member: its thread uses the others.
};

/// The request for the next view, with the photos that it will be made from.
ViewRequest ViewStream::State::request(const Rigid3& roomFromCamera, const ViewOptions& view) {
    ViewRequest request = engine->request(camera, roomFromCamera, view);
    request.held = held;
    request.held = engine->photosOf(request);
    request.former = pass(request, held);
    held = request.held;
    return request;
}

/// Goes on along the way from one photo to another, or begins it. Each photo counts by the way, not by the
/// time, so that a camera that stands still has a picture that stands still.
FormerPhotos ViewStream::State::pass(const ViewRequest& request,
                                     const std::vector<std::size_t>& shownBefore) {
    const Eigen::Vector3d& pInRoom = request.roomFromCamera.translation;
    const double stepM = (pInRoom - std::exchange(passage.pBefore, pInRoom)).norm();
    if (!shownBefore.empty() && shownBefore.front() != request.held.front()) {
        passage.from = shownBefore;
        passage.wayM = 0;
    }
    passage.wayM += stepM;
    if (passage.from.empty() || !(passage.wayM < options.passageM) ||
        !engine->passesSoftly(request, passage.from)) {
        passage.from.clear();
        return {};
    }
    return {passage.from, 1 - passage.wayM / options.passageM};
}

/// The view's own tiles come first: after LatePolicy::Coarse or Previous they are still wanted.
void ViewStream::State::prefetch(const ViewRequest& request, double timeS) {
    CameraMotion motion;
    PrefetchOptions ahead{0, 0, kMostTilesAhead};
    if (before && timeS > before->timeS) {
        ahead.horizonSeconds = options.prefetchSeconds;
        ahead.stepSeconds = timeS - before->timeS;
        motion = motionBetween(before->roomFromCamera, request.roomFromCamera, ahead.stepSeconds);
    }
    ViewOptions view = request.options;
    view.overlays = {}; // they live until this view is made only
    prefetcher.setPlan([this, motion, ahead, view, pose = request.roomFromCamera,
                        photos = request.held](const std::stop_token& stop) {
        const auto needAt = [&](const Rigid3& predicted) {
            return engine->need({camera, predicted, view, photos, {}}, kPredictionReachPx);
        };
        std::vector<TileNeed> plan = prefetchPlan(pose, motion, ahead, stop, needAt);
        plan.insert(plan.begin(), engine->need({camera, pose, view, photos, {}}));
        return plan;
    });
    before = {request.roomFromCamera, timeS};
}

ViewStream::ViewStream(const Renderer& renderer, const CameraModel& camera, const StreamOptions& options) {
    if (!(options.prefetchSeconds >= 0 && options.prefetchSeconds <= 10)) {
        throw Error(ErrorKind::InvalidInput, text("A stream cannot look ", options.prefetchSeconds,
                                                  " s ahead; give a time from 0 to 10 s."));
    }
    if (!(options.passageM >= 0 && options.passageM <= 1)) {
        throw Error(ErrorKind::InvalidInput, text("A passage from photo to photo cannot take ",
                                                  options.passageM, " m; give a way from 0 to 1 m."));
    }
    m_state = std::make_unique<State>(renderer.m_engine, camera, options);
}

ViewStream::~ViewStream() = default;
ViewStream::ViewStream(ViewStream&&) noexcept = default;
ViewStream& ViewStream::operator=(ViewStream&&) noexcept = default;

View ViewStream::next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options) {
    View view;
    next(roomFromCamera, timeS, options, view);
    return view;
}

void ViewStream::next(const Rigid3& roomFromCamera, double timeS, const ViewOptions& options, View& view) {
    State& state = *m_state;
    const ViewRequest request = state.request(roomFromCamera, options);
    state.engine->serve(request, state.options.late, state.late, view);
    state.prefetch(request, timeS);
}

void ViewStream::pass(const Rigid3& roomFromCamera, const ViewOptions& options) {
    m_state->request(roomFromCamera, options);
}

const StreamCounters& ViewStream::counters() const {
    return m_state->late.counters();
}

void ViewStream::waitForPrefetch() {
    m_state->prefetcher.waitUntilIdle();
}

} // namespace spherewalk::render
