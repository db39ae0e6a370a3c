// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/jpeg/region.h"

#include <string>

namespace spherewalk::jpeg {

/// Decodes a part of a small JPEG and gives its rows, numbered from the part's top. part: pixels of the
/// reduced picture; those within two pixels of an edge inside the whole picture are not the whole's.
/// Errors: Corrupt; those of the sink.
void scanRows(ByteView jpeg, const std::string& source, const PixelRect& part, int denominator,
              const RowSink& sink);

/// Takes a row of samples: the colour (0 luma, 1 blue, 2 red), the row, and as many samples as its part has.
using SampleSink = std::function<void(int colour, int y, const std::uint8_t* samples)>;

/// The same of the samples as they are stored. part: in pixels, whole chroma samples but at the picture's
/// edges.
void scanSamples(ByteView jpeg, const std::string& source, const PixelRect& part, const SampleSink& sink);

} // namespace spherewalk::jpeg
