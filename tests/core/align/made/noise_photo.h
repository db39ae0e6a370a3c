// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/equirect.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace spherewalk::test {

/// Smooth noise in space, the same on every machine: [0, 1].
inline double spaceNoise(const Eigen::Vector3d& at) {
    const Eigen::Vector3d corner = at.array().floor();
    const Eigen::Vector3d t = at - corner;
    const auto value = [&](int i) {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::int64_t>(corner[axis]) + (i >> axis & 1);
            hash = (hash ^ static_cast<std::uint64_t>(place)) * 0x9E3779B97F4A7C15ULL;
            hash ^= hash >> 29;
        }
        return static_cast<double>(hash >> 40) / static_cast<double>(1 << 24);
    };
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double s = t[axis] * t[axis] * (3 - 2 * t[axis]);
            weight *= (i >> axis & 1) == 1 ? s : 1 - s;
        }
        sum += weight * value(i);
    }
    return sum;
}

/// A photo of a world of noise that is infinitely far away, turned in any way.
inline RgbImage noisePhoto(const Eigen::Quaterniond& roomFromPhoto, int width = 1024) {
    RgbImage photo(width, width / 2);
    for (int y = 0; y < photo.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const Eigen::Vector3d at =
                roomFromPhoto * direction(EquirectSize{width, width / 2}, Eigen::Vector2d(x, y));
            const double value = 0.5 * spaceNoise(at * 12) +
                                 0.3 * spaceNoise(at * 25 + Eigen::Vector3d::Ones()) +
                                 0.2 * spaceNoise(at * 50);
            std::fill_n(photo.at(x, y), 3, static_cast<std::uint8_t>(std::lround(255 * value)));
        }
    }
    return photo;
}

} // namespace spherewalk::test
