// SPDX-License-Identifier: Apache-2.0
#include "depth_simd.h"
#include "lattice.h"
#include "photo_plane.h"
#include "random.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::render::simd {

namespace {

constexpr std::size_t kCellPixels = 256;
const EquirectSize kPhoto{8192, 4096};

struct Place {
    double u, v;
};

/// Photo coordinates of directions, a cell of them at a time.
std::vector<Place> located(const std::vector<Eigen::Vector3d>& directions) {
    const PhotoTarget target{{1, 0, 0, 0, 1, 0, 0, 0, 1},
                             {0, 0, 0},
                             static_cast<float>(kPhoto.width / (2 * std::numbers::pi)),
                             static_cast<float>(kPhoto.width + PlaneLayout::kGuard - 0.5),
                             static_cast<float>(kPhoto.height + PlaneLayout::kGuard - 0.5)};
    std::array<std::vector<float>, 3> rays;
    for (std::size_t i = 0; i < kCellPixels; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rays[k].push_back(static_cast<float>(directions[i % directions.size()][static_cast<int>(k)]));
        }
    }
    const std::vector<float> inverse(kCellPixels);
    std::vector<std::int32_t> u(kCellPixels);
    std::vector<std::int32_t> v(kCellPixels);
    locate(target, {{{rays[0].data(), 16}, {rays[1].data(), 16}, {rays[2].data(), 16}}}, inverse.data(), 16,
           u.data(), v.data());
    std::vector<Place> places;
    for (std::size_t i = 0; i < kCellPixels; ++i) {
        constexpr double kOne = 1 << kFractionBits;
        places.push_back({u[i] / kOne - PlaneLayout::kGuard - kRoundingU, v[i] / kOne - PlaneLayout::kGuard});
    }
    return places;
}

/// The square between two corners, of one value, before the overlap.
Piece square(float left, float top, float right, float bottom, float value) {
    Piece piece{};
    piece.a = {1, -1, 0, 0};
    piece.b = {0, 0, 1, -1};
    piece.c = {-left, right, -top, bottom};
    piece.base = value;
    piece.least = value;
    piece.most = value;
    piece.left = static_cast<int>(std::ceil(left));
    piece.right = static_cast<int>(std::floor(right));
    piece.top = static_cast<int>(std::ceil(top));
    piece.bottom = static_cast<int>(std::floor(bottom));
    return piece;
}

} // namespace

TEST(DepthSimd, LocatesAsDoublePrecisionDoes) {
    test::Random random(3);
    double worst = 0;
    for (int round = 0; round < 100; ++round) {
        std::vector<Eigen::Vector3d> directions;
        for (std::size_t i = 0; i < kCellPixels; ++i) {
            const Eigen::Vector3f single = random.direction().cast<float>();
            directions.emplace_back(single.cast<double>());
        }
        const std::vector<Place> places = located(directions);
        for (std::size_t i = 0; i < kCellPixels; ++i) {
            const Eigen::Vector2d exact = pixel(kPhoto, directions[i]);
            const double off = std::remainder(places[i].u - exact.x(), kPhoto.width);
            worst = std::max({worst, std::abs(off) * std::hypot(directions[i].x(), directions[i].y()),
                              std::abs(places[i].v - exact.y())});
        }
    }
    RecordProperty("worst_px_of_8192", std::to_string(worst));
    EXPECT_LT(worst, 0.01);
}

TEST(DepthSimd, LocatesPolesAndSeamWithinThePhoto) {
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(-1, 0, 0),
          Eigen::Vector3d(-1, -1e-20, 0), Eigen::Vector3d(0, 0, 0)}) {
        const Place place = located({direction}).front();
        EXPECT_GE(place.u, -0.51) << direction.transpose();
        EXPECT_LE(place.u, kPhoto.width - 0.49) << direction.transpose();
        EXPECT_GE(place.v, -0.51) << direction.transpose();
        EXPECT_LE(place.v, kPhoto.height - 0.49) << direction.transpose();
    }
}

TEST(DepthSimd, DrawsWhatLiesInsideAndTheNearerOne) {
    const std::vector<Piece> pieces{square(2.5F, 1.5F, 20.5F, 9.5F, 0.5F), square(10, 4, 40, 30, 0.25F)};
    constexpr int kWidth = 48;
    std::vector<float> values(std::size_t{kWidth} * 32);
    draw(pieces, 0, 32, values.data(), kWidth);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const float first = x >= 3 && x <= 20 && y >= 2 && y <= 9 ? 0.5F : 0;
            const float second = x >= 10 && x <= 40 && y >= 4 && y <= 30 ? 0.25F : 0;
            ASSERT_EQ(values[static_cast<std::size_t>(y * kWidth + x)], std::max(first, second))
                << x << ", " << y;
        }
    }
}

TEST(DepthSimd, CountsThePixelsThatNothingCovers) {
    std::vector<float> values(std::size_t{16} * 16, 1.0F);
    EXPECT_EQ(zeros(values.data(), 16), 0);
    values[0] = values[17] = values[255] = 0;
    EXPECT_EQ(zeros(values.data(), 16), 3);
}

TEST(DepthSimd, BoxesACell) {
    std::vector<std::int32_t> u(kCellPixels, 50);
    std::vector<std::int32_t> v(kCellPixels, 60);
    u[255] = 70;
    u[100] = 7;
    v[0] = 90;
    v[9] = 3;
    EXPECT_EQ(boxOfCell(u.data(), v.data()), (std::array<std::int32_t, 4>{7, 70, 3, 90}));
}

} // namespace spherewalk::render::simd
