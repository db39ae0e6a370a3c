// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <cstdint>
#include <ostream>
#include <vector>

namespace spherewalk::test {

/// How a JPEG is made, for pictures that the product itself never writes.
struct JpegForm {
    const char* name = "4:2:0";
    bool isGrey = false;
    int horizontal = 2; ///< luma samples for each chroma sample
    int vertical = 2;
    bool isProgressive = false;
    bool hasScanPerColour = false;
    bool hasHundredsOfScans = false; ///< legal: each bit of each coefficient by itself; grey only
    bool hasJfif = true;
    int restartInterval = 0;
    std::vector<Bytes> applications = {}; ///< contents of APP1 segments, written behind JFIF
    int quality = 90;
};

std::ostream& operator<<(std::ostream& out, const JpegForm& form);

Bytes madeJpeg(const RgbImage& picture, const JpegForm& form);

/// Smooth shapes with noise: every coefficient and every chroma sample matters.
RgbImage madePicture(int width, int height, unsigned seed = 1);

} // namespace spherewalk::test
