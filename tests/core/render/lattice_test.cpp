// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "lattice.h"
#include "random.h"
#include "ray_table.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/lattice_error.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <numbers>

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

TEST(Lattice, PlacesAreItsCoordinates) {
    test::Random random(54);
    constexpr int kStride = 5441;
    std::array<long, 4> cells{};
    for (int i = 0; i < 60; ++i) {
        const CameraModel camera(CameraIntrinsics::pinhole(random.integer(16, 200), random.integer(16, 200),
                                                           random.uniform(1, 170) * std::numbers::pi / 180));
        const int n = random.integer(1, 4);
        const RayTable rays(camera, n);
        const Lattice lattice(rays, {random.rotation(), 0.9 * random.direction()}, {}, {5376, 2688},
                              SceneKind::Sphere, 1);
        const Placing placing{kStride, random.integer(0, 1 << 15), random.integer(0, 1 << 15)};
        LatticeScratch scratch(rays.cellsX());
        const auto count = static_cast<std::size_t>(256 * n * n);
        std::vector<std::int32_t> u(count);
        std::vector<std::int32_t> v(count);
        std::vector<std::int32_t> places(count);
        std::vector<std::int32_t> fractions(count);
        for (int cellY = 0; cellY < rays.cellsY(); ++cellY) {
            scratch.beginRow(lattice, cellY);
            for (int cellX = 0; cellX < rays.cellsX(); ++cellX) {
                ++cells.at(static_cast<std::size_t>(scratch.mode(cellX)));
                scratch.coordinates(lattice, cellX, u.data(), v.data());
                scratch.places(lattice, cellX, placing, places.data(), fractions.data());
                for (std::size_t k = 0; k < count; ++k) {
                    const std::int32_t atU = u[k] + placing.roundingU;
                    const std::int32_t atV = v[k] + placing.roundingV;
                    ASSERT_EQ(places[k], 3 * ((atV >> 16) * kStride + (atU >> 16)))
                        << "cell " << cellX << " " << cellY << " seed " << random.seed();
                    ASSERT_EQ(fractions[k] & 0xFFFF, atU & 0xFFFF);
                    ASSERT_EQ(fractions[k] >> 16 & 0xFFFF, atV & 0xFFFF);
                }
            }
        }
    }
    for (const long count : cells) {
        EXPECT_GT(count, 0);
    }
}

} // namespace spherewalk::render
