// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/render/pixel_rays.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace spherewalk::render {

/// A change of a photo's colours into those of a robot's camera. Stored values are taken for sRGB and made
/// linear. A matrix mixes the channels, as two sensors see the same light differently. Each channel is made
/// sRGB again. A curve of each channel then stands for how the camera develops its pictures.
/// Source: IEC 61966-2-1 (sRGB).
struct ColourCorrection {
    static constexpr int kKnots = 17;
    static constexpr double kMostMatrix = 8; ///< No entry of the matrix may have a larger magnitude.
    /// Values at evenly spread knots from 0 to 1. The curve is straight between them.
    using Curve = std::array<double, kKnots>;

    /// The curve that changes nothing.
    static constexpr Curve straight() {
        Curve curve{};
        for (int i = 0; i < kKnots; ++i) {
            curve[static_cast<std::size_t>(i)] = i / (kKnots - 1.0);
        }
        return curve;
    }

    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    /// The curves of red, green and blue. They never fall, and their values are cut to [0, 1].
    std::array<Curve, 3> curves{straight(), straight(), straight()};

    bool operator==(const ColourCorrection&) const = default;

    /// Errors: InvalidInput for values that are not finite, entries of the matrix beyond kMostMatrix, and
    /// curves that fall or leave [-1, 2].
    void validate() const;

    /// The corrected colour. Both colours are red, green and blue in [0, 1], as pictures store them.
    Eigen::Vector3d corrected(const Eigen::Vector3d& stored) const;
};

/// The light of a value that sRGB stores in [0, 1]. Below 0 the curve goes on straight.
double linearLight(double stored);

/// The value in [0, 1] that sRGB stores for this light. It undoes linearLight().
double storedValue(double linear);

/// What a camera would store in place of a value at another exposure, which multiplies dark values by `gain`.
/// Values follow a power of the light, v = 255 L, only where they are dark. Brighter ones end softly at
/// white: v = 255 L / (1 + L^p)^(1/p), p = 1 / rolloff. With a roll-off of 0 they are cut there. White stays
/// white, as nobody knows how much light it was. Range: value from 0 to 255, gain above 0, rolloff from 0 to
/// 0.5. Errors: rounding; gains g and 1/g undo each other. Source: generalised from Reinhard 2002.
double exposedValue(double value, double gain, double rolloff);

/// exposedValue() of the values 0 to 255, rounded.
std::array<std::uint8_t, 256> exposedValues(double gain, double rolloff);

/// Gives a picture another exposure, in its own memory. gains: of red, green and blue.
void expose(RgbImage& picture, const Eigen::Vector3d& gains, double rolloff);

/// The correction as dataset.json holds it.
Json toJson(const ColourCorrection& correction);

/// The correction that toJson() wrote. Errors: Corrupt, with the member's path.
ColourCorrection parseColourCorrection(const JsonReader& reader);

/// A correction made ready for many pixels by integer arithmetic and tables. The result is within two grey
/// levels of ColourCorrection::corrected(), even where a curve is steep. A correction that corrects nothing
/// changes no pixel. Threads: const functions may run on any number at a time.
class ColourTables {
  public:
    /// Errors: as ColourCorrection::validate().
    explicit ColourTables(const ColourCorrection& correction);

    /// Corrects the picture in its own memory. rays: those of the picture's camera; pixels that the lens does
    /// not see stay black. threads: the most to use, 0 for all; the bytes are the same for any number.
    void apply(RgbImage& picture, const PixelRays& rays, WorkerPool& pool, int threads = 0) const;

  private:
    static constexpr int kLightBits = 14;
    static constexpr int kMatrixBits = 12;
    static constexpr int kEntryBits = 13; ///< The tables of developed values have so many bits of index.
    /// What one channel's value gives to red, green and blue, in fixed point. The fourth fills a register.
    using Share = std::array<std::int32_t, 4>;

    std::array<std::array<Share, 256>, 3> m_shares{};
    std::array<std::array<std::uint8_t, 1 << kEntryBits>, 3> m_developed{};
};

} // namespace spherewalk::render
