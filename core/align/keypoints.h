// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "resample.h"

#include "spherewalk/align/features.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace spherewalk::align {

/// A spot of a picture that can be found again.
struct Keypoint {
    double x = 0; ///< true position: pixel centres are integers
    double y = 0;
    float sizePx = 0; ///< diameter of what it stands for
    float response = 0;
    float angleDeg = 0; ///< of its strongest gradient, from +x to +y
    float rawX = 0;     ///< position as the detector itself counts, which its descriptor starts from
    float rawY = 0;
    float rawSizePx = 0;
    int octave = 0; ///< the detector's own mark of the scale
    int level = 0;
};

/// One of OpenCV's detectors, with its shifts of position taken out. Errors: Internal for what OpenCV throws.
/// Threads: one at a time.
class KeypointDetector {
  public:
    explicit KeypointDetector(const FeatureOptions& options);
    ~KeypointDetector();

    int descriptorBytes() const;
    /// In an order that depends on nothing but the picture.
    std::vector<Keypoint> find(const GreyImage& picture) const;
    /// One after the other, descriptorBytes() each; zeros for one that the detector refuses to describe.
    std::vector<std::uint8_t> describe(const GreyImage& picture,
                                       const std::vector<Keypoint>& keypoints) const;
    /// How far a keypoint's position is off along x or y, in pixels, for what its size leaves open. Measured
    /// on pictures with known poses.
    double sigmaPx(const Keypoint& keypoint) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::align
