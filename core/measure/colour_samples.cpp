// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/colour_samples.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spherewalk::measure {

using Eigen::Vector3d;

namespace {

constexpr int kSpot = 8;          ///< pixels
constexpr int kAround = 2;        ///< of a spot, even too: what lies beside it may slip in
constexpr int kEven = 24;         ///< grey levels from the darkest to the brightest
constexpr float kMostErrorPx = 4; ///< of a trusted pixel
constexpr double kDarkest = 4;    ///< grey levels that are no colour any more
constexpr double kBrightest = 250;

struct Spot {
    Vector3d mean = Vector3d::Zero(); ///< grey levels
    bool isEven = false;
};

Spot spotOf(const RgbImage& picture, int left, int top) {
    std::array<std::uint8_t, 3> least{255, 255, 255};
    std::array<std::uint8_t, 3> most{};
    Spot spot;
    for (int y = top - kAround; y < top + kSpot + kAround; ++y) {
        for (int x = left - kAround; x < left + kSpot + kAround; ++x) {
            const std::uint8_t* rgb = picture.at(x, y);
            const bool isInside = x >= left && x < left + kSpot && y >= top && y < top + kSpot;
            for (std::size_t c = 0; c < 3; ++c) {
                least[c] = std::min(least[c], rgb[c]);
                most[c] = std::max(most[c], rgb[c]);
                spot.mean[static_cast<Eigen::Index>(c)] += isInside ? rgb[c] : 0;
            }
        }
    }
    spot.mean /= kSpot * kSpot;
    spot.isEven = most[0] - least[0] <= kEven && most[1] - least[1] <= kEven && most[2] - least[2] <= kEven;
    return spot;
}

bool isTrusted(const render::PixelTrust& trust, int left, int top) {
    const auto doubts = static_cast<std::uint8_t>(render::PixelFlag::Unseen) |
                        static_cast<std::uint8_t>(render::PixelFlag::Pole) |
                        static_cast<std::uint8_t>(render::PixelFlag::Overlay);
    for (int y = top - kAround; y < top + kSpot + kAround; ++y) {
        for (int x = left - kAround; x < left + kSpot + kAround; ++x) {
            if (!(*trust.errorPx.at(x, y) <= kMostErrorPx) || (*trust.flags.at(x, y) & doubts) != 0) {
                return false;
            }
        }
    }
    return true;
}

bool isClipped(const Spot& spot) {
    return spot.mean.minCoeff() < kDarkest || spot.mean.maxCoeff() > kBrightest;
}

template <class Correct>
std::optional<double> meanError(std::span<const ColourSample> samples, const Correct& correct) {
    if (samples.empty()) {
        return std::nullopt;
    }
    double sum = 0;
    for (const ColourSample& sample : samples) {
        sum += (correct(sample.view) - sample.picture).norm();
    }
    return 255 * sum / static_cast<double>(samples.size());
}

} // namespace

void ColourSamples::add(const ColourSamples& other) {
    samples.insert(samples.end(), other.samples.begin(), other.samples.end());
    clipped += other.clipped;
}

ColourSamples colourSamples(const RgbImage& view, const render::PixelTrust& trust, const RgbImage& picture) {
    const auto fits = [&](const auto& other) {
        return other.width() == view.width() && other.height() == view.height();
    };
    if (!fits(picture) || !fits(trust.errorPx) || !fits(trust.flags)) {
        throw Error(ErrorKind::InvalidInput, "Colours of pictures of different sizes cannot be compared.");
    }
    ColourSamples result;
    for (int y = kAround; y + kSpot + kAround <= view.height(); y += kSpot) {
        for (int x = kAround; x + kSpot + kAround <= view.width(); x += kSpot) {
            if (!isTrusted(trust, x, y)) {
                continue;
            }
            const Spot seen = spotOf(view, x, y);
            const Spot taken = spotOf(picture, x, y);
            if (!seen.isEven || !taken.isEven) {
                continue;
            }
            if (isClipped(seen) || isClipped(taken)) {
                ++result.clipped;
            } else {
                result.samples.push_back({seen.mean / 255, taken.mean / 255});
            }
        }
    }
    return result;
}

std::optional<double> colourError(std::span<const ColourSample> samples) {
    return meanError(samples, [](const Vector3d& view) { return view; });
}

std::optional<double> colourError(std::span<const ColourSample> samples,
                                  const render::ColourCorrection& correction) {
    return meanError(samples, [&](const Vector3d& view) { return correction.corrected(view); });
}

} // namespace spherewalk::measure
