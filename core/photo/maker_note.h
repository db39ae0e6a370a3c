// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/metadata.h"

#include <optional>

namespace spherewalk::photo {

/// The Ricoh maker note in an Exif block (from its TIFF header on: the note's offsets count from there, and
/// may lead out of the note). exiv2 leaves it as it is. Nothing if there is none; a value that is missing,
/// out of the bytes or senseless is absent.
std::optional<ThetaMakerNote> readThetaMakerNote(ByteView tiff);

} // namespace spherewalk::photo
