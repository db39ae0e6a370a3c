// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/camera_model.h"

#include <memory>
#include <span>

namespace spherewalk::render {

/// Whether the colours of a picture are already multiplied by its alpha.
enum class Alpha { Straight, Premultiplied };

/// Objects as a simulator renders them, to be laid into a view from the view's own pose.
///
/// Units: depths are z along the optical axis in metres. A depth that is not finite and above zero
/// (+infinity, NaN, 0, -1: simulators differ) is none: in `depth` there is nothing at that pixel's centre, in
/// `roomDepth` nothing that could hide an object. Things 90 degrees or more off the axis have no z and cannot
/// be laid in.
struct Overlay {
    RgbaImage picture;
    Alpha alpha = Alpha::Straight;
    DepthImage depth; ///< of the objects. Shape: that of the picture
    /// What took the picture. If it is the view's camera, pixels are taken as they are; else the view's
    /// pixels are looked up in it, bilinearly, so it should have about as many pixels per degree.
    CameraIntrinsics camera;
    /// Of the room as the simulator models it, through the same camera. Shape: that of the picture; or empty,
    /// and the depth of the view's scene model takes its place.
    DepthImage roomDepth;
};

/// What the border between an object and what hides it is like.
enum class Edges {
    Hard, ///< a pixel is shown or hidden as a whole
    Soft, ///< softened over a pixel on either side, as pictures of edges are: see resources/docs/render.md
};

struct ComposeOptions {
    /// How far an object may lie behind the room's surface and still be shown: the larger of metres and share
    /// of the room's depth. From there to twice as far it fades. It covers what depths are off by, so that
    /// what stands against a wall or lies on a table does not flicker, and never fades what is in front.
    /// Things that are hidden by something thinner than twice this shine through.
    double toleranceM = 0.005;
    double toleranceShare = 0.002;
    Edges edges = Edges::Soft;
    int threads = 0; ///< 0: all of the pool; the bytes are the same for any number
};

/// Lays overlays into views; keeps what it needs to know of the lenses used last. Threads: any.
class Composer {
  public:
    Composer();
    ~Composer();
    Composer(Composer&&) noexcept;
    Composer& operator=(Composer&&) noexcept;

    /// Lays the overlays into the picture, each pixel's farthest first; where two have the same depth, the
    /// later one is on top. Colours are blended as they are stored. A half covered pixel at an object's rim
    /// whose centre the object misses, and which therefore has no depth, takes the nearest depth of its
    /// neighbours; without one it is not shown. Depths are never interpolated.
    ///
    /// camera: the view's. viewDepth: of its scene model, as viewDepth() gives it, or empty: then an overlay
    /// without a roomDepth is in front of everything. shown, if given: how much of each pixel overlays cover,
    /// 255 for all of it. Errors: InvalidInput with a sentence, before anything is changed, for sizes that do
    /// not fit each other and for cameras and tolerances that are none. Cost: see resources/docs/render.md;
    /// the first overlay of a camera that is not the view's costs about a microsecond a pixel more.
    void compose(std::span<const Overlay> overlays, const CameraModel& camera, const DepthImage& viewDepth,
                 const ComposeOptions& options, WorkerPool& pool, RgbImage& picture,
                 MaskImage* shown = nullptr);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
