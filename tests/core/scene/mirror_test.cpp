// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/scene/depth_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::scene {

namespace {

using Eigen::Vector3d;

constexpr int kMirrorWidth = 256;
constexpr double kHalfM = 2;       ///< of the room, a cube about the origin
constexpr double kMirrorHalfM = 1; ///< of a mirror in the middle of the wall at x = 2

/// Where a ray from inside of the cube meets it.
Vector3d wallHit(const Vector3d& from, const Vector3d& ray) {
    double nearest = 1e9;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(ray[i]) > 1e-12) {
            nearest = std::min(nearest, ((ray[i] > 0 ? kHalfM : -kHalfM) - from[i]) / ray[i]);
        }
    }
    return from + nearest * ray;
}

bool isMirror(const Vector3d& at) {
    return at.x() > kHalfM - 1e-6 && std::abs(at.y()) < kMirrorHalfM && std::abs(at.z()) < kMirrorHalfM;
}

/// Detail of several sizes that repeats nowhere near.
double texture(const Vector3d& p) {
    return 0.5 + 0.14 * (std::sin(9.1 * p.x() + 5.3 * p.y()) + std::sin(7.7 * p.y() - 8.9 * p.z() + 1)) +
           0.1 * std::sin(17.3 * p.x() - 13.1 * p.z() + 21.7 * p.y());
}

struct Look {
    double brightness = 0;
    double distanceM = 0; ///< of what stereo sees: what a mirror shows lies behind it
};

Look look(const Vector3d& from, const Vector3d& ray) {
    const Vector3d hit = wallHit(from, ray);
    const double distance = (hit - from).norm();
    if (!isMirror(hit)) {
        return {texture(hit), distance};
    }
    const Vector3d back(-ray.x(), ray.y(), ray.z());
    const Vector3d shown = wallHit(hit - Vector3d(1e-9, 0, 0), back);
    return {texture(shown), distance + (shown - hit).norm()};
}

RgbImage photoFrom(const Vector3d& place) {
    const EquirectSize size{2 * kMirrorWidth, kMirrorWidth};
    RgbImage picture(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double brightness = look(place, direction(size, Eigen::Vector2d(x, y))).brightness;
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(std::lround(255 * brightness)));
        }
    }
    return picture;
}

} // namespace

// Two photos before a mirror: what it shows is as deep as it looks, and all else has its own depth.
TEST(DepthSweep, SeesIntoMirrorsAndAllElseAsItIs) {
    const Vector3d second(0, 0.25, 0);
    const Vector3d third(0, 0, 0.25);
    const RgbImage first = photoFrom(Vector3d::Zero());
    const RgbImage aside = photoFrom(second);
    const RgbImage above = photoFrom(third);
    SweepOptions options;
    options.width = kMirrorWidth;
    options.coarseWidth = kMirrorWidth / 2;
    options.distances = 64;
    const std::vector<PosedPicture> others{{&aside, {Eigen::Quaterniond::Identity(), second}},
                                           {&above, {Eigen::Quaterniond::Identity(), third}}};
    const PhotoDepth depth = sweptDepth({&first, {}}, others, options);
    const EquirectSize size{kMirrorWidth, kMirrorWidth / 2};
    int right = 0;
    int all = 0;
    int deep = 0;
    int mirrored = 0;
    for (int y = size.height / 8; y < size.height * 7 / 8; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Vector3d ray = direction(size, Eigen::Vector2d(x, y));
            const double found = *depth.inverseM.at(x, y);
            ASSERT_TRUE(std::isfinite(found) && found > 0);
            const double off = std::abs(found - 1 / look(Vector3d::Zero(), ray).distanceM);
            if (isMirror(wallHit(Vector3d::Zero(), ray))) {
                deep += off < 0.07 ? 1 : 0;
                ++mirrored;
            } else {
                right += off < 0.07 ? 1 : 0;
                ++all;
            }
        }
    }
    EXPECT_GT(right, 0.85 * all);
    EXPECT_GT(deep, 0.6 * mirrored);
}

} // namespace spherewalk::scene
