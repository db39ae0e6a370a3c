// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/recently_used.h"

#include <gtest/gtest.h>

#include <string>

namespace spherewalk {

TEST(RecentlyUsed, KeepsWhatWasUsedLastAndMakesTheRestAgain) {
    RecentlyUsed<int, std::string> kept(2);
    int made = 0;
    const auto get = [&](int key) {
        return *kept.get(key, [&] {
            ++made;
            return std::to_string(key);
        });
    };
    EXPECT_EQ(get(1), "1");
    EXPECT_EQ(get(2), "2");
    EXPECT_EQ(get(1), "1");
    EXPECT_EQ(made, 2);
    EXPECT_EQ(get(3), "3"); // 2 was used longest ago, and goes
    EXPECT_EQ(get(1), "1");
    EXPECT_EQ(made, 3);
    EXPECT_EQ(get(2), "2");
    EXPECT_EQ(made, 4);
}

TEST(RecentlyUsed, WhatIsHeldOutlivesItsPlace) {
    RecentlyUsed<int, std::string> kept(1);
    const auto first = kept.get(1, [] { return std::string("one"); });
    kept.get(2, [] { return std::string("two"); });
    EXPECT_EQ(*first, "one");
}

} // namespace spherewalk
