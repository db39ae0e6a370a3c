// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/jpeg/restart.h"

#include <cstddef>

namespace spherewalk::jpeg {

/// True if the sizes (not the offsets) are ones that a JPEG can have.
bool isPlausible(const RestartIndex& index);

/// How many restart intervals a picture of these sizes has. Range: isPlausible().
std::size_t intervalCount(const RestartIndex& index);

/// True if the offsets ascend within the file, far enough apart to hold an interval and its marker each.
bool areOffsetsPlausible(const RestartIndex& index);

} // namespace spherewalk::jpeg
