// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/shard.h"

#include <algorithm>

namespace spherewalk::jobs {

using test::expectError;

TEST(Shard, PutsEveryItemInOnePart) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto items = static_cast<std::size_t>(random.integer(0, 1000));
        const auto count = static_cast<std::size_t>(random.integer(1, 60));
        std::size_t next = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [begin, end] = Shard{i, count}.range(items);
            ASSERT_EQ(begin, next) << i << " of " << count;
            ASSERT_LE(begin, end);
            next = end;
        }
        ASSERT_EQ(next, items);
    }
}

TEST(Shard, HasPartsOfAboutTheSameSize) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto items = static_cast<std::size_t>(random.integer(0, 1000));
        const auto count = static_cast<std::size_t>(random.integer(1, 60));
        std::size_t least = items;
        std::size_t most = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto [begin, end] = Shard{i, count}.range(items);
            least = std::min(least, end - begin);
            most = std::max(most, end - begin);
        }
        ASSERT_LE(most - least, 1U) << items << " items in " << count << " parts";
    }
}

TEST(Shard, IsTheWholeUnlessThereAreSeveral) {
    EXPECT_TRUE(Shard{}.isWhole());
    EXPECT_EQ(Shard{}.range(7), (std::pair<std::size_t, std::size_t>{0, 7}));
    EXPECT_TRUE(Shard::parse("1/1").isWhole());
    EXPECT_FALSE(Shard::parse("1/2").isWhole());
}

TEST(Shard, LeavesPartsEmptyWhereItemsAreFew) {
    std::size_t taken = 0;
    for (std::size_t i = 0; i < 10; ++i) {
        const auto [begin, end] = Shard{i, 10}.range(3);
        taken += end - begin;
    }
    EXPECT_EQ(taken, 3U);
}

TEST(Shard, IsReadAsThePersonCountsFromOne) {
    for (std::size_t count = 1; count <= 12; ++count) {
        for (std::size_t i = 1; i <= count; ++i) {
            const Shard shard = Shard::parse(text(i, "/", count));
            EXPECT_EQ(shard.index, i - 1);
            EXPECT_EQ(shard.count, count);
        }
    }
    EXPECT_EQ(Shard::parse("1000000/1000000").index, 999'999U);
}

TEST(Shard, RefusesWhatIsNoPart) {
    for (const char* text : {"", "1", "/", "0/4", "5/4", "1.5/4", "-1/4", "1/-4", "1/0", "0/0", "a/b",
                             "1/2/3", "1/", "/2", "1/1000001", "nan/2", "1/inf"}) {
        SCOPED_TRACE(text);
        expectError(ErrorKind::InvalidInput, "no part of a job", [&] { Shard::parse(text); });
    }
}

} // namespace spherewalk::jobs
