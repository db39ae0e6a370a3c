// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"

namespace spherewalk::bench {

/// A made-up panorama of 5376 x 2688 pixels with details of every size, down to a pixel: soft clouds, tiles
/// with joints, and noise. The same on every machine but for the last bits of sines.
RgbImage detailedPanorama();

} // namespace spherewalk::bench
