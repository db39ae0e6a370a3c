// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// The same picture with a restart marker after every `mcusPerInterval` MCUs, so that any part can be decoded
/// by itself. The DCT coefficients, and so every decoded pixel, stay as they are; all APPn and COM segments
/// stay, byte for byte and in order, and none is added. A progressive picture becomes a baseline one; bytes
/// behind the picture's end are dropped. Range: 1 to 65535 MCUs. Errors: Corrupt, Unsupported, InvalidInput.
Bytes withRestartMarkers(ByteView jpeg, int mcusPerInterval, std::string_view source);

/// Where each restart interval of a baseline JPEG begins, so that nothing has to be scanned when a part is
/// wanted.
struct RestartIndex {
    int width = 0;
    int height = 0;
    int mcuWidth = 0;
    int mcuHeight = 0;
    int mcusPerInterval = 0;
    std::uint64_t fileSizeBytes = 0;
    /// Of the first entropy-coded byte of interval i, from the file's start.
    std::vector<std::uint32_t> offsets;

    bool operator==(const RestartIndex&) const = default;
};

/// Errors: Corrupt if markers are missing or out of order; Unsupported for progressive, multi-scan, or
/// unmarked pictures.
RestartIndex indexRestarts(ByteView jpeg, std::string_view source);

/// The index as a file (format: resources/docs/formats.md, "Restart index") and back. Errors of reading:
/// Corrupt, for anything but a whole, consistent, ascending index; of writing: InvalidInput for such a one.
Bytes serialised(const RestartIndex& index);
RestartIndex parseRestartIndex(ByteView bytes, std::string_view source);

} // namespace spherewalk::jpeg
