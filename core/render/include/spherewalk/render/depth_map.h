// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <string_view>

namespace spherewalk::render {

/// How far away each pixel of a photo is, in the photo's own frame, mostly at fewer pixels than the photo
/// has. Frames: equirectangular, see geometry/equirect.h. Threads: const, any number.
class DepthMap {
  public:
    /// Inverse distances are whole multiples of this, per metre; the greatest is kSteps of them: 4.9 cm.
    static constexpr double kStepPerM = 1.0 / 1600;
    static constexpr int kSteps = 32767;

    /// inverseM: 1 / distance along the pixel's ray, rounded to steps, at least one (1600 m) and at most
    /// kSteps. sure: not 0 where the depth was measured rather than filled in; empty: everywhere. Errors:
    /// InvalidInput if a size is not twice as wide as high, 16 to 8192 wide, the sizes differ, or a value is
    /// not a number.
    explicit DepthMap(Image<float, 1> inverseM, MaskImage sure = {});

    /// What serialised() gave. source: for sentences. Errors: Corrupt.
    static DepthMap parse(ByteView bytes, std::string_view source);

    /// A binary PGM of 16 bits: twice the number of steps, plus 1 where the depth is sure.
    Bytes serialised() const;

    int width() const { return m_inverseM.width(); }

    int height() const { return m_inverseM.height(); }

    const Image<float, 1>& inverseM() const { return m_inverseM; }

    const MaskImage& sure() const { return m_sure; }

  private:
    Image<float, 1> m_inverseM;
    MaskImage m_sure;
};

} // namespace spherewalk::render
