// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/sensor_fit.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/colour_correction.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::compare {

using Eigen::Vector2d;
using Eigen::Vector3d;
using render::linearLight;

namespace {

constexpr int kSpotPx = 8;
constexpr double kDarkestSpot = 12; ///< mean grey levels, away from clipping
constexpr double kBrightestSpot = 240;
constexpr std::size_t kFewestColours = 150;
constexpr std::size_t kFewestAtALight = 40; ///< spots of a channel
constexpr int kMostLights = 16;
constexpr double kQuietShare = 0.25;
/// The quantile of that share of noiseSamples() of pure noise, by its variance (20000 spots of normal
/// numbers).
constexpr double kQuietVariance = 0.771;
constexpr double kLeastNoise = 1e-7; ///< of full well: less is none

const std::array<double, 256>& lightOfStored() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> made{};
        for (std::size_t value = 0; value < made.size(); ++value) {
            made[value] = linearLight(static_cast<double>(value) / 255);
        }
        return made;
    }();
    return table;
}

/// The variance that rounding to whole grey levels adds.
double roundingVariance(double light) {
    const double stored = render::storedValue(light);
    const double step = linearLight(stored + 0.5 / 255) - linearLight(stored - 0.5 / 255);
    return step * step / 12;
}

/// Spots of a channel at about the same light.
struct Level {
    double light = 0;
    double variance = 0;
    double factor = 0; ///< The brightness of the channel, of that of the views.
};

std::vector<Level> levelsOf(std::span<const NoiseSample> samples, int channel, double factor) {
    std::vector<std::pair<double, double>> spots; // light, variance
    for (const NoiseSample& sample : samples) {
        spots.emplace_back(sample.light[channel], sample.variance[channel]);
    }
    std::sort(spots.begin(), spots.end());
    const std::size_t size = std::max(kFewestAtALight, spots.size() / kMostLights);
    std::vector<Level> levels;
    for (std::size_t begin = 0; begin + size <= spots.size(); begin += size) {
        std::vector<double> lights;
        std::vector<double> variances;
        for (std::size_t i = begin; i < begin + size; ++i) {
            lights.push_back(spots[i].first);
            variances.push_back(spots[i].second);
        }
        const double light = spherewalk::median(lights);
        levels.push_back(
            {light, spherewalk::quantile(variances, kQuietShare) / kQuietVariance - roundingVariance(light),
             factor});
    }
    return levels;
}

/// 1 / full well and (read noise / full well)^2 of the line through all levels. Each counts by its relative
/// error.
Vector2d photonTransfer(const std::vector<Level>& levels, bool hasRead) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Vector2d right = Vector2d::Zero();
    for (const Level& level : levels) {
        const double sigma = std::max(level.variance, roundingVariance(level.light));
        const Vector2d row =
            Vector2d(level.factor * level.light, hasRead ? level.factor * level.factor : 0) / sigma;
        normal += row * row.transpose();
        right += row * level.variance / sigma;
    }
    if (!hasRead) {
        return {normal(0, 0) > 0 ? right[0] / normal(0, 0) : 0, 0};
    }
    return normal.ldlt().solve(right);
}

Vector3d brightness(std::span<const ColourSample> colours) {
    Vector3d factors;
    for (int c = 0; c < 3; ++c) {
        std::vector<double> ratios;
        for (const ColourSample& sample : colours) {
            ratios.push_back(linearLight(sample.picture[c]) / std::max(linearLight(sample.view[c]), 1e-4));
        }
        factors[c] = spherewalk::median(ratios);
    }
    return factors;
}

} // namespace

std::vector<NoiseSample> noiseSamples(const RgbImage& picture) {
    const std::array<double, 256>& light = lightOfStored();
    std::vector<NoiseSample> samples;
    for (int top = 1; top + kSpotPx < picture.height(); top += kSpotPx) {
        for (int left = 1; left + kSpotPx < picture.width(); left += kSpotPx) {
            Vector3d stored = Vector3d::Zero();
            NoiseSample sample{Vector3d::Zero(), Vector3d::Zero()};
            for (int y = top; y < top + kSpotPx; ++y) {
                for (int x = left; x < left + kSpotPx; ++x) {
                    for (int c = 0; c < 3; ++c) {
                        const auto at = [&](int right, int down) {
                            return light[picture.at(x + right, y + down)[c]];
                        };
                        const double bend = at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1) + 4 * at(0, 0) -
                                            2 * (at(0, -1) + at(0, 1) + at(-1, 0) + at(1, 0));
                        sample.variance[c] += bend * bend / 36; // 36: the sum of the weights' squares
                        sample.light[c] += at(0, 0);
                        stored[c] += picture.at(x, y)[c];
                    }
                }
            }
            constexpr double kPixels = kSpotPx * kSpotPx;
            if (stored.minCoeff() >= kDarkestSpot * kPixels &&
                stored.maxCoeff() <= kBrightestSpot * kPixels) {
                samples.push_back({sample.light / kPixels, sample.variance / kPixels});
            }
        }
    }
    return samples;
}

SensorFit fittedSensor(std::span<const ColourSample> colours, std::span<const NoiseSample> noise) {
    SensorFit fit;
    fit.colourSpots = colours.size();
    fit.noiseSpots = noise.size();
    Vector3d factors = Vector3d::Ones();
    if (colours.size() < kFewestColours) {
        fit.why.push_back(text("Exposure and white balance cannot be told from ", colours.size(),
                               " even spots; ", kFewestColours,
                               " are needed. Take more pictures of walls and floors."));
    } else {
        factors = brightness(colours);
        fit.hasExposure = true;
        fit.sensor.exposure.gainDb = std::clamp(20 * std::log10(factors[1]), -20.0, 60.0);
        for (std::size_t c = 0; c < 3; ++c) {
            fit.sensor.whiteBalance.gains[c] =
                std::clamp(factors[static_cast<Eigen::Index>(c)] / factors[1], 0.0, 16.0);
        }
    }
    std::vector<Level> levels;
    for (int c = 0; c < 3; ++c) {
        const std::vector<Level> of = levelsOf(noise, c, factors[c]);
        levels.insert(levels.end(), of.begin(), of.end());
    }
    Vector2d line = levels.size() < 3 ? Vector2d::Zero() : photonTransfer(levels, true);
    if (line[1] < 0) {
        line = photonTransfer(levels, false);
    }
    if (line[0] > kLeastNoise) {
        fit.hasNoise = true;
        fit.sensor.noise = {1 / line[0], std::sqrt(line[1]) / line[0]};
    } else {
        fit.why.push_back(
            text("Noise cannot be told from ", noise.size(),
                 " spots: there are too few, or it does not grow with light. Take pictures of dark "
                 "and bright things, without noise reduction."));
    }
    return fit;
}

} // namespace spherewalk::compare
