// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
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

} // namespace spherewalk
