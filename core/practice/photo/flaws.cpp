// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/exposure.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace spherewalk::practice {

namespace {

constexpr double kFadeDeg = 1; ///< On either side of the seam.
constexpr std::uint64_t kColourStream = 0xbb67ae8584caa73bULL;
constexpr std::uint64_t kNoiseStream = 0x3c6ef372fe94f82bULL;

/// Pictures store about the square root of the light, so a gain of the light is the square of this gain.
using Gains = std::array<double, RgbImage::kChannels>;

Gains gainsOf(const PhotoFlaws& flaws, int shot) {
    FixedRandom random(flaws.seed ^ kColourStream, static_cast<std::uint64_t>(shot));
    const double exposure = std::exp2(0.5 * random.normal(flaws.exposureSigmaEv));
    const double red = 1 + random.normal(flaws.whiteBalanceSigma);
    const double blue = 1 + random.normal(flaws.whiteBalanceSigma);
    return {exposure * std::max(0.2, red), exposure, exposure * std::max(0.2, blue)};
}

/// Rows below the edge of the robot, and the spokes of its wheels.
void drawRobot(RgbImage& picture, double halfAngleDeg) {
    const int first = static_cast<int>(std::ceil(picture.height() * (1 - halfAngleDeg / 180)));
    for (int y = std::max(0, first); y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double turn = 2 * std::numbers::pi * (x + 0.5) / picture.width();
            const double depth = static_cast<double>(y - first) / std::max(1, picture.height() - first);
            const bool isWheel = std::cos(4 * turn) > 0.75 && depth < 0.6;
            const int shade = isWheel ? 22 : 70 + static_cast<int>(60 * depth);
            const std::array<int, 3> colour = {shade, shade + 4, shade + 10};
            std::transform(colour.begin(), colour.end(), picture.at(x, y),
                           [](int value) { return static_cast<std::uint8_t>(value); });
        }
    }
}

} // namespace

void PhotoFlaws::validate() const {
    const auto check = [](const char* what, double value, double most) {
        if (!(value >= 0 && value <= most)) { // not for NaN
            throw Error(ErrorKind::InvalidInput, text("The practice camera's ", what,
                                                      " must be between 0 and ", most, ", not ", value, "."));
        }
    };
    check("change of exposure in stops", exposureSigmaEv, 3);
    check("change of white balance", whiteBalanceSigma, 0.5);
    check("noise in grey levels", noiseSigma, 64);
    check("distance of a lens from the middle in metres", lensOffsetM, 0.2);
    check("robot's half angle in degrees", robotHalfAngleDeg, 80);
    check("share of photos with a person", personShare, 1);
}

PhotoFlaws PhotoFlaws::ofARealCamera(std::uint64_t seed) {
    PhotoFlaws flaws;
    flaws.exposureSigmaEv = 0.4;
    flaws.whiteBalanceSigma = 0.03;
    flaws.noiseSigma = 2;
    flaws.lensOffsetM = 0.01;
    flaws.robotHalfAngleDeg = 25;
    flaws.seed = seed;
    return flaws;
}

RgbImage stitched(const RgbImage& front, const RgbImage& back) {
    RgbImage picture(front.width(), front.height());
    for (int y = 0; y < picture.height(); ++y) {
        const double elevation = std::numbers::pi * (0.5 - (y + 0.5) / picture.height());
        for (int x = 0; x < picture.width(); ++x) {
            const double azimuth = std::numbers::pi * (1 - 2 * (x + 0.5) / picture.width());
            const double ahead = std::asin(std::cos(elevation) * std::cos(azimuth)) * 180 / std::numbers::pi;
            const double share = std::clamp(0.5 + ahead / (2 * kFadeDeg), 0.0, 1.0);
            for (int c = 0; c < RgbImage::kChannels; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(
                    std::lround(share * front.at(x, y)[c] + (1 - share) * back.at(x, y)[c]));
            }
        }
    }
    return picture;
}

double lightOf(const PhotoFlaws& flaws, int shot) {
    return std::pow(gainsOf(flaws, shot)[1], 2);
}

void addFlaws(RgbImage& picture, const PhotoFlaws& flaws, int shot) {
    if (flaws.robotHalfAngleDeg > 0) {
        drawRobot(picture, flaws.robotHalfAngleDeg);
    }
    if (flaws.exposureSigmaEv == 0 && flaws.whiteBalanceSigma == 0 && flaws.noiseSigma == 0) {
        return;
    }
    const Gains gains = gainsOf(flaws, shot);
    FixedRandom random(flaws.seed ^ kNoiseStream, static_cast<std::uint64_t>(shot));
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            std::uint8_t* pixel = picture.at(x, y);
            for (std::size_t c = 0; c < gains.size(); ++c) {
                const double noise = flaws.noiseSigma > 0 ? random.normal(flaws.noiseSigma) : 0;
                pixel[c] = static_cast<std::uint8_t>(
                    std::lround(std::clamp(gains[c] * pixel[c] + noise, 0.0, 255.0)));
            }
        }
    }
}

} // namespace spherewalk::practice
