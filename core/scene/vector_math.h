// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

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

/// std::atan2() in single precision, off by less than 3e-6, which is 0.004 pixels of a picture of 8192; 0 for
/// the origin. Compilers can do several at a time, and the result is the same on every machine. The
/// polynomial has the least greatest error of those with five terms in place of the arctangent's series.
inline float fastAngle(float y, float x) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float across = std::fabs(x);
    const float up = std::fabs(y);
    const float most = across > up ? across : up;
    const float least = across > up ? up : across;
    const float t = least / (most + 1e-30F);
    const float s = t * t;
    float sum = -0.012808398F;
    sum = sum * s + 0.055806223F;
    sum = sum * s - 0.119818933F;
    sum = sum * s + 0.195182890F;
    sum = sum * s - 0.332965970F;
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

/// Where a neighbour's lenses stand. Frames: the photo's.
struct NeighbourLenses {
    Eigen::Vector3f fromFrontM; ///< From the photo's front lens to the neighbour's middle.
    Eigen::Vector3f fromBackM;  ///< From the photo's back lens.
    Eigen::Vector3f ahead;      ///< The unit vector along which the neighbour's front lens looks.
    float aheadM = 0;           ///< How far the neighbour's lenses stand before and behind its middle.
    float apartM = 0;           ///< From the photo's middle to the neighbour's.
};

/// NeighbourLenses as numbers, which no store can change.
struct LensNumbers {
    struct Sight {
        float x, y, z;
    };

    explicit LensNumbers(const NeighbourLenses& l)
        : front{l.fromFrontM[0], l.fromFrontM[1], l.fromFrontM[2]},
          back{l.fromBackM[0], l.fromBackM[1], l.fromBackM[2]},
          ahead{l.ahead[0], l.ahead[1], l.ahead[2]},
          aheadM(l.aheadM) {}

    /// Whether each photo's two lenses stand in one place.
    bool areOne() const { return aheadM == 0 && front.x == back.x && front.y == back.y && front.z == back.z; }

    /// From the neighbour's lens to what the photo's ray (x, y, z) shows, not normalised.
    template <bool kAreOne>
    Sight sight(float x, float y, float z, float inverse) const {
        const float dx = x - inverse * (!kAreOne && x < 0 ? back.x : front.x);
        const float dy = y - inverse * (!kAreOne && x < 0 ? back.y : front.y);
        const float dz = z - inverse * (!kAreOne && x < 0 ? back.z : front.z);
        if constexpr (kAreOne) {
            return {dx, dy, dz};
        }
        const float along = dx * ahead.x + dy * ahead.y + dz * ahead.z;
        const float moved = inverse * (along < 0 ? -aheadM : aheadM);
        return {dx - moved * ahead.x, dy - moved * ahead.y, dz - moved * ahead.z};
    }

    Sight front;
    Sight back;
    Sight ahead;
    float aheadM;
};

} // namespace spherewalk::scene
