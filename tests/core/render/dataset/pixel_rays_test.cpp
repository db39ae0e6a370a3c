// SPDX-License-Identifier: Apache-2.0
#include "lenses.h"

#include "spherewalk/render/pixel_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(PixelRays, AreThoseOfTheCameraModel) {
    WorkerPool pool(2);
    for (const CameraIntrinsics& intrinsics : test::everyLens(64, 48)) {
        const CameraModel camera(intrinsics);
        const PixelRays rays(camera, pool);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const Vector3d exact = camera.ray(Vector2d(x, y)).value_or(Vector3d::Zero());
                ASSERT_LT((rays.ray(x, y) - exact).norm(), 1e-7) << name(intrinsics.lens) << x << ", " << y;
                ASSERT_EQ(rays.ray(x, y).isZero(0), exact.isZero(0));
            }
        }
    }
}

TEST(PixelRays, OfASquareAreWithinItsReach) {
    WorkerPool pool(2);
    for (const int width : {57, 65, 90}) {
        for (const CameraIntrinsics& intrinsics : test::everyLens(width, 43)) {
            const PixelRays rays(CameraModel(intrinsics), pool);
            for (int y = 0; y < 43; ++y) {
                for (int x = 0; x < width; ++x) {
                    const int column = x / PixelRays::kSquare;
                    const int row = y / PixelRays::kSquare;
                    const Eigen::Vector2i middle = rays.middle(column, row);
                    const double reach = rays.reach(column, row);
                    for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                        const bool isLast = i < 0 ? x + 1 < width : j < 0 && y + 1 < 43;
                        if (x + i < 0 || y + j < 0 || x + i >= width || y + j >= 43 || isLast) {
                            continue; // a pixel's neighbours are before it only in the last column and row
                        }
                        const Vector3d ray = rays.ray(x + i, y + j);
                        const Vector3d away = ray - rays.ray(middle.x(), middle.y());
                        ASSERT_LE(ray.isZero(0) ? HUGE_VAL : away.norm(), reach)
                            << name(intrinsics.lens) << " " << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(PixelRays, AreTheSameForAnyNumberOfThreads) {
    WorkerPool pool(3);
    const CameraModel camera(test::everyLens(33, 21)[1]);
    const PixelRays one(camera, pool, 1);
    const PixelRays many(camera, pool);
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 33; ++x) {
            EXPECT_EQ(one.ray(x, y), many.ray(x, y));
        }
    }
}

} // namespace spherewalk::render
