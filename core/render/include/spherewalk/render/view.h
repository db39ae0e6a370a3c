// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/render/overlay.h"
#include "spherewalk/render/pixel_trust.h"
#include "spherewalk/render/sampling.h"
#include "spherewalk/render/scene_model.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spherewalk::render {

struct ViewOptions {
    std::optional<SceneKind> scene; ///< nothing: the best one that the dataset has
    int threads = 0;                ///< 0: all that the machine has; the pixels are the same for any number
    Sampling sampling = Sampling::Footprint;
    double toleranceDb = 40; ///< for Sampling::Auto: how far below full scale its error is to be
    /// Every pixel by itself in double precision, bilinear, a hundred times slower: for comparisons.
    bool exact = false;
    bool wantsDepth = false; ///< View::depth
    bool wantsTrust = false; ///< View::trust
    /// Not to be used for this view: leave one out, and compare. Ignored if it is the only photo.
    std::optional<std::size_t> without = {};
    /// Laid into the picture. Owner: they must live until the view is made.
    std::span<const Overlay> overlays = {};
    ComposeOptions compose = {}; ///< how; its threads are those above
    bool correctsColour = true;  ///< as the dataset says; false: the photos' own colours
};

/// What a view's pixels come from.
enum class ViewOrigin {
    Photo,         ///< the nearest photo
    Thumbnail,     ///< the nearest photo's thumbnail, since the photo was not decoded yet
    PreviousPhoto, ///< the photo of the view before, since the nearest one was not decoded yet
};

std::string_view name(ViewOrigin origin);

/// What a view was made from, and how far it can be trusted.
struct ViewReport {
    std::size_t photo = 0; ///< index into DatasetInfo::photos
    std::string file;
    SceneKind scene = SceneKind::None;
    Sampling sampling = Sampling::Footprint; ///< what was used, never Auto
    ViewOrigin origin = ViewOrigin::Photo;
    bool isLate = false; ///< something that it needs was not in memory when it was asked for
    double offsetM = 0;  ///< between the camera and the photo
    /// By how much a thing at half or at twice the distance that the scene model assumes would be displaced,
    /// at worst, in pixels at the picture's centre; with SceneKind::None, a thing at the dataset's usual
    /// distance (its sphere's radius, or 2 m if it has none).
    double parallaxPx = 0;
    double filledShare =
        0;                ///< of the pixels, that had to come from another photo; scene models with surfaces
    double blurPx = 0;    ///< of a thumbnail: how far its pixels reach beyond one of the view's
    double trust = 0;     ///< 1 / (1 + parallaxPx + blurPx): 1 at a photo's own place, 0.5 with 1 px in doubt
    double decodeMs = 0;  ///< waiting for the photo to be decoded, 0 if it was in memory
    int decodedTiles = 0; ///< that it waited for
    bool isWholeDecode = false; ///< the photo has no restart markers: all of it was decoded
    bool isVerified = false;    ///< the photo's hash is that of dataset.json
    double renderMs = 0;
};

/// What was not asked for is empty.
struct View {
    RgbImage picture; ///< black where the lens sees nothing
    DepthImage depth; ///< of the scene model without overlays, as viewDepth() says: none for SceneKind::None
    PixelTrust trust; ///< as pixelTrust() says
    MaskImage overlaid; ///< how much of each pixel overlays cover, 255 for all of it; empty without overlays
    ViewReport report;
};

} // namespace spherewalk::render
