// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/region.h"
#include "spherewalk/jpeg/restart.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// True if a JPEG can have the sizes of the index. The offsets are not looked at.
bool isPlausible(const RestartIndex& index);

/// The number of restart intervals of a picture with these sizes. Range: isPlausible().
std::size_t intervalCount(const RestartIndex& index);

/// True if the offsets ascend within the file, and each interval has room for its data and its marker.
bool areOffsetsPlausible(const RestartIndex& index);

/// The index that the header describes, without offsets. `jpeg` begins at the file's start and holds all of
/// the header. Errors: Corrupt; Unsupported for progressive, multi-scan, or unmarked pictures.
RestartIndex readRestartLayout(ByteView jpeg, std::string_view source, const std::vector<Segment>& header);

/// Divides a picture into units: blocks of MCUs that begin and end with restart intervals.
struct UnitGrid {
    explicit UnitGrid(const RestartIndex& index);

    int mcuColumns;
    int mcuRows;
    int unitColumns; ///< MCUs of a unit from left to right: an interval, or a whole row.
    int unitRows;    ///< MCU rows of a unit: after them an interval begins at the left edge again.
};

/// A rectangle of MCUs. It consists of whole units, except at the picture's right and lower edges.
struct McuRect {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;
};

/// The picture's header, SOI to SOS, with only the segments that decoding needs. Errors: Corrupt or
/// Unsupported if header and index contradict each other.
Bytes decodingHeader(const ByteSource& source, const RestartIndex& index);

/// Finds how many luma samples share a chroma sample. The result is true for a grey picture, which has no
/// chroma. Errors: Unsupported where a chroma channel has more than one block in an MCU.
bool colourSampling(ByteView header, int& horizontal, int& vertical, std::string_view source);

/// A JPEG of these MCUs alone: the header with their size, and their intervals with renumbered markers. The
/// function adds to the cost. Errors: Corrupt; those of the source.
Bytes bandJpeg(const ByteSource& source, const RestartIndex& index, const Bytes& header, const McuRect& mcus,
               RegionCost& cost);

} // namespace spherewalk::jpeg
