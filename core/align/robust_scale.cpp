// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust_scale.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr double kLeastScale = 0.3;
constexpr double kWithin = 2.5;        // standard deviations that are looked at
constexpr double kLeftWithin = 0.951;  // of a normal distribution's deviation, if cut there
constexpr double kAtThirtieth = 0.385; // |residual| that 30 % of a normal distribution stay below

double quantile(std::vector<double>& values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

} // namespace

double agreeingScale(std::vector<double> residuals, double largest) {
    if (residuals.size() < 8) {
        return 1;
    }
    for (double& residual : residuals) {
        residual = std::abs(residual);
    }
    // A fixed point, begun from above: the root mean square of what is within the threshold.
    double scale = std::clamp(quantile(residuals, 0.3) / kAtThirtieth, kLeastScale, largest);
    for (int round = 0; round < 8; ++round) {
        double sum = 0;
        int count = 0;
        for (const double residual : residuals) {
            if (residual < kWithin * scale) {
                sum += residual * residual;
                ++count;
            }
        }
        scale = std::clamp(std::sqrt(sum / std::max(count, 1)) / kLeftWithin, kLeastScale, largest);
    }
    return scale;
}

} // namespace spherewalk::align
