// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <cstdint>
#include <vector>

namespace spherewalk::align {

using GreyImage = Image<std::uint8_t, 1>;

/// Luma of Rec. 601.
GreyImage grey(const RgbImage& picture);

/// Where a row or column of the result lies in the source, and how many source pixels it stands for.
struct SourcePlace {
    double position = 0; ///< pixel centres are integers
    double extent = 1;   ///< below 1 where the result is finer than the source
};

/// The picture whose rows and columns lie at the given places of the source. Columns wrap around, rows stop
/// at the source's edge. Filter: Catmull-Rom, widened to the extent where it is above 1.
GreyImage resampled(const GreyImage& source, const std::vector<SourcePlace>& columns,
                    const std::vector<SourcePlace>& rows);

} // namespace spherewalk::align
