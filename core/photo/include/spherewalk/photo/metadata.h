// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::photo {

/// What the XMP of a panorama says about its projection and pose.
/// Source: Google, Photo Sphere XMP Metadata, namespace GPano.
struct PanoramaXmp {
    std::string projection; ///< "equirectangular", or empty if not said
    /// Compass direction of the picture's centre, clockwise from north. Range: [0, 360).
    std::optional<Degrees> heading;
    /// Of the picture's centre above the horizon: the opposite sign of YawPitchRoll::pitch.
    std::optional<Degrees> pitch;
    /// How far the camera leaned to its right: the sign of YawPitchRoll::roll.
    std::optional<Degrees> roll;
    std::optional<int> fullWidth;
    std::optional<int> fullHeight;
    std::optional<int> croppedWidth;
    std::optional<int> croppedHeight;

    bool operator==(const PanoramaXmp&) const = default;
};

/// What a Ricoh Theta writes into its maker note; every part may be missing.
/// Source: Ricoh theta-api-specs, "theta-metadata"; the tags' numbers stand beside.
struct ThetaMakerNote {
    std::string firmware;         ///< 0x0002
    std::string serial;           ///< 0x0005
    std::optional<int> imageType; ///< 0x0001 of the Theta directory: 1 equirectangular, 2 dual fisheye
    std::optional<Degrees> inclinationRoll;   ///< 0x0003, in (-180, 180]
    std::optional<Degrees> inclinationPitch;  ///< 0x0003, in (-180, 180]
    std::optional<Degrees> compass;           ///< 0x0004, meaningless without calibration
    std::optional<bool> isLevelled;           ///< 0x0007: the picture was turned upright in the camera
    std::string timeZone;                     ///< 0x000A, "+hh:mm" or "-hh:mm", else empty
    std::optional<Eigen::Vector3d> zenith;    ///< 0x0109, a rotation vector, as written
    std::optional<double> frontSensorCelsius; ///< 0x1001
    std::optional<double> rearSensorCelsius;  ///< 0x1003

    bool operator==(const ThetaMakerNote&) const = default;
};

/// What a photo says about itself. Texts are trimmed and printable; a text that is not said is empty.
struct PhotoMetadata {
    int width = 0;
    int height = 0;
    std::string make;
    std::string model;
    std::string software;
    std::string takenAt;  ///< camera's local time, "2026-01-02T03:04:05"
    std::string timeZone; ///< of takenAt, from the maker note: "+hh:mm"
    std::optional<double> exposureS;
    std::optional<double> fNumber;
    std::optional<int> iso;
    std::optional<bool> hasFixedWhiteBalance; ///< not chosen by the camera
    std::optional<PanoramaXmp> panorama;
    std::optional<ThetaMakerNote> theta;
    std::vector<std::string> remarks; ///< sentences about parts that are there but could not be read

    bool operator==(const PhotoMetadata&) const = default;
};

/// Reads a JPEG's header only: no pixel is decoded. A part that is missing or makes no sense is absent in the
/// result. source: what the bytes are, for sentences. Errors: Corrupt if the bytes are no JPEG, Unsupported
/// as jpeg::readInfo. Threads: any, also at a time.
PhotoMetadata readMetadata(ByteView jpeg, std::string_view source);

} // namespace spherewalk::photo
