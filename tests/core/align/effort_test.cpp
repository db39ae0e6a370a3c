// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/align/effort.h"

#include <gtest/gtest.h>

namespace spherewalk::align {

TEST(Effort, HasANameThatFindsItAgain) {
    for (const Effort effort : {Effort::Draft, Effort::Normal, Effort::Fine, Effort::Exact}) {
        EXPECT_EQ(effortNamed(name(effort)), effort);
    }
    test::expectError(ErrorKind::InvalidInput, "draft, normal, fine and exact", [] { effortNamed("hard"); });
}

TEST(Effort, OptionsAreValidAndEachRungLooksAtMore) {
    EffortOptions before;
    before.features.width = 0;
    before.features.most = 0;
    for (const Effort effort : {Effort::Draft, Effort::Normal, Effort::Fine, Effort::Exact}) {
        const EffortOptions options = optionsFor(effort);
        EXPECT_NO_THROW(options.features.validate());
        EXPECT_NO_THROW(options.match.validate());
        EXPECT_NO_THROW(options.neighbours.validate());
        EXPECT_GT(options.features.width, before.features.width);
        EXPECT_GT(options.features.most, before.features.most);
        before = options;
    }
}

} // namespace spherewalk::align
