// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr int kWidth = 64; ///< Parallax hardly shows at this width.
constexpr int kDarkest = 8;
constexpr int kBrightest = 245;
constexpr std::size_t kFewest = 100;
constexpr double kMostLog = 2.5; ///< The logarithm of the greatest gain.
constexpr double kPatches = 40;  ///< About so many of the directions tell something of their own.
constexpr double kSigmas = 3;

bool isWithin(int value) {
    return value > kDarkest && value < kBrightest;
}

float gainFrom(std::vector<double>& logs) {
    if (logs.size() < kFewest) {
        return 1;
    }
    const double middle = quantileInPlace(logs, 0.5);
    for (double& value : logs) {
        value = std::abs(value - middle);
    }
    const double sigma = 1.4826 * quantileInPlace(logs, 0.5) / std::sqrt(kPatches);
    return std::abs(middle) < kSigmas * sigma
               ? 1.0F
               : static_cast<float>(std::exp(std::clamp(middle, -kMostLog, kMostLog)));
}

} // namespace

Gains gainsTo(const RgbImage& photo, const RgbImage& other, const Eigen::Matrix3d& otherFromPhoto) {
    const EquirectSize size{kWidth, kWidth / 2};
    const RgbImage own = photo::resized(photo, size.width, size.height);
    const RgbImage its = photo::resized(other, size.width, size.height);
    std::array<std::vector<double>, 3> logs;
    double rows = 0; // As many of each row count as its length on the sphere asks for.
    for (int y = 0; y < size.height; ++y) {
        const double length = std::sin(std::numbers::pi * (y + 0.5) / size.height);
        for (int x = 0; x < size.width; ++x) {
            rows += length;
            if (rows < 1) {
                continue;
            }
            rows -= 1;
            const Eigen::Vector2d at = pixel(size, otherFromPhoto * direction(size, Eigen::Vector2d(x, y)));
            const std::uint8_t* b =
                its.at(static_cast<int>(std::floor(at.x() + 0.5)) % size.width,
                       std::clamp(static_cast<int>(std::floor(at.y() + 0.5)), 0, size.height - 1));
            const std::uint8_t* a = own.at(x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                if (isWithin(a[c]) && isWithin(b[c])) {
                    logs[c].push_back(std::log(static_cast<double>(a[c]) / b[c]));
                }
            }
        }
    }
    return {gainFrom(logs[0]), gainFrom(logs[1]), gainFrom(logs[2])};
}

} // namespace spherewalk::scene
