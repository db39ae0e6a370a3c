// SPDX-License-Identifier: Apache-2.0
#include "prefetch.h"

#include "spherewalk/base/error.h"

#include <utility>

namespace spherewalk::render {

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
