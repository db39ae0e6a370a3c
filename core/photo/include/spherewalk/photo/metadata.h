// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::photo {

/// What the XMP of a panorama says about its projection and pose.
/// Source: Google, Photo Sphere XMP Metadata, namespace GPano.
struct PanoramaXmp {
    std::string projection; ///< "equirectangular" for a sphere; "" if the photo does not say it.
    /// Compass direction of the picture's centre, clockwise from north. Range: [0, 360).
    std::optional<Degrees> heading;
    /// Elevation of the picture's centre above the horizon. The sign is opposite to YawPitchRoll::pitch.
    std::optional<Degrees> pitch;
    /// How far the camera leaned to its right. The sign is that of YawPitchRoll::roll.
    std::optional<Degrees> roll;
    std::optional<int> fullWidth;
    std::optional<int> fullHeight;
    std::optional<int> croppedWidth;
    std::optional<int> croppedHeight;

    bool operator==(const PanoramaXmp&) const = default;
};

/// What a Ricoh Theta writes into its maker note. Every part may be missing. The comments name the tags.
/// Source: Ricoh theta-api-specs, "theta-metadata".
struct ThetaMakerNote {
    std::string firmware; ///< Tag 0x0002.
    std::string serial;   ///< Tag 0x0005.
    std::optional<int>
        imageType; ///< Tag 0x0001 of the Theta directory: 1 is equirectangular, 2 dual fisheye.
    std::optional<Degrees> inclinationRoll;   ///< Tag 0x0003, in (-180, 180].
    std::optional<Degrees> inclinationPitch;  ///< Tag 0x0003, in (-180, 180].
    std::optional<Degrees> compass;           ///< Tag 0x0004, which means nothing without calibration.
    std::optional<bool> isLevelled;           ///< Tag 0x0007: the camera has turned the picture upright.
    std::string timeZone;                     ///< Tag 0x000A, "+hh:mm" or "-hh:mm"; "" for anything else.
    std::optional<Eigen::Vector3d> zenith;    ///< Tag 0x0109, a rotation vector as the camera wrote it.
    std::optional<double> frontSensorCelsius; ///< Tag 0x1001.
    std::optional<double> rearSensorCelsius;  ///< Tag 0x1003.

    bool operator==(const ThetaMakerNote&) const = default;
};

/// What a photo says about itself. Texts are trimmed and printable; a missing text is empty.
struct PhotoMetadata {
    int width = 0;
    int height = 0;
    std::string make;
    std::string model;
    std::string software;
    std::string takenAt;  ///< Local time of the camera, "2026-01-02T03:04:05".
    std::string timeZone; ///< Zone of takenAt from the maker note, "+hh:mm".
    std::optional<double> exposureS;
    std::optional<double> fNumber;
    std::optional<int> iso;
    /// How programs are to turn the picture, 1 to 8; nobody turns a sphere. Source: Exif, tag Orientation.
    int orientation = 1;
    std::optional<bool> hasFixedWhiteBalance; ///< Whether a person chose the white balance.
    std::optional<PanoramaXmp> panorama;
    std::optional<ThetaMakerNote> theta;
    std::vector<std::string> remarks; ///< Sentences about parts that are present but could not be read.

    bool operator==(const PhotoMetadata&) const = default;
};

/// Reads a JPEG's header only: no pixel is decoded. A part that is missing or makes no sense is absent in the
/// result. source: what the bytes are, for sentences. Errors: Corrupt if the bytes are no JPEG, Unsupported
/// as jpeg::readInfo. Threads: any, also at a time.
PhotoMetadata readMetadata(ByteView jpeg, std::string_view source);

/// How much light the exposure let in, in stops: the logarithm to base 2 of seconds times ISO speed over the
/// square of the f-number. It is nothing if the photo does not state all three, above 0.
std::optional<double> exposureStops(const PhotoMetadata& metadata);

/// True if the picture's vertical axis is gravity, so that its pose must not be applied again. The maker note
/// decides; without it, a Theta that levels in the camera counts as level while its pose stays under half a
/// degree, and a Theta S or SC does not. Any other camera counts as level if its pose says so.
bool isLevel(const PhotoMetadata& metadata);

/// Takes the photo's panorama frame to one with the same heading whose z axis is up: the identity for a level
/// photo, nothing if it is not level and does not say its tilt.
/// Frames: panorama, x forward, y left, z up.
std::optional<Eigen::Quaterniond> levelFromPhoto(const PhotoMetadata& metadata);

} // namespace spherewalk::photo
