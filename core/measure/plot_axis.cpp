// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/plot_axis.h"

#include <cmath>

namespace spherewalk::measure {

namespace {

/// 1, 2, 5, 10, 20 ...: number `index`, which may be negative.
double roundNumber(int index) {
    constexpr double kMantissas[] = {1, 2, 5};
    const int mantissa = ((index % 3) + 3) % 3;
    return kMantissas[mantissa] * std::pow(10, (index - mantissa) / 3);
}

/// The greatest such number that is not above the value.
int indexBelow(double value) {
    int index = 3 * static_cast<int>(std::floor(std::log10(value)));
    while (roundNumber(index + 1) <= value * (1 + 1e-9)) {
        ++index;
    }
    return index;
}

} // namespace

std::vector<double> evenTicks(double least, double greatest, int most) {
    int index = indexBelow((greatest - least) / most);
    const auto first = [&] { return std::floor(least / roundNumber(index) + 1e-9); };
    const auto last = [&] { return std::ceil(greatest / roundNumber(index) - 1e-9); };
    while (last() - first() > most) {
        ++index;
    }
    std::vector<double> ticks;
    for (double i = first(); i <= last(); ++i) {
        ticks.push_back(i * roundNumber(index));
    }
    return ticks;
}

std::vector<double> logarithmicTicks(double least, double greatest) {
    std::vector<double> ticks;
    for (int index = indexBelow(least); ticks.size() < 2 || ticks.back() < greatest; ++index) {
        ticks.push_back(roundNumber(index));
    }
    return ticks;
}

} // namespace spherewalk::measure
