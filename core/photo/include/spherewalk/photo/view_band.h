// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <optional>
#include <string_view>

namespace spherewalk::photo {

/// The brightness of a photo between 30 degrees above and below its middle row, at about 640 pixels around:
/// fine enough to tell whether the camera has moved by a step.
using ViewBand = Image<std::uint8_t, 1>;

/// source: the photo's name, for sentences. Errors: those of jpeg::decode(). Threads: any. Cost: about 30 ms
/// for 5376 x 2688 pixels.
ViewBand viewBand(ByteView jpeg, std::string_view source);

/// Whether two photos show the same, turned alike and from one place: nothing that has texture lies more than
/// an eighth of a degree aside. A quarter of it may have changed, as a person who hides elsewhere does. Light
/// does not count. Nothing if too little has texture, or the sizes differ.
std::optional<bool> isSameView(const ViewBand& a, const ViewBand& b);

} // namespace spherewalk::photo
