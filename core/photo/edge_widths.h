// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/photo/sketch.h"

namespace spherewalk::photo {

/// Of a spherical picture between 40 degrees below and above the horizon, where its rows are hardly
/// stretched.
EdgeWidths edgeWidths(const RgbImage& picture);

} // namespace spherewalk::photo
