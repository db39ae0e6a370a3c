// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/pair_estimate.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace spherewalk::align {

TEST(PairVerdict, NamesDiffer) {
    const std::set<std::string_view> names = {name(PairVerdict::Constraint), name(PairVerdict::TooFew),
                                              name(PairVerdict::TooNarrow), name(PairVerdict::NoAgreement)};
    EXPECT_EQ(names.size(), 4U);
}

} // namespace spherewalk::align
