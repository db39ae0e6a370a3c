// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif
#ifndef __cpp_lib_atomic_wait // of GCC 10
#include <climits>

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace spherewalk {

namespace {

constexpr int kSpins = 4000; // about ten microseconds

void pauseBriefly() {
#if defined(__x86_64__) || defined(__i386__)
    _mm_pause();
#else
    std::this_thread::yield();
#endif
}

/// Sleeps until the value is another.
template <class Number>
void waitWhile(const std::atomic<Number>& value, Number old) {
#ifdef __cpp_lib_atomic_wait
    value.wait(old);
#else
    static_assert(sizeof value == sizeof(std::uint32_t));
    while (value.load() == old) {
        ::syscall(SYS_futex, &value, FUTEX_WAIT_PRIVATE, old, nullptr, nullptr, 0);
    }
#endif
}

/// Wakes all who sleep until the value is another.
template <class Number>
void wakeAll(std::atomic<Number>& value) {
#ifdef __cpp_lib_atomic_wait
    value.notify_all();
#else
    ::syscall(SYS_futex, &value, FUTEX_WAKE_PRIVATE, INT_MAX, nullptr, nullptr, 0);
#endif
}

/// One word holds the number of the current run (16 bits), its count of items (24) and the next item (24).
/// A thread that comes late to a run that has ended therefore takes no item and touches nothing of the run.
using Ticket = std::uint64_t;

constexpr Ticket ticket(Ticket run, int count) {
    return run << 48 | static_cast<Ticket>(count) << 24;
}

constexpr int countOf(Ticket value) {
    return static_cast<int>(value >> 24 & 0xFFFFFF);
}

constexpr int nextOf(Ticket value) {
    return static_cast<int>(value & 0xFFFFFF);
}

} // namespace

int hardwareThreads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelFor(int count, int grain, int threads, const std::function<void(int, int)>& body) {
    grain = std::max(1, grain);
    const int pieces = (count + grain - 1) / grain;
    const int workers = std::min(threads > 0 ? threads : hardwareThreads(), pieces);
    std::atomic<int> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (int piece = next++; piece < pieces; piece = next++) {
            try {
                body(piece * grain, std::min(count, (piece + 1) * grain));
            } catch (...) { // handed to the caller below
                const std::scoped_lock lock(mutex);
                failure = failure ? failure : std::current_exception();
                next = pieces;
            }
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < workers; ++i) {
            others.emplace_back(work);
        }
        work();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

namespace {

/// Tasks that need others' results.
class Tasks {
  public:
    explicit Tasks(std::span<const std::vector<int>> needs)
        : m_lacking(needs.size()), m_neededBy(needs.size()) {
        for (std::size_t task = 0; task < needs.size(); ++task) {
            m_lacking[task] = needs[task].size();
            for (const int other : needs[task]) {
                m_neededBy[static_cast<std::size_t>(other)].push_back(task);
            }
            if (needs[task].empty()) {
                m_ready.insert(task);
            }
        }
    }

    /// Takes part until nothing is left to begin.
    void work(const std::function<void(int)>& body) {
        std::unique_lock lock(m_mutex);
        while (!m_hasFailed) {
            if (!m_ready.empty()) {
                perform(*m_ready.begin(), body, lock);
            } else if (m_running > 0) {
                m_change.wait(lock);
            } else {
                return;
            }
        }
    }

  private:
    void perform(std::size_t task, const std::function<void(int)>& body, std::unique_lock<std::mutex>& lock) {
        m_ready.erase(task);
        ++m_running;
        lock.unlock();
        try {
            body(static_cast<int>(task));
        } catch (...) { // the others end, too
            lock.lock();
            m_hasFailed = true;
            m_change.notify_all();
            throw;
        }
        lock.lock();
        --m_running;
        for (const std::size_t other : m_neededBy[task]) {
            if (--m_lacking[other] == 0) {
                m_ready.insert(other);
            }
        }
        m_change.notify_all();
    }

    std::vector<std::size_t> m_lacking; ///< How many tasks each one waits for.
    std::vector<std::vector<std::size_t>> m_neededBy;
    std::set<std::size_t> m_ready;
    int m_running = 0;
    bool m_hasFailed = false;
    std::mutex m_mutex;
    std::condition_variable m_change;
};

} // namespace

void parallelTasks(std::span<const std::vector<int>> needs, int threads,
                   const std::function<void(int)>& body) {
    Tasks tasks(needs);
    const int workers = std::min(threads > 0 ? threads : hardwareThreads(), static_cast<int>(needs.size()));
    parallelFor(workers, 1, workers, [&](int, int) { tasks.work(body); });
}

struct WorkerPool::State {
    std::atomic<Ticket> ticket{0};
    std::atomic<std::uint32_t> runs{0}; ///< Grows with each run; sleeping threads wait on it.
    std::atomic<int> allowed{1};        ///< Workers with a lower number may take items.
    std::atomic<int> open{0};           ///< The number of items that are not done.
    std::atomic<bool> ending{false};
    Ticket number = 0; ///< The number of the current run.
    const std::function<void(int, int)>* body = nullptr;
    std::mutex running;
    std::mutex failing;
    std::exception_ptr failure;
    std::vector<std::jthread> others;

    void takeItems(int worker) {
        for (Ticket now = ticket.load(); nextOf(now) < countOf(now);) {
            if (!ticket.compare_exchange_weak(now, now + 1)) {
                continue;
            }
            // The run cannot end while this item is open, so its body is there.
            perform(nextOf(now), worker);
            if (open.fetch_sub(1) == 1) {
                wakeAll(open);
            }
            now = ticket.load();
        }
    }

    void perform(int item, int worker) {
        {
            const std::scoped_lock lock(failing);
            if (failure) {
                return;
            }
        }
        try {
            (*body)(item, worker);
        } catch (...) { // handed to the caller of run()
            const std::scoped_lock lock(failing);
            failure = failure ? failure : std::current_exception();
        }
    }

    void work(int worker) {
        std::uint32_t seen = 0;
        while (true) {
            for (int spin = 0; runs.load() == seen && spin < kSpins; ++spin) {
                pauseBriefly();
            }
            waitWhile(runs, seen);
            if (ending) {
                return;
            }
            seen = runs.load();
            if (worker < allowed) {
                takeItems(worker);
            }
        }
    }
};

WorkerPool::WorkerPool(int threads) : m_state(std::make_unique<State>()) {
    const int count = threads > 0 ? threads : hardwareThreads();
    for (int worker = 1; worker < count; ++worker) {
        m_state->others.emplace_back([worker, state = m_state.get()] { state->work(worker); });
    }
}

WorkerPool::~WorkerPool() {
    m_state->ending = true;
    ++m_state->runs;
    wakeAll(m_state->runs);
}

int WorkerPool::threads() const {
    return static_cast<int>(m_state->others.size()) + 1;
}

void WorkerPool::run(int count, int threads, const std::function<void(int, int)>& body) {
    State& state = *m_state;
    const std::scoped_lock lock(state.running);
    if (count <= 0) {
        return;
    }
    state.failure = nullptr;
    state.body = &body;
    state.allowed = threads > 0 ? threads : this->threads();
    state.open = count;
    state.ticket = ticket(++state.number, count);
    if (state.allowed > 1 && !state.others.empty()) {
        ++state.runs;
        wakeAll(state.runs);
    }
    state.takeItems(0);
    for (int spin = 0; state.open.load() != 0 && spin < kSpins; ++spin) {
        pauseBriefly();
    }
    for (int left = state.open.load(); left != 0; left = state.open.load()) {
        waitWhile(state.open, left);
    }
    state.body = nullptr;
    if (state.failure) {
        std::rethrow_exception(std::exchange(state.failure, nullptr));
    }
}

} // namespace spherewalk
