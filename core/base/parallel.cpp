// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace spherewalk {

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

} // namespace spherewalk
