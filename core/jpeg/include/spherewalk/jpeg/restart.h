// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// The same picture with a restart marker after every `mcusPerInterval` MCUs, so that any part can be decoded
/// by itself. The DCT coefficients stay, and with them every decoded pixel. All APPn and COM segments stay in
/// their order, and none is added. A progressive picture becomes a baseline one. Bytes behind the picture's
/// end are dropped. Range: 1 to 65535 MCUs. Errors: Corrupt, Unsupported, InvalidInput.
Bytes withRestartMarkers(ByteView jpeg, int mcusPerInterval, std::string_view source);

/// Tells where each restart interval of a baseline JPEG begins, so that a part is found without a scan.
struct RestartIndex {
    int width = 0;
    int height = 0;
    int mcuWidth = 0;
    int mcuHeight = 0;
    int mcusPerInterval = 0;
    std::uint64_t fileSizeBytes = 0;
    /// Offset i is that of the first entropy-coded byte of interval i, from the file's start.
    std::vector<std::uint32_t> offsets;

    bool operator==(const RestartIndex&) const = default;
};

/// The index of a JPEG with restart markers. Errors: Corrupt if markers are missing or out of order;
/// Unsupported for progressive, multi-scan, or unmarked pictures.
RestartIndex indexRestarts(ByteView jpeg, std::string_view source);

/// The index as the bytes of a file, in the format "Restart index" of resources/docs/formats.md.
/// Errors: InvalidInput for an index that contradicts itself.
Bytes serialised(const RestartIndex& index);

/// The index of such bytes. Errors: Corrupt for anything but a complete, consistent, ascending index.
RestartIndex parseRestartIndex(ByteView bytes, std::string_view source);

} // namespace spherewalk::jpeg
