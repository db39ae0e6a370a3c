// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <string>

namespace spherewalk::test {

/// How much a picture may differ from its golden one, in grey levels of the worst channel of a pixel.
struct GoldenLimits {
    int threshold = 4;    ///< Up to this difference a pixel is as it should be.
    double share = 0.002; ///< This share of the pixels may differ by more than the threshold.
    int hardLimit = 48;   ///< No pixel may differ by more than this.
};

/// Compares the picture with tests/data/golden/NAME.png. On a failure the test names two files in the build
/// folder: the picture, and the difference, brightened.
/// With SPHEREWALK_RENEW_GOLDEN=1 in the environment, the picture becomes the golden one instead.
void expectGolden(const RgbImage& picture, const std::string& name, const GoldenLimits& limits = {});

/// The difference of two pictures of one size, in the terms of GoldenLimits.
struct GoldenDifference {
    double share = 0; ///< The share of the pixels past the threshold.
    int worst = 0;    ///< The greatest difference of a channel.
    RgbImage picture; ///< Eight times the difference of each channel, at most 255.

    bool isWithin(const GoldenLimits& limits) const {
        return share <= limits.share && worst <= limits.hardLimit;
    }
};

GoldenDifference goldenDifference(const RgbImage& picture, const RgbImage& golden, int threshold);

} // namespace spherewalk::test
