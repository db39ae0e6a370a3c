// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <cmath>
#include <numbers>
#include <vector>

/// Stands before a function, which is then also compiled for processors with vectors of 256 bits; the one
/// that fits the processor is called. The bits are the same on all: nothing is fused (-ffp-contract=off), and
/// no sum is taken in another order.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREWALK_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SPHEREWALK_VECTOR_CLONES
#endif

namespace spherewalk::scene {

/// std::atan2() in single precision, off by less than 3e-7; 0 for the origin. Compilers can do several at a
/// time, and the result is the same on every machine. Source: Abramowitz and Stegun 4.4.49.
inline float fastAngle(float y, float x) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float across = std::fabs(x);
    const float up = std::fabs(y);
    const float most = across > up ? across : up;
    const float least = across > up ? up : across;
    const float t = least / (most + 1e-30F);
    const float s = t * t;
    float sum = 0.0028662257F;
    sum = sum * s - 0.0161657367F;
    sum = sum * s + 0.0429096138F;
    sum = sum * s - 0.0752896400F;
    sum = sum * s + 0.1065626393F;
    sum = sum * s - 0.1420889944F;
    sum = sum * s + 0.1999355085F;
    sum = sum * s - 0.3333314528F;
    float result = t + t * s * sum;
    result = up > across ? 0.5F * kPi - result : result;
    result = x < 0 ? kPi - result : result;
    return y < 0 ? -result : result;
}

/// Where an equirectangular picture of this width shows a direction of any length, in single precision.
/// Units: pixels from the centre of the first column and row. Range: within a turn, not above the first row.
struct FastPixel {
    float u;
    float v;
};

inline FastPixel fastPixel(float x, float y, float z, float width) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float perRadian = width / (2 * kPi);
    const float column = (kPi - fastAngle(y, x)) * perRadian - 0.5F;
    const float line = (0.5F * kPi - fastAngle(z, std::sqrt(x * x + y * y))) * perRadian - 0.5F;
    return {column < 0 ? column + width : column, line < 0 ? 0 : line};
}

/// Cosines and sines of the azimuth of each column and of the elevation of each row of an equirectangular
/// picture.
struct PixelAngles {
    /// Range: an even width above 0.
    explicit PixelAngles(int width) {
        const double step = 2 * std::numbers::pi / width;
        for (int x = 0; x < width; ++x) {
            cosAzimuth.push_back(static_cast<float>(std::cos(std::numbers::pi - step * (x + 0.5))));
            sinAzimuth.push_back(static_cast<float>(std::sin(std::numbers::pi - step * (x + 0.5))));
        }
        for (int y = 0; y < width / 2; ++y) {
            cosElevation.push_back(static_cast<float>(std::cos(std::numbers::pi / 2 - step * (y + 0.5))));
            sinElevation.push_back(static_cast<float>(std::sin(std::numbers::pi / 2 - step * (y + 0.5))));
        }
    }

    std::vector<float> cosAzimuth;
    std::vector<float> sinAzimuth;
    std::vector<float> cosElevation;
    std::vector<float> sinElevation;
};

/// Where another photo sees the things that a photo's pixels show. Owner: the angles must outlive it.
class SeenByOther {
  public:
    SeenByOther(const Rigid3& otherFromPhoto, const LensPair& own, const LensPair& others,
                const PixelAngles& angles)
        : m_turn(otherFromPhoto.rotation.toRotationMatrix().cast<float>()),
          m_offset(otherFromPhoto.translation.cast<float>()),
          m_ahead(static_cast<float>(own.aheadM) * m_turn.col(0)),
          m_othersAheadM(static_cast<float>(others.aheadM)),
          m_angles(angles) {}

    /// Goes to a row of pixels.
    void enter(int y) {
        const auto row = static_cast<std::size_t>(y);
        m_forward = m_angles.cosElevation[row] * m_turn.col(0);
        m_left = m_angles.cosElevation[row] * m_turn.col(1);
        m_up = m_angles.sinElevation[row] * m_turn.col(2);
    }

    /// From the other photo's lens to what pixel x of the row shows so far away. Frames: the other photo's.
    Eigen::Vector3f at(int x, float inverseM) const {
        const auto column = static_cast<std::size_t>(x);
        const float cosine = m_angles.cosAzimuth[column];
        const Eigen::Vector3f ray = cosine * m_forward + m_angles.sinAzimuth[column] * m_left + m_up;
        const Eigen::Vector3f lens =
            cosine < 0 ? Eigen::Vector3f(m_offset - m_ahead) : Eigen::Vector3f(m_offset + m_ahead);
        Eigen::Vector3f point = ray / inverseM + lens;
        point.x() -= point.x() < 0 ? -m_othersAheadM : m_othersAheadM;
        return point;
    }

    /// How far the photos stand apart.
    float apartM() const { return m_offset.norm(); }

  private:
    Eigen::Matrix3f m_turn;
    Eigen::Vector3f m_offset;
    Eigen::Vector3f m_ahead;
    float m_othersAheadM;
    const PixelAngles& m_angles;
    Eigen::Vector3f m_forward;
    Eigen::Vector3f m_left;
    Eigen::Vector3f m_up;
};

} // namespace spherewalk::scene
