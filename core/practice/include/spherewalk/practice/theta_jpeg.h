// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <chrono>
#include <string>

namespace spherewalk::practice {

/// What a Theta V writes into a still picture besides its pixels. Angles as the file has them: pitch > 0
/// looks up, growing roll turns the horizon counter-clockwise in the picture.
struct ThetaTags {
    enum class ByteOrder { Big, Little };

    std::string model = "RICOH THETA V";
    std::string firmware = "3.82.1";
    std::string serial = "YL00123456";
    std::chrono::system_clock::time_point time; ///< UTC
    std::chrono::minutes timeZone{0};           ///< east of UTC
    double exposureTimeS = 1.0 / 60;
    int isoSpeed = 200;
    int exposureProgram = 2;
    double exposureBias = 0;
    bool hasFixedWhiteBalance = false;
    bool levelled = false; ///< the zenith correction has been applied to the pixels
    double posePitchDeg = 0;
    double poseRollDeg = 0;
    double inclinationRollDeg = 0; ///< of the body at the shot, whether corrected or not
    double inclinationPitchDeg = 0;

    // Variants that readers have to cope with.
    ByteOrder byteOrder = ByteOrder::Big;
    bool thetaIfdInsideMakerNote = true;
    bool withMakerNote = true;
    bool withHostileMakerNote = false; ///< whose offsets lead out of the file
    bool withXmp = true;
};

/// The picture as a Theta V would store it: Exif with the Ricoh maker note, its Theta directory and a
/// thumbnail; GPano XMP in element form; baseline JPEG, 4:2:0. Errors: InvalidInput for a picture that is not
/// twice as wide as high, or empty. Source: CIPA DC-008 (Exif), TIFF 6.0, Google's GPano.
Bytes thetaJpeg(const RgbImage& picture, const ThetaTags& tags, int quality = 92);

} // namespace spherewalk::practice
