// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <chrono>
#include <string>

namespace spherewalk::practice {

/// The metadata that a Theta V writes into a still picture. Angles have the file's signs: pitch > 0 looks up,
/// and a growing roll turns the horizon counter-clockwise in the picture.
struct ThetaTags {
    enum class ByteOrder { Big, Little };

    std::string model = "RICOH THETA V";
    std::string firmware = "3.82.1";
    std::string serial = "YL00123456";
    std::chrono::system_clock::time_point time; ///< Time of the shot, UTC.
    std::chrono::minutes timeZone{0};           ///< East of UTC.
    double exposureTimeS = 1.0 / 60;
    int isoSpeed = 200;
    int exposureProgram = 2;
    double exposureBias = 0;
    bool hasFixedWhiteBalance = false;
    bool levelled = false; ///< The zenith correction was applied to the pixels.
    double posePitchDeg = 0;
    double poseRollDeg = 0;
    double inclinationRollDeg = 0; ///< Of the camera's body at the shot, with or without the correction.
    double inclinationPitchDeg = 0;

    // Variants that readers must cope with.
    ByteOrder byteOrder = ByteOrder::Big;
    bool thetaIfdInsideMakerNote = true;
    bool withMakerNote = true;
    bool withHostileMakerNote = false; ///< The maker note's offsets lead out of the file.
    bool withXmp = true;
};

/// The file that a Theta V would store: baseline JPEG (4:2:0) with Exif, Ricoh's maker note with its Theta
/// directory, a thumbnail, and GPano XMP in element form. Errors: InvalidInput for a picture that is not
/// twice as wide as high, or empty. Source: CIPA DC-008 (Exif), TIFF 6.0, Google's GPano.
Bytes thetaJpeg(const RgbImage& picture, const ThetaTags& tags, int quality = 92);

} // namespace spherewalk::practice
