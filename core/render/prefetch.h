// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "prefetch_path.h"
#include "tile_store.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace spherewalk::render {

/// Decodes ahead of the views, in a thread of its own that gives way to them. Threads: all functions may be
/// called from any.
class Prefetcher {
  public:
    /// whenIdle: called again and again while nothing is left to decode, until it returns false; then not
    /// before the next plan. It must not throw but Error{Stopped}. Owner: the store must outlive this.
    explicit Prefetcher(TileStore& store, std::function<bool(const std::stop_token&)> whenIdle = {});
    /// Stops within one block of tiles.
    ~Prefetcher();
    Prefetcher(const Prefetcher&) = delete;
    Prefetcher& operator=(const Prefetcher&) = delete;

    /// Called in the prefetcher's thread; ends early when stopped. Must not throw.
    using MakePlan = std::function<std::vector<TileNeed>(const std::stop_token&)>;

    /// Replaces what is to be decoded, in the plan's order; what the old plan was doing is left after the
    /// block that is being decoded.
    void setPlan(MakePlan makePlan);

    /// Returns when the plan, and what whenIdle does, is done.
    void waitUntilIdle();

  private:
    void run(const std::stop_token& stop);

    TileStore& m_store;
    std::function<bool(const std::stop_token&)> m_whenIdle;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    MakePlan m_makePlan;
    bool m_hasNewPlan = false;
    bool m_isIdle = true;
    std::stop_source m_planStop;
    std::jthread m_thread; ///< last: ends before what it uses
};

} // namespace spherewalk::render
