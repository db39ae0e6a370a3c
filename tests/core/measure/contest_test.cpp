// SPDX-License-Identifier: GPL-3.0-or-later
#include "contest.h"
#include "expect_error.h"
#include "made_dataset.h"

namespace spherewalk::measure {

using test::expectError;

TEST(Contest, MediansAreOfTheMiddle) {
    EXPECT_EQ(quantile({3}, 0.5), 3);
    EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.5), 3);
    EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0), 1);
    EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 1), 5);
    const Measured result = measured({10, 11, 12, 13, 100});
    EXPECT_EQ(result.medianMs, 12);
    EXPECT_EQ(result.madMs, 1);
}

TEST(Contest, TakesTurnsInBlocksAndTheFirstBlockDoesNotCount) {
    std::string turns;
    Contest contest;
    contest.add("a", [&](int run) { turns += "a" + std::to_string(run); });
    contest.add("b", [&](int run) { turns += "b" + std::to_string(run); });
    contest.run(3, 2, noProgress(), "", {});
    EXPECT_EQ(turns, "a0a1b0b1a2a3b2b3a4b4");
    EXPECT_GE(contest.of("a").medianMs, 0);
    expectError(ErrorKind::Internal, "the name c", [&] { contest.of("c"); });
}

TEST(Contest, StopsBetweenTwoRuns) {
    std::stop_source stop;
    int runs = 0;
    Contest contest;
    contest.add("a", [&](int) {
        if (++runs == 5) {
            stop.request_stop();
        }
    });
    expectError(ErrorKind::Stopped, "Stopped",
                [&] { contest.run(100, 10, noProgress(), "", stop.get_token()); });
    EXPECT_EQ(runs, 5);
}

} // namespace spherewalk::measure
