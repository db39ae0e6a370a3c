// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace spherewalk {

TEST(ParallelFor, DoesEachIndexOnceForAnyCountGrainAndThreads) {
    for (const int count : {0, 1, 7, 100}) {
        for (const int grain : {0, 1, 3, 1000}) {
            for (const int threads : {0, 1, 2, 5}) {
                std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
                parallelFor(count, grain, threads, [&](int begin, int end) {
                    for (int i = begin; i < end; ++i) {
                        ++done[static_cast<std::size_t>(i)];
                    }
                });
                for (const auto& times : done) {
                    EXPECT_EQ(times, 1) << count << " " << grain << " " << threads;
                }
            }
        }
    }
}

TEST(ParallelFor, RethrowsTheFirstFailureAndBeginsNothingAfterIt) {
    std::atomic<int> begun{0};
    EXPECT_THROW(parallelFor(1'000'000, 1, 2,
                             [&](int, int) {
                                 ++begun;
                                 throw std::runtime_error("x");
                             }),
                 std::runtime_error);
    EXPECT_LE(begun, 2);
}

TEST(ParallelTasks, BeginEachOnceWhenWhatItNeedsHasEnded) {
    constexpr int kTasks = 200;
    std::vector<std::vector<int>> needs(kTasks);
    for (int task = 0; task + 1 < kTasks; ++task) {
        for (int other = task + 1; other < kTasks; other += 1 + task % 7) {
            needs[static_cast<std::size_t>(task)].push_back(other);
        }
    }
    for (const int threads : {0, 1, 2, 5}) {
        std::vector<std::atomic<int>> done(kTasks);
        std::atomic<int> early{0};
        parallelTasks(needs, threads, [&](int task) {
            for (const int other : needs[static_cast<std::size_t>(task)]) {
                early += done[static_cast<std::size_t>(other)] == 0 ? 1 : 0;
            }
            ++done[static_cast<std::size_t>(task)];
        });
        EXPECT_EQ(early, 0) << threads;
        for (const auto& times : done) {
            EXPECT_EQ(times, 1) << threads;
        }
    }
    parallelTasks({}, 2, [](int) { FAIL(); });
}

TEST(ParallelTasks, BeginTheFirstOneThatCan) {
    std::vector<int> order;
    parallelTasks(std::vector<std::vector<int>>{{2}, {2, 3}, {}, {}, {}}, 1,
                  [&](int task) { order.push_back(task); });
    EXPECT_EQ(order, (std::vector<int>{2, 0, 3, 1, 4}));
}

TEST(ParallelTasks, RethrowTheFirstFailureAndBeginNothingAfterIt) {
    std::atomic<int> begun{0};
    const std::vector<std::vector<int>> needs{{1}, {2}, {}, {2}, {2}};
    EXPECT_THROW(parallelTasks(needs, 3,
                               [&](int) {
                                   ++begun;
                                   throw std::runtime_error("x");
                               }),
                 std::runtime_error);
    EXPECT_EQ(begun, 1);
}

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
