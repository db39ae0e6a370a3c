// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch_match.h"

#include "brightness.h"

#include "spherewalk/base/median.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFirstRow = kSketchHeight / 6; ///< 60 degrees above the horizon
constexpr int kEndRow = kSketchHeight - kFirstRow;
constexpr int kRows = kEndRow - kFirstRow;

/// Brightness between 60 degrees above and below the horizon without each row's mean, weighted by the area
/// that a pixel covers, and scaled so that a correlation with itself is 1.
class Relief {
  public:
    explicit Relief(const Sketch& sketch) : m_values(std::size_t{kRows} * kSketchWidth) {
        double sum = 0;
        for (int v = 0; v < kRows; ++v) {
            float* row = at(v);
            double mean = 0;
            for (int u = 0; u < kSketchWidth; ++u) {
                const std::uint8_t* p = sketch.picture.at(u, v + kFirstRow);
                row[u] = brightness(p);
                mean += row[u] / kSketchWidth;
            }
            const double elevation = kPi / 2 - kPi * (v + kFirstRow + 0.5) / kSketchHeight;
            for (int u = 0; u < kSketchWidth; ++u) {
                row[u] = static_cast<float>((row[u] - mean) * std::sqrt(std::cos(elevation)));
                sum += double{row[u]} * row[u];
            }
        }
        const auto scale = static_cast<float>(sum > 0 ? 1 / std::sqrt(sum) : 0);
        for (float& value : m_values) {
            value *= scale;
        }
    }

    void turnUpsideDown() { std::reverse(m_values.begin(), m_values.end()); }

    float* at(int row) { return m_values.data() + std::ptrdiff_t{row} * kSketchWidth; }

    const float* at(int row) const { return m_values.data() + std::ptrdiff_t{row} * kSketchWidth; }

    /// With the other one's columns that lie so far to the right.
    double correlation(const Relief& other, int shift) const {
        double sum = 0;
        for (int v = 0; v < kRows; ++v) {
            sum += product(at(v), other.at(v) + shift, kSketchWidth - shift);
            sum += product(at(v) + (kSketchWidth - shift), other.at(v), shift);
        }
        return sum;
    }

  private:
    static float product(const float* a, const float* b, int count) {
        constexpr int kLanes = 8; // independent sums, so that they are made side by side
        std::array<float, kLanes> sums{};
        int i = 0;
        for (; i + kLanes <= count; i += kLanes) {
            for (int lane = 0; lane < kLanes; ++lane) {
                sums[static_cast<std::size_t>(lane)] += a[i + lane] * b[i + lane];
            }
        }
        float sum = 0;
        for (; i < count; ++i) {
            sum += a[i] * b[i];
        }
        for (const float lane : sums) {
            sum += lane;
        }
        return sum;
    }

    std::vector<float> m_values;
};

struct BestShift {
    int shift = 0;
    double likeness = -1;
};

BestShift bestShift(const Relief& photo, const Relief& other) {
    BestShift best;
    for (int shift = 0; shift < kSketchWidth; ++shift) {
        const double likeness = photo.correlation(other, shift);
        if (likeness > best.likeness) {
            best = {shift, likeness};
        }
    }
    return best;
}

std::array<double, 3> gains(const RgbImage& photo, const RgbImage& other, int shift) {
    constexpr int kDark = 12;
    constexpr int kBright = 243;
    std::array<std::vector<float>, 3> ratios;
    for (int v = kFirstRow; v < kEndRow; ++v) {
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = photo.at(u, v);
            const std::uint8_t* q = other.at((u + shift) % kSketchWidth, v);
            for (std::size_t c = 0; c < 3; ++c) {
                if (std::min(p[c], q[c]) >= kDark && std::max(p[c], q[c]) <= kBright) {
                    ratios[c].push_back(static_cast<float>(p[c]) / q[c]);
                }
            }
        }
    }
    std::array<double, 3> result{1, 1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!ratios[c].empty()) {
            result[c] = median(std::move(ratios[c]));
        }
    }
    return result;
}

} // namespace

SketchMatch match(const Sketch& photo, const Sketch& other) {
    Relief own(photo);
    const Relief theirs(other);
    SketchMatch result;
    const BestShift upright = bestShift(own, theirs);
    result.likeness = upright.likeness;
    const double turn = -2 * kPi * upright.shift / kSketchWidth;
    result.turn = Radians(turn <= -kPi ? turn + 2 * kPi : turn);
    result.gains = gains(photo.picture, other.picture, upright.shift);
    own.turnUpsideDown();
    result.upsideDownLikeness = bestShift(own, theirs).likeness;
    return result;
}

} // namespace spherewalk::photo
