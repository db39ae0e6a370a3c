// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/jobs/object_overlay.h"

#include <cmath>

namespace spherewalk::jobs {

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(64, 48, 1.2));

} // namespace

TEST(BallOverlay, HasTheBallsOwnDepthWhereItsRaysMeetIt) {
    test::Random random(81);
    for (int i = 0; i < 20; ++i) {
        const Rigid3 pose{random.rotation(), random.vector(3)};
        Ball ball;
        ball.centreM = pose * Eigen::Vector3d(0.1 * random.normal(), 0.1 * random.normal(), 2);
        const render::Overlay overlay = ballOverlay(ball, kCamera, pose);
        int seen = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const float depth = *overlay.depth.at(x, y);
                ASSERT_EQ(std::isfinite(depth), overlay.picture.at(x, y)[3] == 255);
                if (std::isfinite(depth)) {
                    const Eigen::Vector3d ray = *kCamera.ray(Eigen::Vector2d(x, y));
                    const Eigen::Vector3d hit = pose * (depth / ray.z() * ray);
                    ASSERT_NEAR((hit - ball.centreM).norm(), ball.radiusM, 1e-5) << "seed " << random.seed();
                    ++seen;
                }
            }
        }
        // A ball of 20 cm at 2 m has a radius of about 4.7 of these pixels.
        EXPECT_NEAR(seen, 70, 25);
    }
}

TEST(BallOverlay, IsEmptyWhereTheCameraCannotSeeIt) {
    Ball ball;
    for (const Eigen::Vector3d& centre : {Eigen::Vector3d(0, 0, -2), Eigen::Vector3d(0, 0, 0.1)}) {
        ball.centreM = centre;
        const render::Overlay overlay = ballOverlay(ball, kCamera, {});
        for (const float depth : overlay.depth.values()) {
            ASSERT_FALSE(std::isfinite(depth));
        }
    }
}

TEST(BallOverlay, IsSpelledByFourNumbers) {
    EXPECT_EQ(parseBall("1 -2 0.5 0.25").centreM, Eigen::Vector3d(1, -2, 0.5));
    EXPECT_EQ(parseBall("1 -2 0.5 0.25").radiusM, 0.25);
    for (const char* wrong : {"", "1 2 3", "1 2 3 0", "1 2 x 1", "nan 0 0 1", "1 2 3 4 5"}) {
        test::expectError(ErrorKind::InvalidInput, "x y z radius", [&] { parseBall(wrong); });
    }
}

} // namespace spherewalk::jobs
