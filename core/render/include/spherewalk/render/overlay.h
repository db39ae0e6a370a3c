// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/camera_model.h"

#include <cstdint>
#include <memory>
#include <span>

namespace spherewalk::render {

/// The number of what each pixel shows. 0 is the room: what the photos show.
using LabelImage = Image<std::uint16_t, 1>;

/// Whether the colours of a picture are already multiplied by its alpha.
enum class Alpha { Straight, Premultiplied };

/// Objects that a simulator rendered from the view's own pose, to be laid into the view.
///
/// Units: depths are z along the optical axis in metres. A depth that is not finite and above zero counts as
/// no depth (+infinity, NaN, 0, -1: simulators differ). In `depth` it says that no object is at the pixel's
/// centre; in `roomDepth` it says that nothing can hide an object. Things 90 degrees or more off the axis
/// have no z and cannot be laid in.
struct Overlay {
    RgbaImage picture;
    Alpha alpha = Alpha::Straight;
    DepthImage depth; ///< The depth of the objects. Shape: that of the picture.
    /// The camera that took the picture. If it is the view's camera, pixels are taken as they are. Otherwise
    /// the view's pixels are looked up bilinearly, so it should have about as many pixels per degree.
    CameraIntrinsics camera;
    /// The depth of the room as the simulator models it, through the same camera. Shape: that of the picture.
    /// If it is empty, the depth of the view's scene model takes its place.
    DepthImage roomDepth;
    /// The number of the object in each pixel, for Composer::compose(). Shape: that of the picture. If it is
    /// empty, the overlay is one object. Its number is its place among the overlays, 1 for the first.
    LabelImage labels = {};
    /// The share of the room's light that the objects leave in each pixel: 1 where they cast no shadow. It
    /// darkens what the photos show, in linear light, and no overlay. Shadows of several overlays are
    /// multiplied. Shape: that of the picture; empty if objects cast no shadow. Range: 0 to 1.
    Image<float, 1> shadow = {};
};

/// The border between an object and what hides it.
enum class Edges {
    Hard, ///< A pixel is shown or hidden as a whole.
    Soft, ///< The border is softened by a pixel on either side, as in photos: see resources/docs/render.md.
};

struct ComposeOptions {
    /// How far an object may lie behind the room's surface and still be shown: the larger of toleranceM and
    /// toleranceShare of the room's depth. Up to twice as far the object fades. The tolerance covers errors
    /// of the depths, so that things on a wall or a table do not flicker. Nothing in front ever fades. Things
    /// hidden by something thinner than twice the tolerance shine through.
    double toleranceM = 0.005;
    double toleranceShare = 0.002;
    Edges edges = Edges::Soft;
    int threads = 0; ///< The most to use, 0 for all of the pool. The bytes are the same for any number.
};

/// Lays overlays into views. It keeps tables of the lenses that were used last. Threads: any, at a time.
class Composer {
  public:
    Composer();
    ~Composer();
    Composer(Composer&&) noexcept;
    Composer& operator=(Composer&&) noexcept;

    /// Darkens the picture by the overlays' shadows. Then it lays the overlays in, each pixel's farthest
    /// first. Of equal depths the later overlay is on top. Colours are blended as they are stored. At an
    /// object's rim a half covered pixel may have no depth, as the object misses its centre: it takes the
    /// nearest depth of its neighbours, or is not shown if they have none. Depths are never interpolated.
    ///
    /// camera: the view's camera. viewDepth: the depth of its scene model, as View::depth; if it is empty, an
    /// overlay without a roomDepth is in front of everything. shown, if given: how much of each pixel
    /// overlays cover, 255 for all of it. labels, if given: of a pixel of which overlays cover at least half,
    /// the number of the object that covers most; 0 of all others. Errors: InvalidInput, before anything is
    /// changed, for sizes that do not fit each other, and for invalid cameras, shadows and tolerances. Cost:
    /// resources/docs/render.md has figures; the first overlay of a camera that is not the view's costs about
    /// a microsecond a pixel more.
    void compose(std::span<const Overlay> overlays, const CameraModel& camera, const DepthImage& viewDepth,
                 const ComposeOptions& options, WorkerPool& pool, RgbImage& picture,
                 MaskImage* shown = nullptr, LabelImage* labels = nullptr);

    /// Gives pixels of which overlays cover at least half the depth of the nearest overlay there. shown,
    /// depth: those of compose(), with the same overlays and camera. A pixel at whose centre no overlay has a
    /// depth, as at rims, keeps its own.
    void layDepth(std::span<const Overlay> overlays, const CameraModel& camera, const MaskImage& shown,
                  const ComposeOptions& options, WorkerPool& pool, DepthImage& depth);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
