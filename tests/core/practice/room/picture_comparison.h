// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spherewalk::test {

/// Peak signal to noise ratio, dB; +infinity for equal pictures, 0 for pictures of different sizes.
inline double psnr(const RgbImage& a, const RgbImage& b) {
    if (a.width() != b.width() || a.height() != b.height() || a.empty()) {
        return 0;
    }
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const double difference = double(a.values()[i]) - double(b.values()[i]);
        sum += difference * difference;
    }
    return sum == 0 ? std::numeric_limits<double>::infinity()
                    : 10 * std::log10(255.0 * 255.0 * double(a.values().size()) / sum);
}

/// Each pixel the average of factor x factor pixels.
inline RgbImage reduced(const RgbImage& picture, int factor) {
    RgbImage small(picture.width() / factor, picture.height() / factor);
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            for (int c = 0; c < 3; ++c) {
                int sum = 0;
                for (int j = 0; j < factor; ++j) {
                    for (int i = 0; i < factor; ++i) {
                        sum += picture.at(x * factor + i, y * factor + j)[c];
                    }
                }
                small.at(x, y)[c] =
                    static_cast<std::uint8_t>((sum + factor * factor / 2) / (factor * factor));
            }
        }
    }
    return small;
}

/// Bilinear, wrapping at the seam.
inline std::array<double, 3> sampled(const RgbImage& equirect, const Eigen::Vector3d& direction) {
    const Eigen::Vector2d at = pixel({equirect.width(), equirect.height()}, direction);
    const int x = static_cast<int>(std::floor(at.x()));
    const int y = static_cast<int>(std::floor(at.y()));
    const double tx = at.x() - x;
    const double ty = at.y() - y;
    const auto value = [&](int i, int j, int c) {
        const int wrapped = (i + equirect.width()) % equirect.width();
        return double(equirect.at(wrapped, std::clamp(j, 0, equirect.height() - 1))[c]);
    };
    std::array<double, 3> colour{};
    for (int c = 0; c < 3; ++c) {
        colour[std::size_t(c)] = (1 - ty) * ((1 - tx) * value(x, y, c) + tx * value(x + 1, y, c)) +
                                 ty * ((1 - tx) * value(x, y + 1, c) + tx * value(x + 1, y + 1, c));
    }
    return colour;
}

} // namespace spherewalk::test
