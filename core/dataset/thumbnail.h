// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <string_view>

namespace spherewalk::dataset {

/// The equirectangular picture as a JPEG of this width (or its own, if that is less), each pixel the mean of
/// the area that it covers.
Bytes thumbnail(ByteView jpeg, std::string_view source, int width);

} // namespace spherewalk::dataset
