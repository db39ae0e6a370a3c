// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "measurements.h"
#include "walk_path.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/view_stream.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::bench {

using render::LatePolicy;
using SteadyClock = std::chrono::steady_clock;

namespace {

constexpr double kFrameS = 1.0 / 30;
constexpr int kLeadIn = 10;      // a third of a second: what was cold is caught up with
constexpr double kTurnRad = 0.5; // to each side
constexpr double kTurnRate = 0.7;

struct Policy {
    LatePolicy late;
    bool prefetch;
};

constexpr std::array<Policy, 4> kPolicies{{{LatePolicy::Wait, true},
                                           {LatePolicy::Coarse, true},
                                           {LatePolicy::Previous, true},
                                           {LatePolicy::Wait, false}}};

Rigid3 poseAt(const StationPath& path, double speedMS, double timeS) {
    return {yawRotation(Radians(kTurnRad * std::sin(kTurnRate * timeS))) * bodyFromOptical(),
            path.at(speedMS * timeS)};
}

render::StreamOptions streamOptions(const Policy& policy) {
    render::StreamOptions options;
    options.late = policy.late;
    options.prefetchSeconds = policy.prefetch ? options.prefetchSeconds : 0;
    return options;
}

WalkRow walkOnce(const std::shared_ptr<const render::Dataset>& dataset, const StationPath& path,
                 const WalkRow& wanted, int views, const std::stop_token& stop) {
    const render::Renderer renderer(dataset);
    render::ViewStream stream(renderer, standardCamera(90), streamOptions({wanted.policy, wanted.prefetch}));
    render::View view;
    WalkRow row = wanted;
    std::vector<double> timesMs;
    int late = 0;
    const auto start = SteadyClock::now();
    for (int i = 0; i < views + kLeadIn; ++i) {
        const double timeS = i * kFrameS;
        const auto due =
            start + std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(timeS));
        systemClock().sleep(due - SteadyClock::now(), stop);
        throwIfStopped(stop);
        const auto begin = SteadyClock::now();
        stream.next(poseAt(path, wanted.speedMS, timeS), timeS, {}, view);
        if (i < kLeadIn) {
            row.lateAtStart += view.report.isLate ? 1 : 0;
        } else {
            timesMs.push_back(millisecondsSince(begin));
            late += view.report.isLate ? 1 : 0;
        }
    }
    const auto missed =
        std::count_if(timesMs.begin(), timesMs.end(), [](double timeMs) { return timeMs > 1000 * kFrameS; });
    row.views = views;
    row.lateShare = static_cast<double>(late) / views;
    row.missedShare = static_cast<double>(missed) / views;
    row.p99Ms = quantile(timesMs, 0.99);
    return row;
}

} // namespace

std::vector<WalkRow> measureWalks(const std::shared_ptr<const render::Dataset>& dataset,
                                  const WalkOptions& options, ProgressSink& progress,
                                  const std::stop_token& stop) {
    const StationPath path(serpentine(dataset->info()));
    const std::size_t count = options.speedsMS.size() * kPolicies.size();
    std::vector<WalkRow> rows;
    for (const double speedMS : options.speedsMS) {
        for (const Policy& policy : kPolicies) {
            WalkRow wanted;
            wanted.speedMS = speedMS;
            wanted.policy = policy.late;
            wanted.prefetch = policy.prefetch;
            rows.push_back(walkOnce(dataset, path, wanted, options.views, stop));
            progress.progress(static_cast<double>(rows.size()) / static_cast<double>(count),
                              text("Walking at ", speedMS, " m/s"));
        }
    }
    return rows;
}

std::size_t lookAllRound(const std::shared_ptr<const render::Dataset>& dataset, std::size_t mostPhotos,
                         ProgressSink& progress, const std::stop_token& stop) {
    constexpr int kLooks = 4;
    const render::Renderer renderer(dataset);
    const CameraModel camera = standardCamera(90);
    const std::size_t count = std::min(mostPhotos, dataset->info().photos.size());
    render::View view;
    for (std::size_t i = 0; i < count; ++i) {
        for (int look = 0; look < kLooks; ++look) {
            throwIfStopped(stop);
            const Rigid3& roomFromPhoto = dataset->info().photos[i].roomFromPhoto;
            renderer.render(camera, roomFromPhoto * lookingTo(90.0 * look, 0), {}, view);
        }
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(count),
                          "Looking all round at each photo");
    }
    return count;
}

} // namespace spherewalk::bench
