// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/lattice_error.h"

#include <gtest/gtest.h>

#include <iostream>

namespace spherewalk::render {

namespace {

class LatticeTest : public testing::TestWithParam<LatticeSearch> {};

LatticeCase levelView() {
    return {CameraModel(CameraIntrinsics::pinhole(160, 120, 1)), {bodyFromOptical(), {0, 0, 0}}, {}};
}

} // namespace

TEST_P(LatticeTest, IsExactToAFiftiethOfAPixelAndWithinItsBound) {
    const LatticeError error = searchLattice(GetParam());
    std::cout << "  " << name(GetParam()) << ": worst " << error.worstPx << " px at " << error.where
              << "; error/bound " << error.worstToBound << "; cells coarse " << error.cells[0] << " fine "
              << error.cells[1] << " finest " << error.cells[2] << " exact " << error.cells[3] << "; "
              << error.samples << " samples\n";
    RecordProperty("worst_px", std::to_string(error.worstPx));
    RecordProperty("where", error.where);
    EXPECT_LE(error.worstPx, 0.02);
    EXPECT_LE(error.worstToBound, 1);
    EXPECT_TRUE(error.isInRange);
    EXPECT_GT(error.samples, 100'000);
}

INSTANTIATE_TEST_SUITE_P(Lattice, LatticeTest, testing::ValuesIn(kLatticeSearches), [](const auto& search) {
    std::string word;
    for (const char letter : name(search.param)) {
        if (letter != ' ') {
            word += letter;
        }
    }
    return word;
});

// The measure itself: what is off must be found.
TEST(LatticeError, FindsWhatATolerantLatticeGetsWrong) {
    LatticeCase view = levelView();
    const LatticeError right = latticeError(view);
    EXPECT_LT(right.worstPx, 0.02);
    view.camera = CameraModel(CameraIntrinsics::pinhole(160, 120, 3));
    view.tolerancePx = 1e6;
    const LatticeError wrong = latticeError(view);
    EXPECT_GT(wrong.worstPx, 0.02);
    EXPECT_NE(wrong.where.find("coarse"), std::string::npos) << wrong.where;
}

TEST(LatticeError, OfManyViewsIsThatOfTheWorst) {
    LatticeError sum;
    sum.add({0.1, "here", 0.2, {1, 2, 3, 4}, 10, true});
    sum.add({0.3, "there", 0.1, {1, 0, 0, 0}, 5, false});
    sum.add({0.2, "elsewhere", 0.1, {}, 1, true});
    EXPECT_EQ(sum.worstPx, 0.3);
    EXPECT_EQ(sum.where, "there");
    EXPECT_EQ(sum.worstToBound, 0.2);
    EXPECT_EQ(sum.cells, (std::array<long, 4>{2, 2, 3, 4}));
    EXPECT_EQ(sum.samples, 16);
    EXPECT_FALSE(sum.isInRange);
}

TEST(LatticeError, SearchStopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "Stopped",
                      [&] { searchLattice(LatticeSearch::AnyDirection, 1, noProgress(), stop.get_token()); });
}

} // namespace spherewalk::render
