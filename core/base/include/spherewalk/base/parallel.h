// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace spherewalk {

/// The number of threads that the machine runs at the same time, at least one.
int hardwareThreads();

/// Splits [0, count) into pieces of at most `grain` and calls body(begin, end) once for each piece.
/// Up to `threads` threads work (0: one for each of the machine's); the call returns when all are done.
/// Errors: the first exception of a body is rethrown after all threads have ended. Pieces that had not begun
/// by then are skipped.
void parallelFor(int count, int grain, int threads, const std::function<void(int begin, int end)>& body);

/// Calls body(task) once for each task in [0, needs.size()), up to `threads` at a time (0: one for each of
/// the machine's). A task begins when all that it needs have ended, and of those that can begin, the first
/// comes first. Range: no task needs itself, by way of others either. Errors: as those of parallelFor().
void parallelTasks(std::span<const std::vector<int>> needs, int threads,
                   const std::function<void(int task)>& body);

/// Threads that are started once and then wait for work. The pool is for work so short that starting threads
/// would cost as much: a camera's view takes less than a millisecond. Between two runs the threads spin for
/// about ten microseconds and then sleep.
class WorkerPool {
  public:
    /// `threads` workers share a run, and the caller's thread is one of them (0: one for each of the
    /// machine's).
    explicit WorkerPool(int threads = 0);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// The number of workers, with the caller's thread.
    int threads() const;

    /// Calls body(item, worker) once for each item in [0, count) and returns when all calls have ended.
    /// At most `threads` workers take part (0: all of the pool), the caller's thread among them. The argument
    /// `worker` is in [0, threads()) and never the same in two calls at the same time. Which worker gets
    /// which item is left to chance.
    /// Range: count < 2^24. Errors: the first exception of a body is rethrown when all calls have ended; the
    /// remaining items are skipped. Threads: one run at a time; a second run waits for the first.
    void run(int count, int threads, const std::function<void(int item, int worker)>& body);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk
