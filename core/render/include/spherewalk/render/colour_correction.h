// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/render/pixel_rays.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace spherewalk::render {

/// What makes a photo's colours those of a robot's camera: the stored values are taken for sRGB and made
/// linear; the matrix mixes the channels, as two sensors see the same light differently; each channel is
/// made sRGB again; and a curve of each channel stands for how the robot's camera develops its pictures.
/// Source: IEC 61966-2-1 (sRGB).
struct ColourCorrection {
    static constexpr int kKnots = 17;
    static constexpr double kMostMatrix = 8; ///< of an entry's size
    /// Values at evenly spread places from 0 to 1, straight between them.
    using Curve = std::array<double, kKnots>;

    static constexpr Curve straight() {
        Curve curve{};
        for (int i = 0; i < kKnots; ++i) {
            curve[static_cast<std::size_t>(i)] = i / (kKnots - 1.0);
        }
        return curve;
    }

    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    std::array<Curve, 3> curves{straight(), straight(), straight()}; ///< never falling; cut to [0, 1]

    bool operator==(const ColourCorrection&) const = default;

    /// Errors: InvalidInput with a sentence for values that are not finite, entries of the matrix beyond
    /// kMostMatrix, and curves that fall or leave [-1, 2].
    void validate() const;

    /// Of a colour in [0, 1] as pictures store it, in the same way. Frames: red, green, blue.
    Eigen::Vector3d corrected(const Eigen::Vector3d& stored) const;
};

/// Light, of a value in [0, 1] as sRGB stores it, and back. Range: any; below 0 both go on straight.
double linearLight(double stored);
double storedValue(double linear);

/// As dataset.json has it.
Json toJson(const ColourCorrection& correction);

/// Errors: Corrupt, naming the place.
ColourCorrection parseColourCorrection(const JsonReader& reader);

/// A correction made ready for many pixels: integer arithmetic and tables, within two grey levels of
/// ColourCorrection::corrected() even where a curve is steep; one that corrects nothing changes no pixel.
/// Threads: const, any number.
class ColourTables {
  public:
    /// Errors: those of ColourCorrection::validate().
    explicit ColourTables(const ColourCorrection& correction);

    /// Corrects the picture in its place; the bytes are the same for any number of threads. rays: of its
    /// camera; what the lens does not see stays black.
    void apply(RgbImage& picture, const PixelRays& rays, WorkerPool& pool, int threads = 0) const;

  private:
    static constexpr int kLightBits = 14;
    static constexpr int kMatrixBits = 12;
    static constexpr int kPlaceBits = 13; ///< of what comes out of the matrix
    /// What one channel's value gives to red, green and blue, in fixed point; the fourth fills a register.
    using Share = std::array<std::int32_t, 4>;

    std::array<std::array<Share, 256>, 3> m_shares{};
    std::array<std::array<std::uint8_t, 1 << kPlaceBits>, 3> m_developed{};
};

} // namespace spherewalk::render
