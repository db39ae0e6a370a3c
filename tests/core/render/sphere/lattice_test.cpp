// SPDX-License-Identifier: Apache-2.0
#include "random.h"
#include "sphere/lattice.h"
#include "sphere/ray_table.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

namespace spherewalk::render {

TEST(Lattice, PlacesAreItsCoordinates) {
    test::Random random(54);
    constexpr int kStride = 5441;
    std::array<long, 4> cells{};
    for (int i = 0; i < 60; ++i) {
        const CameraModel camera(CameraIntrinsics::pinhole(random.integer(16, 200), random.integer(16, 200),
                                                           random.uniform(1, 170) * std::numbers::pi / 180));
        const int n = random.integer(1, 4);
        const RayTable rays(camera, n);
        const LatticeFrame lattice(rays, {random.rotation(), 0.9 * random.direction()}, {}, {5376, 2688},
                                   SceneKind::Sphere, 1);
        const Placing placing{kStride, random.integer(0, 1 << 15), random.integer(0, 1 << 15)};
        LatticeRow row(rays.cellsX());
        const auto count = static_cast<std::size_t>(256 * n * n);
        std::vector<std::int32_t> u(count);
        std::vector<std::int32_t> v(count);
        std::vector<std::int32_t> places(count);
        std::vector<std::int32_t> fractions(count);
        for (int cellY = 0; cellY < rays.cellsY(); ++cellY) {
            row.beginRow(lattice, cellY);
            for (int cellX = 0; cellX < rays.cellsX(); ++cellX) {
                ++cells.at(static_cast<std::size_t>(row.mode(cellX)));
                row.coordinates(lattice, cellX, u.data(), v.data());
                row.places(lattice, cellX, placing, places.data(), fractions.data());
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
