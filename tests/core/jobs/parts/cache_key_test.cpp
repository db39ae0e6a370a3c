// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/cache_key.h"
#include "random.h"

#include <gtest/gtest.h>

#include <set>

namespace spherewalk::jobs {

namespace {

CameraIntrinsics vgaCamera() {
    return CameraIntrinsics::pinhole(640, 480, 1.2);
}

} // namespace

TEST(CacheKey, IsTheSameForTheSamePose) {
    test::Random random(7);
    for (int i = 0; i < 100; ++i) {
        const Rigid3 pose{random.rotation(), random.vector()};
        const Rigid3 copy = pose;
        EXPECT_EQ(keyOf(pose), keyOf(copy));
    }
}

TEST(CacheKey, TellsEveryNumberOfAPoseApart) {
    const Rigid3 pose{Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), {1, 2, 3}};
    std::set<std::string> keys{keyOf(pose)};
    for (int axis = 0; axis < 3; ++axis) {
        Rigid3 moved = pose;
        moved.translation[axis] += 1e-12;
        keys.insert(keyOf(moved));
    }
    for (int i = 0; i < 4; ++i) {
        Rigid3 turned = pose;
        turned.rotation.coeffs()[i] += 1e-12;
        keys.insert(keyOf(turned));
    }
    EXPECT_EQ(keys.size(), 8U);
}

TEST(CacheKey, DoesNotConfuseTheNumbersOfAPose) {
    const Rigid3 pose{Eigen::Quaterniond(0.1, 0.2, 0.3, 0.4), {5, 6, 7}};
    const Rigid3 swapped{Eigen::Quaterniond(0.1, 0.3, 0.2, 0.4), {5, 6, 7}};
    const Rigid3 shifted{Eigen::Quaterniond(0.1, 0.2, 0.3, 0.4), {56, 7, 0}};
    EXPECT_NE(keyOf(pose), keyOf(swapped));
    EXPECT_NE(keyOf(pose), keyOf(shifted));
}

TEST(CacheKey, TellsEveryNumberOfACameraApart) {
    std::set<std::string> keys{keyOf(vgaCamera())};
    const auto with = [&](auto change) {
        CameraIntrinsics changed = vgaCamera();
        change(changed);
        keys.insert(keyOf(changed));
    };
    with([](CameraIntrinsics& c) { c.width += 1; });
    with([](CameraIntrinsics& c) { c.height += 1; });
    with([](CameraIntrinsics& c) { c.fx += 1e-9; });
    with([](CameraIntrinsics& c) { c.fy += 1e-9; });
    with([](CameraIntrinsics& c) { c.cx += 1e-9; });
    with([](CameraIntrinsics& c) { c.cy += 1e-9; });
    with([](CameraIntrinsics& c) { c.distortion = {0.1}; });
    with([](CameraIntrinsics& c) { c.distortion = {0.1, 0}; });
    EXPECT_EQ(keys.size(), 9U);
}

TEST(CacheKey, IsTheSameForTheSameCamera) {
    EXPECT_EQ(keyOf(vgaCamera()), keyOf(vgaCamera()));
}

} // namespace spherewalk::jobs
