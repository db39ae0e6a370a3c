// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"

#include <optional>
#include <string_view>

namespace spherewalk::align {

/// The features as a file: magic, key, counts, the vectors (little endian), and the SHA-256 of all that.
Bytes toBytes(const Features& features, std::string_view key);

/// Nothing for bytes that toBytes() did not make for this key, or that hold what features cannot be.
std::optional<Features> fromBytes(ByteView bytes, std::string_view key);

} // namespace spherewalk::align
