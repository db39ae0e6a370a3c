// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/bench/lattice_error.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <limits>
#include <set>

namespace spherewalk::bench {

namespace {

class LatticeTest : public testing::TestWithParam<LatticeSearch> {};

constexpr double kRoundingOfFixedPointPx = 0.0015; ///< As resources/docs/render.md says.

LatticeCase levelView() {
    return {CameraModel(CameraIntrinsics::pinhole(160, 120, 1)), {bodyFromOptical(), {0, 0, 0}}, {}};
}

LatticeCase anyView(test::Random& random) {
    LatticeCase view = levelView();
    view.camera = CameraModel(CameraIntrinsics::pinhole(160, 120, random.uniform(0.1, 3)));
    view.roomFromPhoto.rotation = random.rotation();
    view.roomFromCamera = {random.rotation(), random.direction() * random.uniform(0, 1.5)};
    view.scene = random.integer(0, 1) == 0 ? render::SceneKind::None : render::SceneKind::Sphere;
    view.sphereRadiusM = 2;
    return view;
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

TEST(LatticeError, StaysBelowTheToleranceThatIsAskedFor) {
    test::Random random(41);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 12; ++i) {
        LatticeCase view = anyView(random);
        for (const double tolerancePx : {0.005, 0.018, 0.2, 3.0}) {
            view.tolerancePx = tolerancePx;
            const LatticeError error = latticeError(view);
            EXPECT_LE(error.worstPx, tolerancePx + kRoundingOfFixedPointPx) << error.where;
            EXPECT_LE(error.worstToBound, 1) << error.where;
            EXPECT_TRUE(error.isInRange) << error.where;
        }
    }
}

TEST(LatticeError, NeedsFinerCellsForASmallerTolerance) {
    test::Random random(42);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 12; ++i) {
        LatticeCase view = anyView(random);
        long coarse = std::numeric_limits<long>::max();
        for (const double tolerancePx : {10.0, 0.5, 0.018, 0.001}) {
            view.tolerancePx = tolerancePx;
            const LatticeError error = latticeError(view);
            EXPECT_LE(error.cells[0], coarse) << tolerancePx;
            coarse = error.cells[0];
        }
    }
}

TEST(LatticeError, LooksAtEachCellOnceAndAtASeventhOfItsSamples) {
    for (const int samplesPerAxis : {1, 2}) {
        LatticeCase view = levelView();
        view.samplesPerAxis = samplesPerAxis;
        const LatticeError error = latticeError(view);
        EXPECT_EQ(error.cells[0] + error.cells[1] + error.cells[2] + error.cells[3], 10 * 8); // of 16 pixels
        const double all = 160.0 * 120 * samplesPerAxis * samplesPerAxis;
        EXPECT_NEAR(static_cast<double>(error.samples), all / 7, 0.02 * all / 7);
    }
}

TEST(LatticeError, DoesNotDependOnWhereTheRoomLies) {
    test::Random random(43);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 6; ++i) {
        LatticeCase view = anyView(random);
        const LatticeError here = latticeError(view);
        const Eigen::Vector3d far(1000, -2000, 500);
        view.roomFromCamera.translation += far;
        view.roomFromPhoto.translation += far;
        EXPECT_NEAR(latticeError(view).worstPx, here.worstPx, 0.0005);
    }
}

TEST(LatticeError, TellsThePixelTheLensAndTheCell) {
    LatticeCase view = levelView();
    EXPECT_THAT(latticeError(view).where,
                testing::MatchesRegex("pixel .[0-9]+, [0-9]+. of 160 x 120, focal length 146.4 px, "
                                      "elevation -?[0-9.]+ deg, (coarse|fine|finest|exact) cell"));
    CameraIntrinsics bent = view.camera.intrinsics();
    bent.lens = LensModel::PlumbBob;
    bent.distortion = {-0.1, 0.01, 0, 0, 0};
    view.camera = CameraModel(bent);
    EXPECT_THAT(latticeError(view).where, testing::HasSubstr("160 x 120 plumb_bob, focal"));
}

TEST(LatticeSearch, OfFewerViewsFindsNoWorseError) {
    for (const LatticeSearch search : kLatticeSearches) {
        const LatticeError some = searchLattice(search, 13);
        const LatticeError few = searchLattice(search, 91); // each of them is among the others
        EXPECT_LE(few.worstPx, some.worstPx) << name(search);
        EXPECT_LE(few.worstToBound, some.worstToBound) << name(search);
        EXPECT_LT(few.samples, some.samples) << name(search);
        EXPECT_LE(some.worstPx, 0.018 + kRoundingOfFixedPointPx) << some.where;
    }
}

TEST(LatticeSearch, FindsTheSameOnEveryRun) {
    const LatticeError first = searchLattice(LatticeSearch::EveryLens, 29);
    const LatticeError second = searchLattice(LatticeSearch::EveryLens, 29);
    EXPECT_EQ(first.worstPx, second.worstPx);
    EXPECT_EQ(first.where, second.where);
    EXPECT_EQ(first.samples, second.samples);
    EXPECT_EQ(first.cells, second.cells);
}

TEST(LatticeSearch, HasANameOfItsOwn) {
    std::set<std::string_view> names;
    for (const LatticeSearch search : kLatticeSearches) {
        EXPECT_NE(name(search), "");
        names.insert(name(search));
    }
    EXPECT_EQ(names.size(), kLatticeSearches.size());
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

} // namespace spherewalk::bench
