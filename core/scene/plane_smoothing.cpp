// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_smoothing.h"

#include "spherewalk/base/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace spherewalk::scene {

namespace {

constexpr int kRadius = 3;
constexpr float kSameSurface = 0.02F;
constexpr int kFewest = 6;

/// Sums for a plane through values about a pixel.
class PlaneFit {
  public:
    void add(int x, int y, float value) {
        const Eigen::Vector3f row(1, static_cast<float>(x), static_cast<float>(y));
        m_square += row * row.transpose();
        m_right += value * row;
        ++m_count;
    }

    int count() const { return m_count; }

    /// The plane's value at the pixel itself. The ridge decides where all lie in one line.
    float middle() const {
        Eigen::Matrix3f square = m_square;
        square(1, 1) += 1e-3F;
        square(2, 2) += 1e-3F;
        return (square.inverse() * m_right)[0];
    }

  private:
    Eigen::Matrix3f m_square = Eigen::Matrix3f::Zero();
    Eigen::Vector3f m_right = Eigen::Vector3f::Zero();
    int m_count = 0;
};

float smoothed(const Plane& inverse, int x, int y) {
    const float here = *inverse.at(x, y);
    PlaneFit fit;
    for (int j = std::max(-kRadius, -y); j <= std::min(kRadius, inverse.height() - 1 - y); ++j) {
        for (int i = -kRadius; i <= kRadius; ++i) {
            const float value = *inverse.at((x + i + inverse.width()) % inverse.width(), y + j);
            const float away = std::max(1.0F, 0.5F * static_cast<float>(std::max(std::abs(i), std::abs(j))));
            if (std::fabs(value - here) < kSameSurface * here * away) {
                fit.add(i, j, value - here); // small numbers keep their digits
            }
        }
    }
    const float value = fit.count() >= kFewest ? here + fit.middle() : here;
    return value > 0 ? value : here;
}

} // namespace

Plane smoothedSurfaces(const Plane& inverseM, int threads) {
    Plane result(inverseM.width(), inverseM.height());
    parallelFor(result.height(), 8, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < result.width(); ++x) {
                *result.at(x, y) = smoothed(inverseM, x, y);
            }
        }
    });
    return result;
}

} // namespace spherewalk::scene
