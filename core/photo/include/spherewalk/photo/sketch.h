// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/metadata.h"

#include <optional>
#include <string_view>

namespace spherewalk::photo {

/// Size of a sketch's picture in pixels.
inline constexpr int kSketchWidth = 192;
inline constexpr int kSketchHeight = 96;

/// How wide the sharpest edges are, in pixels of the photo or of its reduction to at most 2752 pixels. About
/// 1 in a sharp picture. A value is absent where the photo has too few edges.
struct EdgeWidths {
    std::optional<double> alongRows;    ///< Width of upright edges, which a turning camera widens.
    std::optional<double> alongColumns; ///< Width of level edges.

    bool operator==(const EdgeWidths&) const = default;
};

/// A small digest of a photo. Judging the photo and its neighbours needs nothing else of its pixels.
struct Sketch {
    int width = 0;    ///< Width of the photo in pixels.
    int height = 0;   ///< Height of the photo in pixels.
    RgbImage picture; ///< kSketchWidth x kSketchHeight pixels, levelled if the photo says its tilt.
    EdgeWidths edges;
    double brightness = 0; ///< Mean over the sphere, in [0, 255].
    double blackPart = 0;  ///< Part of the sphere, in [0, 1], that is too dark to show anything.
    double burntPart = 0;  ///< Part of the sphere, in [0, 1], that is as bright as the camera can record.
    /// The exposure in stops: log2 of the time in seconds x ISO / f-number^2. Absent if the photo does not
    /// say all three.
    std::optional<double> exposureStops;

    bool operator==(const Sketch&) const = default;
};

/// Decodes the photo at about 2700 pixels and keeps what is needed. source: the photo's name, for sentences.
/// Errors: those of jpeg::decode(); Corrupt if it is not twice as wide as high. Threads: any. Cost: about a
/// tenth of a second for 5376 x 2688 pixels.
Sketch sketch(ByteView jpeg, const PhotoMetadata& metadata, std::string_view source);

/// By how much a photo is turned against another one that was taken near it: what the other one shows at an
/// azimuth, the photo shows at that azimuth minus the turn. Nothing if the two look too little alike, or
/// about as much at another turn. Range: in (-pi, pi]. It is right to a few degrees where most things are
/// farther away than the photos are apart. Cost: about 5 ms.
std::optional<Radians> turnBetween(const Sketch& photo, const Sketch& other);

/// Whether the photo shows two fisheye pictures beside each other and no stitched sphere: two discs with
/// black around them.
bool isDualFisheye(const Sketch& sketch);

} // namespace spherewalk::photo
