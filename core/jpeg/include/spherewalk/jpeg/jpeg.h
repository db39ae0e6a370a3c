// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <string_view>

namespace spherewalk::jpeg {

/// What the headers of a JPEG say.
struct Info {
    int width = 0;
    int height = 0;
    int components = 0;
    int mcuWidth = 0; ///< pixels of one minimum coded unit, 16 for 4:2:0
    int mcuHeight = 0;
    int restartInterval = 0; ///< MCUs between restart markers, 0 for none
    bool progressive = false;
};

/// source: what the bytes are, for sentences (a file's name). Errors: Corrupt; Unsupported for more than 2^28
/// pixels, CMYK, or arithmetic coding.
Info readInfo(ByteView jpeg, std::string_view source);

/// All pixels, by libjpeg's accurate integer IDCT and fancy upsampling, so that every decoder of ours gives
/// the same bytes. denominator: 1, 2, 4 or 8, the picture is reduced by it while decoding. Greyscale is
/// expanded to RGB. Errors: Corrupt for anything that libjpeg does more than accept silently: a truncated
/// file is an error, not a grey area; Unsupported as readInfo. Threads: any, also at a time. Cost: about 5
/// ns a pixel on one core.
RgbImage decode(ByteView jpeg, std::string_view source, int denominator = 1);

/// Baseline, 4:2:0, standard Huffman tables optimised. Range: quality 1 to 100. Errors: InvalidInput.
Bytes encode(const RgbImage& picture, int quality);

} // namespace spherewalk::jpeg
