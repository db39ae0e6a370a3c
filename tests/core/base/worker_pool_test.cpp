// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/worker_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace spherewalk {

TEST(WorkerPool, DoesEachItemOnceForAnyNumberOfThreads) {
    for (const int threads : {1, 2, 3, 8}) {
        WorkerPool pool(threads);
        EXPECT_EQ(pool.threads(), threads);
        for (int run = 0; run < 500; ++run) {
            const int count = run % 37;
            std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
            pool.run(count, run % 5, [&](int item, int) { ++done[static_cast<std::size_t>(item)]; });
            for (const auto& times : done) {
                ASSERT_EQ(times, 1) << threads << " threads, run " << run;
            }
        }
    }
}

TEST(WorkerPool, GivesNoWorkerTwoItemsAtATime) {
    WorkerPool pool(4);
    std::array<std::atomic<int>, 4> busy{};
    std::atomic<int> clashes{0};
    for (int run = 0; run < 200; ++run) {
        pool.run(64, 0, [&](int, int worker) {
            std::atomic<int>& mine = busy.at(static_cast<std::size_t>(worker));
            clashes += mine.exchange(1);
            std::this_thread::yield();
            mine = 0;
        });
    }
    EXPECT_EQ(clashes, 0);
}

TEST(WorkerPool, UsesNoMoreThreadsThanAskedFor) {
    WorkerPool pool(4);
    std::atomic<int> greatest{0};
    for (int run = 0; run < 200; ++run) {
        pool.run(20, 2, [&](int, int worker) {
            if (worker > greatest) {
                greatest = worker;
            }
        });
    }
    EXPECT_LT(greatest, 2);
}

TEST(WorkerPool, RethrowsAndWorksOnAfterwards) {
    WorkerPool pool(3);
    for (int run = 0; run < 50; ++run) {
        EXPECT_THROW(pool.run(30, 0,
                              [](int item, int) {
                                  if (item == 7) {
                                      throw std::runtime_error("seven");
                                  }
                              }),
                     std::runtime_error);
        std::atomic<int> done{0};
        pool.run(30, 0, [&](int, int) { ++done; });
        ASSERT_EQ(done, 30);
    }
}

TEST(WorkerPool, ServesCallersOneAfterTheOther) {
    WorkerPool pool(2);
    std::atomic<int> done{0};
    {
        std::vector<std::jthread> callers;
        for (int i = 0; i < 4; ++i) {
            callers.emplace_back([&] {
                for (int run = 0; run < 100; ++run) {
                    pool.run(10, 0, [&](int, int) { ++done; });
                }
            });
        }
    }
    EXPECT_EQ(done, 4000);
}

} // namespace spherewalk
