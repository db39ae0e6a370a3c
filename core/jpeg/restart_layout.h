// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/jpeg/restart.h"
#include "spherewalk/jpeg/segments.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// True if the sizes (not the offsets) are ones that a JPEG can have.
bool isPlausible(const RestartIndex& index);

/// How many restart intervals a picture of these sizes has. Range: isPlausible().
std::size_t intervalCount(const RestartIndex& index);

/// True if the offsets ascend within the file, far enough apart to hold an interval and its marker each.
bool areOffsetsPlausible(const RestartIndex& index);

/// What the header says of the layout: all of the index but its offsets. jpeg: from the file's start, as far
/// as the header's segments reach. Errors: Corrupt; Unsupported for progressive, multi-scan, or unmarked
/// pictures.
RestartIndex readRestartLayout(ByteView jpeg, std::string_view source, const std::vector<Segment>& header);

} // namespace spherewalk::jpeg
