// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "features/sphere_view.h"

#include "spherewalk/align/features.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace cv {
class Mat;
}

namespace spherewalk::align {

/// The picture's pixels as OpenCV's matrix, without a copy.
cv::Mat matrixOf(const GreyImage& picture);

/// A spot of a picture that can be found again in another picture.
struct Keypoint {
    double x = 0; ///< True position; pixel centres are integers.
    double y = 0;
    float sizePx = 0; ///< Diameter of the spot.
    float response = 0;
    float angleDeg = 0; ///< Direction of the strongest gradient, from +x to +y.
    int octave = 0;     ///< The detector's own mark of the scale.
    int row = 0;        ///< Of the descriptor.
};

struct DescribedKeypoints {
    std::vector<Keypoint> keypoints;       ///< In an order that depends on the picture alone.
    std::vector<std::uint8_t> descriptors; ///< In rows of as many bytes as the detector's have.

    const std::uint8_t* descriptor(int row, int bytes) const {
        return descriptors.data() + static_cast<std::ptrdiff_t>(row) * bytes;
    }
};

/// One of OpenCV's detectors, freed of its systematic shifts of position. Errors: Internal for what OpenCV
/// throws. Threads: one at a time.
class KeypointDetector {
  public:
    explicit KeypointDetector(const FeatureOptions& options);
    ~KeypointDetector();

    int descriptorBytes() const;
    /// All are described, since the picture's scales, which take longest, are then made once.
    DescribedKeypoints find(const GreyImage& picture) const;
    /// Standard deviation of a keypoint's position along x or y, in pixels, by its size. Source: measured on
    /// pictures with known poses.
    double sigmaPx(const Keypoint& keypoint) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// A place on the sphere with the strength of what was found there.
struct Spot {
    Eigen::Vector3d bearing = Eigen::Vector3d::UnitX();
    float response = 0;
    double ownRad = 0; ///< Weaker spots within this angle are not selected.
};

/// Indices of at most `most` spots, spread evenly: first the strongest of each region of the sphere (some 10
/// degrees wide), then the second of each, and so on. Within a round the strongest spot comes first.
std::vector<int> evenSelection(const std::vector<Spot>& spots, int most);

/// For each bearing the index of the first one within reach that stands for no other; its own if there is
/// none.
std::vector<int> firstNear(const std::vector<Eigen::Vector3f>& bearings, double reachRad);

} // namespace spherewalk::align
