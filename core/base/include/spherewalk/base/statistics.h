// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk {

/// The quantile of this share: the value at index floor(share * n) in ascending order, at most the greatest.
/// The function reorders the values.
/// Range: at least one value, none of them NaN; share in [0, 1].
template <class Number>
Number quantileInPlace(std::vector<Number>& values, double share) {
    const auto count = static_cast<std::ptrdiff_t>(values.size());
    const auto index = std::min(count - 1, static_cast<std::ptrdiff_t>(share * static_cast<double>(count)));
    std::nth_element(values.begin(), values.begin() + index, values.end());
    return values[static_cast<std::size_t>(index)];
}

/// The same quantile. The caller's values stay in their order, because the function works on a copy.
template <class Number>
Number quantile(std::vector<Number> values, double share) {
    return quantileInPlace(values, share);
}

/// The middle value: the upper one of two for an even count, and 0 for no values.
template <class Number>
Number median(std::vector<Number> values) {
    return values.empty() ? Number{0} : quantileInPlace(values, 0.5);
}

/// The median of values and how far they spread about it.
template <class Number>
struct MedianAndSpread {
    Number median;
    Number sigma; ///< The standard deviation if the values are normal; a few wrong ones do not change it.
};

/// sigma is 1.4826 times the median distance from the median. Range: at least one value, none of them NaN.
template <class Number>
MedianAndSpread<Number> medianAndSpread(std::vector<Number> values) {
    const Number middle = quantileInPlace(values, 0.5);
    for (Number& value : values) {
        value = value < middle ? middle - value : value - middle;
    }
    return {middle, static_cast<Number>(1.4826) * quantileInPlace(values, 0.5)};
}

/// So many of the values, spread evenly over their places; all if there are fewer.
template <class Value>
std::vector<Value> spreadEvenly(const std::vector<Value>& all, std::size_t most) {
    const std::size_t count = std::min(all.size(), most);
    std::vector<Value> chosen;
    for (std::size_t k = 0; k < count; ++k) {
        chosen.push_back(all[k * all.size() / count]);
    }
    return chosen;
}

/// Spearman's rank correlation of two lists: 1 if both put everything in the same order, -1 in the opposite
/// order. Equal values share a rank. Nothing for fewer than three values, for lists of different lengths, and
/// for a list of one value throughout. Range: finite values. Source: Spearman 1904.
std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b);

} // namespace spherewalk
