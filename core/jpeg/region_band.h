// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/byte_source.h"
#include "spherewalk/jpeg/region.h"

#include <string_view>

namespace spherewalk::jpeg {

/// How a picture divides into blocks of MCUs that begin and end with restart intervals.
struct UnitGrid {
    explicit UnitGrid(const RestartIndex& index);

    int mcuColumns;
    int mcuRows;
    int unitColumns; ///< MCUs of a unit, horizontally: the interval, or a whole row
    int unitRows;    ///< 1, or so many that an interval begins at the left edge again
};

/// A rectangle of MCUs that consists of whole units, but at the picture's right and lower edges.
struct McuRect {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;
};

/// SOI to SOS of the picture, with only the segments that decoding needs. Errors: Corrupt, Unsupported if
/// header and index contradict each other.
Bytes decodingHeader(const ByteSource& source, const RestartIndex& index);

/// How many luma samples stand for each chroma sample; true for grey pictures, which have none. Errors:
/// Unsupported where a chroma channel has more than one block in an MCU.
bool colourSampling(ByteView header, int& horizontal, int& vertical, std::string_view source);

/// A JPEG of these MCUs alone: the header with their size, and their intervals with the markers renumbered.
/// Adds to the cost. Errors: Corrupt; those of the source.
Bytes bandJpeg(const ByteSource& source, const RestartIndex& index, const Bytes& header, const McuRect& mcus,
               RegionCost& cost);

} // namespace spherewalk::jpeg
