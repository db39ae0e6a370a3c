// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/render/sensor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// The parts of a sensor. All of them compute with integers, or with IEEE addition, multiplication, division
/// and square root in a fixed order, so that bytes are the same anywhere.
namespace spherewalk::render {

constexpr std::uint16_t kWhiteLight = 65535;
/// Linear light; kWhiteLight is white.
using LightImage = Image<std::uint16_t, 3>;

/// When the rows of one frame are exposed, and what its views give to each row. Between the views, the
/// picture is taken to change evenly.
class RowTiming {
  public:
    static constexpr std::uint32_t kOne = 65536; ///< What the shares of a row sum up to.

    /// stepS: the time between views; above 0, but for an instant (no exposure, no line delay).
    RowTiming(int rows, double timeS, double exposureS, double lineDelayS, double stepS);

    const std::vector<double>& times() const { return m_times; }

    /// The index of the view at the frame's time.
    std::size_t main() const { return m_main; }

    /// The share of this view in this row, of kOne.
    std::uint32_t share(int row, std::size_t view) const {
        return m_shares[static_cast<std::size_t>(row) * m_times.size() + view];
    }

  private:
    std::vector<double> m_times;
    std::size_t m_main = 0;
    std::vector<std::uint32_t> m_shares;
};

/// The steps of the views of a frame, see ShutterModel::mostViews: {time between them, stepPx}. Range: not
/// for an instant.
std::pair<double, double> viewStep(const Sensor::PoseAt& poseAt, const CameraIntrinsics& camera, double timeS,
                                   double exposureS, const ShutterModel& shutter);

/// Standard normal numbers, one for each counter of a sequence. Threads: any.
/// Source: SplitMix64 (Steele, Lea, Flood, 2014); the quantiles are interpolated in a table.
class NormalNoise {
  public:
    /// Three numbers for each pixel.
    using Three = std::array<float, 3>;

    /// The sequence of a frame. purpose: sequences of one frame differ by it.
    NormalNoise(std::uint64_t seed, std::uint64_t frame, std::uint64_t purpose);

    Three at(std::uint64_t pixel) const {
        const std::uint64_t bits = mixed(m_key + (pixel + 1) * kGamma);
        return {normal(bits), normal(bits >> kBits), normal(bits >> (2 * kBits))};
    }

  private:
    static constexpr std::uint64_t kGamma = 0x9E3779B97F4A7C15ULL;
    static constexpr int kBits = 21; ///< For each number: its sign, a cell of the table, a place in the cell.
    static constexpr int kPlaceBits = 9;
    static constexpr int kCells = 1 << (kBits - kPlaceBits - 1);

    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    float normal(std::uint64_t bits) const {
        const auto cell = static_cast<std::size_t>((bits >> kPlaceBits) & (kCells - 1));
        const auto place = static_cast<float>(bits & ((1U << kPlaceBits) - 1)) + 0.5F;
        const float value = (*m_quantiles)[cell] + place * (1.0F / (1U << kPlaceBits)) *
                                                       ((*m_quantiles)[cell + 1] - (*m_quantiles)[cell]);
        return (bits >> (kBits - 1) & 1U) != 0 ? -value : value;
    }

    using Quantiles = std::array<float, kCells + 1>;
    static Quantiles makeQuantiles();

    std::uint64_t m_key;
    const Quantiles* m_quantiles; ///< Of the magnitude, at evenly spread probabilities.
};

/// Replaces each point of light by a disc. depth: decides the discs' diameters where DefocusModel::apertureMm
/// is not 0; a depth that is not finite and above 0 counts as endlessly far. Errors: InvalidInput without it.
class Defocus {
  public:
    Defocus(const DefocusModel& model, double focalPx) : m_model(model), m_focalPx(focalPx) {}

    bool isOn() const { return m_model != DefocusModel(); }

    void apply(LightImage& light, const DepthImage& depth, WorkerPool& pool, int threads) const;

  private:
    MaskImage classes(const LightImage& light, const DepthImage& depth) const;

    DefocusModel m_model;
    double m_focalPx;
};

/// The least and the most exposure in steps of 1/16 stop, from the reference time and a gain of 0 dB.
class ExposureControl {
  public:
    explicit ExposureControl(const ExposureModel& model);

    double timeS() const;
    double gainDb() const;
    /// The light of a picture, of that of the photos.
    double timeFactor() const;
    double gainFactor() const;

    /// Sets the exposure for a mean light of the present one. Returns whether it has changed.
    bool follow(double meanLight, double response);

  private:
    ExposureModel m_model;
    double m_referenceS;
    int m_timeSteps = 0;
    int m_gainSteps = 0;
};

} // namespace spherewalk::render
