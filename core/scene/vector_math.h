// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

/// Stands before a function, which is then also compiled for processors with vectors of 256 bits; the one
/// that fits the processor is called. The bits are the same on all: nothing is fused (-ffp-contract=off), and
/// no sum is taken in another order.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREWALK_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SPHEREWALK_VECTOR_CLONES
#endif

namespace spherewalk::scene {

/// std::atan2() in single precision, off by less than 3e-7; 0 for the origin. Compilers can do several at a
/// time, and the result is the same on every machine. Source: Abramowitz and Stegun 4.4.49.
inline float fastAngle(float y, float x) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float across = std::fabs(x);
    const float up = std::fabs(y);
    const float most = across > up ? across : up;
    const float least = across > up ? up : across;
    const float t = least / (most + 1e-30F);
    const float s = t * t;
    float sum = 0.0028662257F;
    sum = sum * s - 0.0161657367F;
    sum = sum * s + 0.0429096138F;
    sum = sum * s - 0.0752896400F;
    sum = sum * s + 0.1065626393F;
    sum = sum * s - 0.1420889944F;
    sum = sum * s + 0.1999355085F;
    sum = sum * s - 0.3333314528F;
    float result = t + t * s * sum;
    result = up > across ? 0.5F * kPi - result : result;
    result = x < 0 ? kPi - result : result;
    return y < 0 ? -result : result;
}

/// Where an equirectangular picture of this width shows a direction of any length, in single precision.
/// Units: pixels from the centre of the first column and row. Range: within a turn, not above the first row.
struct FastPixel {
    float u;
    float v;
};

inline FastPixel fastPixel(float x, float y, float z, float width) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float perRadian = width / (2 * kPi);
    const float column = (kPi - fastAngle(y, x)) * perRadian - 0.5F;
    const float line = (0.5F * kPi - fastAngle(z, std::sqrt(x * x + y * y))) * perRadian - 0.5F;
    return {column < 0 ? column + width : column, line < 0 ? 0 : line};
}

/// Cosines and sines of the azimuth of each column and of the elevation of each row of an equirectangular
/// picture.
struct PixelAngles {
    /// Range: an even width above 0.
    explicit PixelAngles(int width) {
        const double step = 2 * std::numbers::pi / width;
        for (int x = 0; x < width; ++x) {
            cosAzimuth.push_back(static_cast<float>(std::cos(std::numbers::pi - step * (x + 0.5))));
            sinAzimuth.push_back(static_cast<float>(std::sin(std::numbers::pi - step * (x + 0.5))));
        }
        for (int y = 0; y < width / 2; ++y) {
            cosElevation.push_back(static_cast<float>(std::cos(std::numbers::pi / 2 - step * (y + 0.5))));
            sinElevation.push_back(static_cast<float>(std::sin(std::numbers::pi / 2 - step * (y + 0.5))));
        }
    }

    std::vector<float> cosAzimuth;
    std::vector<float> sinAzimuth;
    std::vector<float> cosElevation;
    std::vector<float> sinElevation;
};

} // namespace spherewalk::scene
