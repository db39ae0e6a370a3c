// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/metadata.h"

#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::photo {

/// Reads the Ricoh maker note of an Exif block; nothing if there is none. tiff: the block from its TIFF
/// header on, since the offsets in the note count from there and may lead out of the note. A value that is
/// missing, senseless or outside the bytes is absent. exiv2 does not read this note.
std::optional<ThetaMakerNote> readThetaMakerNote(ByteView tiff);

/// A text of a photo up to its first NUL, trimmed, printable, and cut to 200 bytes.
std::string plainText(std::string_view foreign);

} // namespace spherewalk::photo
