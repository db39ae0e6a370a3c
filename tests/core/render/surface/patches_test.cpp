// SPDX-License-Identifier: Apache-2.0
#include "random.h"
#include "surface/mesh.h"
#include "surface/surface_view.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace spherewalk::render {

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 32;

template <class InverseAt>
SurfaceMesh meshOf(InverseAt&& inverseAt) {
    Image<float, 1> inverse(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            *inverse.at(x, y) = static_cast<float>(inverseAt(x, y));
        }
    }
    return SurfaceMesh(DepthMap(std::move(inverse)));
}

/// Of the square whose upper left vertex that is.
simd::SurfacePatches patchesAt(const SurfaceMesh& mesh, int x, int y) {
    const EdgePatches& patches = mesh.detail(x / SurfaceMesh::kBlock, y / SurfaceMesh::kBlock).patches();
    const int square = EdgePatches::orderInBlock(x % SurfaceMesh::kBlock, y % SurfaceMesh::kBlock);
    return patches.at(patches.ofSubBlock(square));
}

/// What a patch covers of the mesh: its angles are of half pixels. Units: quads.
double areaOf(const simd::SurfacePatches& patches, int i) {
    const double left = std::atan2(patches.sine[0][i], patches.cosine[0][i]);
    const double right = std::atan2(patches.sine[2][i], patches.cosine[2][i]);
    const double top = std::asin(patches.sine[1][i]);
    const double bottom = std::asin(patches.sine[3][i]);
    const double perRadian = kWidth / (2 * std::numbers::pi);
    return std::remainder(left - right, 2 * std::numbers::pi) * perRadian * (top - bottom) * perRadian;
}

double areaOf(const simd::SurfacePatches& patches) {
    double area = 0;
    for (int i = 0; i < patches.count; ++i) {
        area += areaOf(patches, i);
    }
    return area;
}

} // namespace

TEST(EdgePatches, OfAStraightEdgeAreOneOnEitherSide) {
    const SurfaceMesh mesh = meshOf([](int x, int) { return x < 22 ? 1.0 : 0.5; });
    const simd::SurfacePatches patches = patchesAt(mesh, 20, 8);
    ASSERT_EQ(patches.count, 2); // of two quads a row, four rows of them
    EXPECT_NEAR(areaOf(patches), 8, 1e-3);
    for (int i = 0; i < 2; ++i) {
        const bool isNear = patches.inverseM[0][i] == 1;
        EXPECT_NEAR(areaOf(patches, i), isNear ? 6 : 2, 1e-3); // up to the middle of the second quad
        for (std::size_t corner = 0; corner < 4; ++corner) {
            EXPECT_EQ(patches.inverseM[corner][i], isNear ? 1.0F : 0.5F);
        }
    }
    EXPECT_EQ(patchesAt(mesh, 24, 8).count, 0);
    EXPECT_EQ(patchesAt(mesh, 40, 8).count, 0);
    EXPECT_EQ(patchesAt(mesh, 60, 8).count, 2); // where the columns begin again
}

TEST(EdgePatches, AreNotJoinedWhereTheDistanceIsUneven) {
    const auto edge = [](double perRow) {
        return meshOf([=](int x, int y) { return x < 22 ? 1.0 + perRow * y * y : 0.5; });
    };
    EXPECT_EQ(patchesAt(edge(0), 20, 0).count, 2);
    EXPECT_EQ(patchesAt(edge(1e-4), 20, 0).count, 2);
    EXPECT_GT(patchesAt(edge(1e-2), 20, 0).count, 4);
}

TEST(EdgePatches, CoverAllQuadsBesideEdges) {
    test::Random random(11);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        const SurfaceMesh mesh = meshOf([&](int, int) { return random.integer(0, 5) == 0 ? 0.6 : 0.5; });
        for (int y = 0; y < kHeight; y += EdgePatches::kSubBlock) {
            for (int x = 0; x < kWidth; x += EdgePatches::kSubBlock) {
                int quads = 0;
                for (int j = y; j < std::min(y + EdgePatches::kSubBlock, kHeight - 1); ++j) {
                    for (int i = x; i < x + EdgePatches::kSubBlock; ++i) {
                        quads += mesh.hasEdge(i / 2 * 2, j / 2 * 2) ? 1 : 0;
                    }
                }
                ASSERT_NEAR(areaOf(patchesAt(mesh, x, y)), quads, 1e-3) << x << ", " << y;
            }
        }
    }
}

TEST(SurfaceMesh, GivesAllThreadsTheSameDetail) {
    test::Random random(13);
    const SurfaceMesh mesh = meshOf([&](int, int) { return random.uniform(0.3, 0.5); });
    std::array<const SurfaceMesh::Detail*, 4> first{};
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < first.size(); ++i) {
            threads.emplace_back([&, i] {
                for (int block = 0; block < mesh.blocksX() * mesh.blocksY(); ++block) {
                    first[i] = &mesh.detail(block % mesh.blocksX(), block / mesh.blocksX());
                }
            });
        }
    }
    EXPECT_EQ(std::set(first.begin(), first.end()).size(), 1U);
}

TEST(EdgePatches, LeaveNoGapsWhereThePhotoWasTaken) {
    test::Random random(12);
    const CameraModel camera(CameraIntrinsics::pinhole(200, 150, Radians(Degrees(70)).value()));
    WorkerPool pool(1);
    SurfaceRaster raster;
    InverseBuffer seen;
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        const SurfaceMesh mesh = meshOf([&](int, int) { return random.uniform(0.3, 0.5); });
        const Eigen::Quaterniond photoFromCamera =
            rotation({Radians(random.uniform(-3, 3)), Radians(random.uniform(-0.7, 0.7)), Radians(0.1)}) *
            bodyFromOptical();
        const Rigid3 cameraFromPhoto{photoFromCamera.conjugate().normalized(), Eigen::Vector3d::Zero()};
        raster.draw(mesh, cameraFromPhoto, {}, camera, OpenCells(200, 150), 0, pool, 1, seen);
        for (int y = 0; y < 150; ++y) {
            for (int x = 0; x < 200; ++x) {
                // 1 / depth along the axis: at most 1 / distance by the cosine of the view's corner.
                ASSERT_GE(*seen.at(x, y), 0.3F) << x << ", " << y;
                ASSERT_LE(*seen.at(x, y), 0.5F * 1.35F) << x << ", " << y;
            }
        }
    }
}

} // namespace spherewalk::render
