// SPDX-License-Identifier: Apache-2.0
#include "lenses.h"

#include "spherewalk/render/pixel_rays.h"

#include <gtest/gtest.h>

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
