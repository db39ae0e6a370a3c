// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

namespace spherewalk {

/// Threads that are started once and wait for work, for work so short that starting threads would cost as
/// much as the work itself (a view of a camera is done in less than a millisecond). Between two runs they
/// spin for some ten microseconds and then sleep.
class WorkerPool {
  public:
    /// threads: that work on a run at a time, the caller's own among them; 0: all that the machine has.
    explicit WorkerPool(int threads = 0);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    int threads() const;

    /// Calls body(item, worker) once for each item in [0, count), on the caller's thread and at most
    /// `threads` - 1 others (0: all of the pool), and returns when all are done. worker: in [0, threads()),
    /// and never the same in two calls at a time. Which worker gets which item is left to chance. Range:
    /// count < 2^24. Errors: the first exception of a body is rethrown when all that had begun have ended;
    /// the remaining items are left out. Threads: one run at a time; a second one waits for it.
    void run(int count, int threads, const std::function<void(int item, int worker)>& body);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk
