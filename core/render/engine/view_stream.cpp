// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view_stream.h"

#include "prefetch.h"
#include "view_engine.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <optional>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr int kMostTilesAhead = 6000;
// Paths bend: see NeedOfView.
constexpr double kPredictionReachPx = 24;

constexpr EnumNames<LatePolicy, 3> kPolicies{
    {{LatePolicy::Wait, "wait"}, {LatePolicy::Coarse, "coarse"}, {LatePolicy::Previous, "previous"}}};

struct Step {
    Rigid3 roomFromCamera;
    double timeS = 0;
};

} // namespace

std::string_view name(LatePolicy policy) {
    return nameOf(kPolicies, policy);
}

LatePolicy latePolicy(std::string_view name) {
    return valueOf(kPolicies, "The policy for late views", name);
}

struct ViewStream::State {
    State(std::shared_ptr<ViewEngine> sharedEngine, const CameraModel& model, const StreamOptions& wanted)
        : engine(std::move(sharedEngine)),
          camera(model),
          options(wanted),
          loader(engine->store(), engine->thumbnails()),
          prefetcher(engine->store(),
                     [this](const std::stop_token& stop) { return engine->photos().verifyNext(stop); }) {}

    TileNeed needOf(const ViewRequest& request, std::size_t photo, double reachPx) const {
        return engine->need(request, engine->plan(request, photo), reachPx);
    }

    void prefetch(const ViewRequest& request, double timeS, TileNeed own);

    std::shared_ptr<ViewEngine> engine;
    CameraModel camera;
    StreamOptions options;
    ViewLoader loader;
    std::optional<Step> before;
    Prefetcher prefetcher; ///< last: its thread uses the others
};

/// The view's own tiles come first: after LatePolicy::Coarse or Previous they are still wanted.
void ViewStream::State::prefetch(const ViewRequest& request, double timeS, TileNeed own) {
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
                        own = std::move(own)](const std::stop_token& stop) {
        std::vector<TileNeed> plan = prefetchPlan(pose, motion, ahead, stop, [&](const Rigid3& predicted) {
            const ViewRequest next{camera, predicted, view};
            return needOf(next, engine->nearestPhoto(next), kPredictionReachPx);
        });
        plan.insert(plan.begin(), own);
        return plan;
    });
}

ViewStream::ViewStream(const Renderer& renderer, const CameraModel& camera, const StreamOptions& options) {
    if (!(options.prefetchSeconds >= 0 && options.prefetchSeconds <= 10)) {
        throw Error(ErrorKind::InvalidInput, text("A stream cannot look ", options.prefetchSeconds,
                                                  " s ahead; give a time from 0 to 10 s."));
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
    ViewEngine& engine = *state.engine;
    const ViewRequest request = engine.checked(state.camera, roomFromCamera, options);
    const ViewPlan plan = engine.plan(request, engine.nearestPhoto(request));
    TileNeed need = engine.need(request, plan);
    {
        const TileStore::ViewInProgress inProgress(engine.store());
        if (plan.surface) { // whatever the policy: there is no coarse picture of several photos
            engine.makeFromSurfaces(request, plan, view);
            state.loader.countSurfaceView(view.report.isLate);
        } else {
            const Served served = state.loader.serve(
                need, state.options.late,
                [&](std::size_t photo) { return engine.need(request, engine.plan(request, photo)); },
                options.threads);
            switch (served.origin) {
            case ViewOrigin::Photo:
                engine.make(request, plan, served, view);
                break;
            case ViewOrigin::Thumbnail:
                engine.make(request, engine.coarse(request, plan), served, view);
                break;
            case ViewOrigin::PreviousPhoto:
                engine.make(request, engine.plan(request, served.photo), served, view);
                break;
            }
        }
    }
    state.prefetch(request, timeS, std::move(need));
    state.before = {request.roomFromCamera, timeS};
}

const StreamCounters& ViewStream::counters() const {
    return m_state->loader.counters();
}

void ViewStream::waitForPrefetch() {
    m_state->prefetcher.waitUntilIdle();
}

} // namespace spherewalk::render
