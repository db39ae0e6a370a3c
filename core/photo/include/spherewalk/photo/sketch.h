// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/photo/metadata.h"

#include <optional>
#include <string_view>

namespace spherewalk::photo {

inline constexpr int kSketchWidth = 192;
inline constexpr int kSketchHeight = 96;

/// How wide the sharpest edges are, in pixels of the photo or of its reduction to at most 2752 pixels. About
/// 1 in a sharp picture. Nothing where there are too few edges to tell.
struct EdgeWidths {
    std::optional<double> alongRows;    ///< of upright edges: what a turning camera widens
    std::optional<double> alongColumns; ///< of level edges

    bool operator==(const EdgeWidths&) const = default;
};

/// What is kept of a photo to judge it, and to compare its neighbours with.
struct Sketch {
    int width = 0; ///< of the photo, pixels
    int height = 0;
    RgbImage picture; ///< kSketchWidth x kSketchHeight, levelled as far as the photo says its tilt
    EdgeWidths edges;
    double brightness = 0; ///< mean over the sphere, [0, 255]
    double blackPart = 0;  ///< of the sphere: so dark that nothing can be seen
    double burntPart = 0;  ///< of the sphere: as bright as the camera can tell

    bool operator==(const Sketch&) const = default;
};

/// Decodes the photo at about 2700 pixels and keeps what is needed. source: the photo's name, for sentences.
/// Errors: those of jpeg::decode(); Corrupt if it is not twice as wide as high. Threads: any. Cost: about a
/// tenth of a second for 5376 x 2688 pixels.
Sketch sketch(ByteView jpeg, const PhotoMetadata& metadata, std::string_view source);

} // namespace spherewalk::photo
