// SPDX-License-Identifier: Apache-2.0
#include "pixels/photo_plane.h"
#include "random.h"
#include "sphere/lattice.h"
#include "surface/cells.h"
#include "surface/coordinates.h"
#include "surface/pieces.h"
#include "surface/vertices.h"

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
                             0,
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
    piece.plane = {0, 0, value, value};
    piece.most = value;
    piece.box = {static_cast<int>(std::ceil(left)), static_cast<int>(std::ceil(top)),
                 static_cast<int>(std::floor(right)), static_cast<int>(std::floor(bottom))};
    return piece;
}

} // namespace

TEST(SurfaceSimd, LocatesAsDoublePrecisionDoes) {
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

TEST(SurfaceSimd, LocatesPolesAndSeamWithinThePhoto) {
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

TEST(SurfaceSimd, DrawsWhatLiesInsideAndTheNearerOne) {
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

TEST(SurfaceSimd, CutsQuadsIntoPieces) {
    Quads quads;
    const auto add = [&](const std::array<Place, 4>& corners) {
        for (std::size_t i = 0; i < 4; ++i) {
            quads.x[i][static_cast<std::size_t>(quads.count)] = static_cast<float>(corners[i].u);
            quads.y[i][static_cast<std::size_t>(quads.count)] = static_cast<float>(corners[i].v);
            quads.value[i][static_cast<std::size_t>(quads.count)] = i < 2 ? 0.25F : 0.5F;
        }
        ++quads.count;
    };
    add({{{2, 2}, {10, 2}, {10, 10}, {2, 10}}});
    add({{{20, 2}, {12, 2}, {12, 10}, {20, 10}}});     // seen from behind
    add({{{22, 2}, {30, 2}, {24, 4}, {22, 10}}});      // not convex
    add({{{-20, 2}, {-10, 2}, {-10, 10}, {-20, 10}}}); // beside the view
    CutQuads pieceOf;
    cut(quads, 48, 32, pieceOf);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < static_cast<std::size_t>(quads.count); ++i) {
        const Piece::Box box = pieceOf.boxOf(i);
        if (box.left <= box.right && box.top <= box.bottom) {
            simd::add(quads, pieceOf, i, pieces);
        }
    }
    ASSERT_EQ(pieces.size(), 4U);
    std::vector<float> values(std::size_t{48} * 32);
    draw(pieces, 0, 32, values.data(), 48);
    const auto value = [&](int x, int y) { return values[static_cast<std::size_t>(y * 48 + x)]; };
    for (const int x : {2, 6, 10, 12, 16, 20}) {
        EXPECT_FLOAT_EQ(value(x, 2), 0.25F) << x;
        EXPECT_FLOAT_EQ(value(x, 6), 0.375F) << x;
        EXPECT_FLOAT_EQ(value(x, 10), 0.5F) << x;
        EXPECT_EQ(value(x, 11), 0) << x;
    }
    EXPECT_GT(value(23, 4), 0);
    EXPECT_EQ(value(28, 8), 0); // beyond the corner that points inwards
    EXPECT_EQ(value(11, 6), 0);
}

TEST(SurfaceSimd, DrawsUpToTheLastColumn) {
    const std::vector<Piece> pieces{square(3, 31, 47, 31, 0.5F)};
    std::vector<float> values(std::size_t{48} * 32);
    draw(pieces, 0, 32, values.data(), 48);
    EXPECT_EQ(std::count(values.begin(), values.end(), 0.5F), 45);
}

TEST(SurfaceSimd, CountsThePixelsThatNothingCovers) {
    std::vector<float> values(std::size_t{16} * 16, 1.0F);
    std::array<std::int32_t, 16> ofParts;
    EXPECT_EQ(zeros(values.data(), 16, ofParts), 0);
    values[0] = values[17] = values[255] = 0;
    EXPECT_EQ(zeros(values.data(), 16, ofParts), 3);
    EXPECT_EQ(ofParts, (std::array<std::int32_t, 16>{2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(SurfaceSimd, TakesWhereItHasNothingYet) {
    std::vector<float> values(kCellPixels, 1.0F);
    std::vector<float> seen(kCellPixels, 0.5F);
    values[0] = values[17] = values[18] = 0;
    seen[18] = 0;
    std::vector<std::uint8_t> sources(kCellPixels, 7);
    EXPECT_TRUE(takeUnseen(seen.data(), 16, 2, values.data(), sources.data()));
    EXPECT_EQ(values[0], 0.5F);
    EXPECT_EQ(values[1], 1.0F);
    EXPECT_EQ(values[18], 0);
    EXPECT_EQ(sources[0], 2);
    EXPECT_EQ(sources[17], 2);
    EXPECT_EQ(std::count(sources.begin(), sources.end(), 7), static_cast<std::ptrdiff_t>(kCellPixels) - 2);
    EXPECT_FALSE(takeUnseen(seen.data(), 16, 3, values.data(), sources.data()));
    EXPECT_EQ(std::count(sources.begin(), sources.end(), 3), 0);
}

TEST(SurfaceSimd, BoxesWhatACellTakesFromAPhoto) {
    std::vector<std::int32_t> u(kCellPixels, 50);
    std::vector<std::int32_t> v(kCellPixels, 60);
    std::vector<std::uint8_t> sources(kCellPixels);
    u[255] = 70;
    u[100] = 7;
    v[0] = 90;
    v[9] = 3;
    EXPECT_EQ(boxOfCell(u.data(), v.data(), sources.data(), 16, 0),
              (std::array<std::int32_t, 4>{7, 70, 3, 90}));
    EXPECT_EQ(boxOfCell(u.data(), v.data()), (std::array<std::int32_t, 4>{7, 70, 3, 90}));
    sources[100] = sources[9] = 2;
    EXPECT_EQ(boxOfCell(u.data(), v.data(), sources.data(), 16, 0),
              (std::array<std::int32_t, 4>{50, 70, 60, 90}));
    EXPECT_EQ(boxOfCell(u.data(), v.data(), sources.data(), 16, 2),
              (std::array<std::int32_t, 4>{7, 50, 3, 60}));
}

TEST(SurfaceSimd, FitsWhatItLocates) {
    // Random cells of random cameras, near the poles and the seam too, whose pixels have any distances.
    test::Random random(5);
    double worst = 0;
    int fitted = 0;
    for (int round = 0; round < 2000; ++round) {
        const Eigen::Matrix3d m = random.rotation().toRotationMatrix();
        const Eigen::Vector3d offset = random.uniform(0, 1) * random.direction();
        PhotoTarget target{};
        for (int i = 0; i < 9; ++i) {
            target.m[static_cast<std::size_t>(i)] = static_cast<float>(m(i / 3, i % 3));
        }
        for (int i = 0; i < 3; ++i) {
            target.offset[static_cast<std::size_t>(i)] = static_cast<float>(offset[i]);
        }
        target.perRadian = static_cast<float>(kPhoto.width / (2 * std::numbers::pi));
        target.lastU = static_cast<float>(kPhoto.width + PlaneLayout::kGuard - 0.5);
        target.lastV = static_cast<float>(kPhoto.height + PlaneLayout::kGuard - 0.5);
        const double step = 1 / random.uniform(150, 2000);
        const double left = random.uniform(-1, 1);
        const double top = random.uniform(-1, 1);
        const double least = random.uniform(0.1, 1);
        const double span = random.uniform(0, 0.3);
        std::vector<float> inverse;
        for (std::size_t i = 0; i < kCellPixels; ++i) {
            inverse.push_back(static_cast<float>(least + random.uniform(0, span)));
        }
        std::array<std::array<float, 17>, 3> nodes{};
        NodeRays rays{};
        for (std::size_t i = 0; i < 3; ++i) {
            nodes[i][0] = static_cast<float>(left + NodeRays::kNodes[i] * step);
            rays.x[i] = nodes[i].data();
            rays.y[i] = static_cast<float>(top + NodeRays::kNodes[i] * step);
        }
        rays.stepX = rays.stepY = static_cast<float>(step);
        const auto [from, to] = range(inverse.data(), 16);
        std::array<float, 17> leasts{from};
        std::array<float, 17> greatests{to};
        CellFits fits(1);
        fit(target, rays, leasts.data(), greatests.data(), std::array<std::uint8_t, 1>{1}, fits);
        if (!(fits.errorPx[0] <= CellFits::kTolerancePx)) {
            continue;
        }
        ++fitted;
        std::array<std::int32_t, kCellPixels> u;
        std::array<std::int32_t, kCellPixels> v;
        locate(fits, 0, inverse.data(), 16, u.data(), v.data());
        for (std::size_t i = 0; i < kCellPixels; ++i) {
            const Eigen::Vector3d ray(left + static_cast<double>(i % 16) * step,
                                      top + static_cast<double>(i / 16) * step, 1);
            const Eigen::Vector3d direction = m * ray + inverse[i] * offset;
            const Eigen::Vector2d exact = pixel(kPhoto, direction);
            constexpr double kOne = 1 << kFractionBits;
            const double off =
                std::remainder(u[i] / kOne - PlaneLayout::kGuard - kRoundingU - exact.x(), kPhoto.width);
            worst = std::max({worst, std::abs(off) * direction.head<2>().norm() / direction.norm(),
                              std::abs(v[i] / kOne - PlaneLayout::kGuard - exact.y())});
        }
    }
    RecordProperty("worst_px_of_8192", std::to_string(worst));
    EXPECT_GT(fitted, 500);
    EXPECT_LT(worst, 0.02);
}

} // namespace spherewalk::render::simd
