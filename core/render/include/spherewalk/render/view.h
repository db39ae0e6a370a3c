// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/overlay.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spherewalk::render {

struct ViewOptions {
    std::optional<SceneKind>
        scene; ///< Without a value, the dataset's choice or its best scene model is taken.
    int threads =
        0; ///< The most to use, 0 for all that the machine has. The pixels are the same for any number.
    Sampling sampling = Sampling::Best;
    double toleranceDb = 40; ///< For Sampling::Auto: how far below full scale the error shall be.
    /// Each pixel is computed by itself in double precision, bilinear. It is for comparisons: a hundred times
    /// slower.
    bool exact = false;
    bool wantsDepth = false; ///< Whether View::depth is made.
    bool wantsTrust = false; ///< Whether View::trust is made.
    /// Whether View::depth shows overlays, too, where they cover at least half of a pixel.
    bool depthShowsOverlays = false;
    bool wantsLabels = false; ///< Whether View::labels is made.
    /// A photo that this view must not use, to compare it with. It is ignored if there is no other photo.
    std::optional<std::size_t> without = {};
    /// Objects to be laid into the picture. Owner: they must live until the view is made.
    std::span<const Overlay> overlays = {};
    ComposeOptions compose = {}; ///< How overlays are laid in; `threads` above holds for them, too.
    bool correctsColour = true;  ///< Whether the dataset's colour correction is applied.
};

/// The picture that a view's pixels come from.
enum class ViewOrigin {
    Photo,         ///< The nearest photo.
    Thumbnail,     ///< The nearest photo's thumbnail, since the photo was not decoded yet.
    PreviousPhoto, ///< The photo of the view before, since the nearest one was not decoded yet.
};

/// The word that options and files use: "photo", "thumbnail", "previous".
std::string_view name(ViewOrigin origin);

/// What a view was made from, and how far it can be trusted.
struct ViewReport {
    std::size_t photo = 0; ///< The index of the photo in DatasetInfo::photos.
    std::string file;
    SceneKind scene = SceneKind::None;
    Sampling sampling = Sampling::Footprint; ///< The sampling that was used, neither Best nor Auto.
    ViewOrigin origin = ViewOrigin::Photo;
    bool isLate = false; ///< Whether a part of the photo was not in memory when the view was asked for.
    double offsetM = 0;  ///< The distance between the camera and the photo.
    /// Whether the photos see the camera's place (Dataset::sees()). If none does, the view is made from the
    /// nearest ones, and may show what lies behind a wall.
    bool seesPlace = true;
    /// Whether the camera is outside of what was scanned (Dataset::isOutside()). Its trust is then 0.
    bool isOutside = false;
    /// By how many pixels things are displaced: the median over the view of what the evidence says.
    double parallaxPx = 0;
    double seenShare = 0;   ///< The share of pixels that have neither PixelFlag::Filled nor Unsure.
    double filledShare = 0; ///< The share of pixels from further photos, for scene models with surfaces.
    double blurPx = 0;      ///< How far a thumbnail's pixels reach beyond one of the view's.
    /// 1 / (1 + parallaxPx + blurPx): 1 at a photo's own position, 0.5 at 1 px of doubt. It is 0 where
    /// nothing is known: outside, where no photo sees the place, and for a photo whose rotation is not known.
    double trust = 0;
    double decodeMs = 0;  ///< How long the view waited for tiles to be decoded; 0 if all were in memory.
    int decodedTiles = 0; ///< The number of tiles that the view waited for.
    bool isWholeDecode = false; ///< Whether all of the photo was decoded, as it has no restart markers.
    bool isVerified = false;    ///< Whether the photo's hash is known to be the one in dataset.json.
    double renderMs = 0;
};

/// What is to be known of a pixel besides its error. Flags are bits: several may hold.
enum class PixelFlag : std::uint8_t {
    Unseen = 1, ///< The lens sees nothing there.
    Pole = 2,   ///< It lies near the photo's zenith or nadir, where the camera's own foot is in the picture.
    Stitching = 4, ///< It lies near the great circle where the pictures of a camera's two lenses were joined.
    Seam = 8,      ///< It comes partly from the photo's left border, partly from its right one.
    Coarse = 16,   ///< It is blurred, since the view was made from a coarser picture than the photo.
    Overlay = 32,  ///< An overlay covers at least a part of it.
    Filled = 64,   ///< No photo shows what is there: it was filled in from beside.
    /// It may be displaced by more than two pixels. The error is above that, the depth is doubtful there, or
    /// nothing is known, as outside of what was scanned.
    Unsure = 128,
};

/// Whether the flags of a pixel (PixelTrust::flags) hold this one.
constexpr bool has(std::uint8_t flags, PixelFlag flag) {
    return (flags & static_cast<std::uint8_t>(flag)) != 0;
}

/// How far each pixel can be believed. Shape: both pictures have the view's size.
struct PixelTrust {
    /// By how many pixels of the view the shown thing is displaced, as far as the evidence tells. It is
    /// +infinity where the lens sees nothing, and in all of a view about which nothing is known. Under an
    /// overlay it is the error of the photo's pixel.
    Image<float, 1> errorPx;
    MaskImage flags; ///< The bits are those of PixelFlag.
};

/// The trust for such an error, as ViewReport::trust: 1 without error, 0.5 for one pixel, 0 for +infinity.
constexpr float trust(float errorPx) {
    return 1 / (1 + errorPx);
}

/// A finished view. Parts that were not asked for are empty.
struct View {
    RgbImage picture; ///< It is black where the lens sees nothing.
    /// The depth of the scene model: z along the optical axis, in metres. It is without overlays but for
    /// ViewOptions::depthShowsOverlays. It is +infinity where the lens sees nothing or 90 degrees or more off
    /// the axis. SceneKind::None gives none.
    DepthImage depth;
    PixelTrust trust;
    MaskImage overlaid; ///< How much of each pixel overlays cover: 255 for all. It is empty without overlays.
    /// The numbers of the objects that overlays show, as Composer::compose() has them; 0 is the room. Without
    /// overlays all is room.
    LabelImage labels;
    ViewReport report;
};

} // namespace spherewalk::render
