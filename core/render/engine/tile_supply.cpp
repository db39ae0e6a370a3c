// SPDX-License-Identifier: Apache-2.0
#include "engine/tile_supply.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::render {

LateViews::LateViews(TileStore& store, std::shared_ptr<Thumbnails> thumbnails)
    : m_store(store), m_thumbnails(std::move(thumbnails)) {
}

Served LateViews::wait(const TileNeed& need, int threads) {
    Served served;
    served.photo = need.level.photo;
    served.lease = m_store.acquire(need.level, need.tiles, TileStore::Missing::Decode, threads);
    served.isLate = served.lease.waitedTiles() > 0;
    m_counters.late += served.isLate ? 1 : 0;
    m_counters.waited += served.isLate ? 1 : 0;
    m_previous = need.level.photo;
    return served;
}

std::optional<Served> LateViews::servePrevious(const TileNeed& need, const NeedOf& needOf) {
    if (!m_previous || *m_previous == need.level.photo) {
        return std::nullopt;
    }
    const std::optional<TileNeed> previous = needOf(*m_previous);
    if (!previous) {
        return std::nullopt;
    }
    Served served;
    served.photo = *m_previous;
    served.lease = m_store.acquire(previous->level, previous->tiles, TileStore::Missing::LeaveOut);
    if (!served.lease.isComplete()) {
        return std::nullopt;
    }
    served.origin = ViewOrigin::PreviousPhoto;
    return served;
}

Served LateViews::serve(const TileNeed& need, LatePolicy policy, const NeedOf& needOf, int threads) {
    ++m_counters.views;
    if (policy == LatePolicy::Wait) {
        return wait(need, threads);
    }
    Served served;
    served.photo = need.level.photo;
    served.lease = m_store.acquire(need.level, need.tiles, TileStore::Missing::LeaveOut);
    if (served.lease.isComplete()) {
        m_previous = need.level.photo;
        return served;
    }
    if (policy == LatePolicy::Previous) {
        if (std::optional<Served> previous = servePrevious(need, needOf)) {
            ++m_counters.late;
            ++m_counters.previous;
            previous->isLate = true;
            return std::move(*previous);
        }
    }
    served.coarse = m_thumbnails->get(need.level.photo);
    if (!served.coarse) {
        return wait(need, threads);
    }
    ++m_counters.late;
    ++m_counters.coarse;
    served.origin = ViewOrigin::Thumbnail;
    served.isLate = true;
    return served;
}

void LateViews::countSurfaceView(bool isLate) {
    ++m_counters.views;
    m_counters.late += isLate ? 1 : 0;
    m_counters.waited += isLate ? 1 : 0;
}

CameraMotion motionBetween(const Rigid3& from, const Rigid3& to, double seconds) {
    constexpr double kFastest = 1000;
    CameraMotion motion;
    if (!(seconds > 0)) {
        return motion;
    }
    motion.velocity = (to.translation - from.translation) / seconds;
    Eigen::Quaterniond turn = to.rotation * from.rotation.conjugate();
    if (turn.w() < 0) {
        turn.coeffs() = -turn.coeffs(); // the shorter way round
    }
    const double sine = turn.vec().norm();
    if (sine > 0) {
        motion.turnRate = turn.vec() * (2 * std::atan2(sine, turn.w()) / sine / seconds);
    }
    if (!motion.velocity.allFinite() || !motion.turnRate.allFinite() || motion.velocity.norm() > kFastest) {
        return {};
    }
    return motion;
}

Rigid3 predicted(const Rigid3& roomFromCamera, const CameraMotion& motion, double seconds) {
    Rigid3 pose = roomFromCamera;
    pose.translation += motion.velocity * seconds;
    const double angle = motion.turnRate.norm() * seconds;
    if (angle > 0) {
        const Eigen::AngleAxisd turn(angle, motion.turnRate.normalized());
        pose.rotation = (Eigen::Quaterniond(turn) * pose.rotation).normalized();
    }
    return pose;
}

std::vector<TileNeed> prefetchPlan(const Rigid3& roomFromCamera, const CameraMotion& motion,
                                   const PrefetchOptions& options, const std::stop_token& stop,
                                   const NeedOfView& needOfView) {
    std::vector<TileNeed> plan;
    const int steps =
        options.stepSeconds > 0
            ? static_cast<int>(std::clamp(options.horizonSeconds / options.stepSeconds, 0.0, 1e4))
            : 0;
    int tiles = 0;
    for (int step = 1; step <= steps && !stop.stop_requested(); ++step) {
        TileNeed need = needOfView(predicted(roomFromCamera, motion, step * options.stepSeconds));
        const auto found = std::find_if(plan.begin(), plan.end(),
                                        [&](const TileNeed& planned) { return planned.level == need.level; });
        const int before = found == plan.end() ? 0 : found->tiles.count();
        if (found != plan.end()) {
            need.tiles.merge(found->tiles);
        }
        tiles += need.tiles.count() - before;
        if (tiles > options.mostTiles) {
            break;
        }
        if (found == plan.end()) {
            plan.push_back(std::move(need));
        } else {
            *found = std::move(need);
        }
    }
    return plan;
}

Prefetcher::Prefetcher(TileStore& store, std::function<bool(const std::stop_token&)> whenIdle)
    : m_store(store),
      m_whenIdle(std::move(whenIdle)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

Prefetcher::~Prefetcher() {
    m_thread.request_stop();
    const std::scoped_lock lock(m_mutex);
    m_planStop.request_stop();
}

void Prefetcher::setPlan(MakePlan makePlan) {
    {
        const std::scoped_lock lock(m_mutex);
        m_planStop.request_stop();
        m_makePlan = std::move(makePlan);
        m_hasNewPlan = true;
        m_isIdle = false;
    }
    m_changed.notify_all();
}

void Prefetcher::waitUntilIdle() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_isIdle; });
}

void Prefetcher::run(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, stop, [&] { return m_hasNewPlan; })) {
        const MakePlan makePlan = std::exchange(m_makePlan, {});
        m_hasNewPlan = false;
        m_planStop = std::stop_source();
        if (stop.stop_requested()) {
            return; // it may have come between the wait and the new source
        }
        const std::stop_token planStop = m_planStop.get_token();
        lock.unlock();
        for (const TileNeed& need : makePlan(planStop)) {
            if (planStop.stop_requested()) {
                break;
            }
            m_store.prefetch(need.level, need.tiles, planStop);
        }
        try {
            while (m_whenIdle && !planStop.stop_requested() && m_whenIdle(planStop)) {
            }
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Stopped) {
                throw; // a defect of the caller
            }
        }
        lock.lock();
        m_isIdle = !m_hasNewPlan;
        m_changed.notify_all();
    }
}

} // namespace spherewalk::render
