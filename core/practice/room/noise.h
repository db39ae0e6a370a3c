// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spherewalk::practice {

/// Deterministic noise: integer hashes and arithmetic that gives the same bits on every machine.

inline std::uint32_t mixed(std::uint32_t h) {
    h ^= h >> 16;
    h *= 0x7feb352dU;
    h ^= h >> 15;
    h *= 0x846ca68bU;
    return h ^ (h >> 16);
}

inline std::uint32_t hash(int x, int y, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1U +
                      static_cast<std::uint32_t>(y) * 0x85ebca77U + seed * 0xc2b2ae3dU;
    h ^= h >> 15;
    h *= 0x2c1b3c6dU;
    h ^= h >> 12;
    h *= 0x297a2d39U;
    return h;
}

/// In [0, 1).
inline float unit(std::uint32_t h) {
    return static_cast<float>(h >> 8) * (1.0F / 16777216.0F);
}

inline int floorInt(float x) {
    const int i = static_cast<int>(x);
    return i - (x < static_cast<float>(i) ? 1 : 0);
}

inline float clamp01(float x) {
    return std::min(1.0F, std::max(0.0F, x));
}

inline float smooth(float t) {
    return t * t * (3 - 2 * t);
}

/// 0 below `from`, 1 above `to`, smooth between.
inline float smoothStep(float from, float to, float x) {
    return smooth(clamp01((x - from) / (to - from)));
}

inline float lerp(float a, float b, float t) {
    return a + (b - a) * t;
}

/// Value noise with cells of size 1, in [-1, 1].
inline float valueNoise(float x, float y, std::uint32_t seed) {
    const int ix = floorInt(x);
    const int iy = floorInt(y);
    const float tx = smooth(x - static_cast<float>(ix));
    const float ty = smooth(y - static_cast<float>(iy));
    const float low = lerp(unit(hash(ix, iy, seed)), unit(hash(ix + 1, iy, seed)), tx);
    const float high = lerp(unit(hash(ix, iy + 1, seed)), unit(hash(ix + 1, iy + 1, seed)), tx);
    return 2 * lerp(low, high, ty) - 1;
}

/// The same in space.
inline float valueNoise(float x, float y, float z, std::uint32_t seed) {
    const int iz = floorInt(z);
    const auto layer = [&](int i) {
        return valueNoise(x, y, seed + static_cast<std::uint32_t>(i) * 0x9e37U);
    };
    return lerp(layer(iz), layer(iz + 1), smooth(z - static_cast<float>(iz)));
}

/// How much of a detail of cells of this size survives in a pixel of this footprint.
inline float survival(float cell, float footprint) {
    return smoothStep(0.45F, 1.9F, cell / footprint);
}

/// Value noise in octaves of falling size, without those that the footprint cannot hold. Range: about [-1,
/// 1] for a gain of one half.
inline float fractalNoise(float x, float y, float cell, int octaves, float gain, std::uint32_t seed,
                          float footprint) {
    float sum = 0;
    float amplitude = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const float weight = survival(cell, footprint);
        if (weight <= 0) {
            break;
        }
        sum += weight * amplitude * valueNoise(x / cell, y / cell, seed + static_cast<std::uint32_t>(octave));
        cell *= 0.5F;
        amplitude *= gain;
    }
    return sum;
}

inline float fractalNoise(float x, float y, float z, float cell, int octaves, float gain, std::uint32_t seed,
                          float footprint) {
    float sum = 0;
    float amplitude = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const float weight = survival(cell, footprint);
        if (weight <= 0) {
            break;
        }
        sum += weight * amplitude *
               valueNoise(x / cell, y / cell, z / cell, seed + 77U * static_cast<std::uint32_t>(octave));
        cell *= 0.5F;
        amplitude *= gain;
    }
    return sum;
}

/// The share of a box of width w around x that lies above the edge.
inline float boxStep(float edge, float x, float w) {
    return clamp01((x - edge) / w + 0.5F);
}

/// The share of a box of width w around x that lies within [from, to].
inline float boxPulse(float from, float to, float x, float w) {
    return std::max(0.0F, std::min(x + 0.5F * w, to) - std::max(x - 0.5F * w, from)) / w;
}

/// The same for a line of this width repeated with this period, at 0, period, ...
inline float boxLines(float period, float width, float x, float w) {
    if (w >= period) {
        return width / period;
    }
    const float at = x - period * static_cast<float>(floorInt(x / period + 0.5F));
    return boxPulse(-0.5F * width, 0.5F * width, at, w) +
           boxPulse(period - 0.5F * width, period + 0.5F * width, at, w) +
           boxPulse(-period - 0.5F * width, -period + 0.5F * width, at, w);
}

/// A grid of squares that are 0 or 1 at random (1 with this density), averaged over the footprint.
inline float squares(float x, float y, float cell, float density, std::uint32_t seed, float footprint) {
    const float w = footprint / cell;
    if (w >= 2) {
        return density;
    }
    const float box = std::min(w, 1.0F);
    const float gx = x / cell;
    const float gy = y / cell;
    const int ix = floorInt(gx - 0.5F * box);
    const int iy = floorInt(gy - 0.5F * box);
    const float rightShare = clamp01((gx + 0.5F * box - static_cast<float>(ix + 1)) / box);
    const float upperShare = clamp01((gy + 0.5F * box - static_cast<float>(iy + 1)) / box);
    const auto value = [&](int i, int j) { return unit(hash(i, j, seed)) < density ? 1.0F : 0.0F; };
    const float low = lerp(value(ix, iy), value(ix + 1, iy), rightShare);
    const float high = lerp(value(ix, iy + 1), value(ix + 1, iy + 1), rightShare);
    return lerp(density, lerp(low, high, upperShare), w > 1 ? smooth(2 - w) : 1.0F);
}

} // namespace spherewalk::practice
