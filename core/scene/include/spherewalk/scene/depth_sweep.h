// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_depth.h"

#include <array>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::scene {

/// A picture and smaller ones of it, made once for many uses.
class PictureSizes {
  public:
    /// mostWidth: what a wider picture is made smaller to; 0 leaves it as it is.
    explicit PictureSizes(RgbImage picture, int mostWidth = 0);

    const RgbImage& largest() const { return m_pictures.front(); }

    /// The smallest one that has this width at least, or the largest if none has.
    const RgbImage& atLeast(int width) const;

  private:
    std::vector<RgbImage> m_pictures; ///< Each is half as wide as the one before.
};

/// What the values of a photo's red, green and blue are multiplied by. Values that follow a power of the
/// light differ by a factor, whatever the exposure. Cameras compress bright ones, see render::exposedValue().
using Gains = std::array<float, 3>;

/// A photo with its pose: one whose depth is wanted, or a neighbour of it. Owner: the pictures must outlive
/// it.
struct PosedPicture {
    const RgbImage* picture = nullptr; ///< Equirectangular.
    Rigid3 roomFromPhoto;
    LensPair lenses = {};
    const PictureSizes* sizes = nullptr; ///< Of the picture, if it serves many photos.
    /// With them photos are about equally bright, as the camera's settings tell; see toldGains().
    std::optional<Gains> gains = {};

    /// A picture of this width or a greater one, as far as there is one.
    const RgbImage& atLeast(int width) const { return sizes != nullptr ? sizes->atLeast(width) : *picture; }
};

/// The distance of the thing that each pixel of a photo shows. Frames: the photo's own. Shape: width x width
/// / 2.
struct PhotoDepth {
    Image<float, 1> inverseM; ///< 1 / distance along the pixel's ray from its lens, above 0; 1 / metres.
    MaskImage sure;           ///< 255 where it was measured, 0 where it continues what lies beside.
};

struct SweepOptions {
    int width = 1024;             ///< Of the depth: a power of two times coarseWidth.
    int coarseWidth = 512;        ///< Width at which all distances are tried, a multiple of 64.
    int distances = 128;          ///< Largest number of distances tried.
    double stepPx = 1;            ///< Parallax from one distance to the next, in pixels of the coarse width.
    double nearestM = 0.1;        ///< Nearest distance tried, beside neighbours as near as that.
    int neighbours = 6;           ///< Largest number of neighbours used.
    double leastBaselineM = 0.05; ///< A nearer photo says nothing about distance.
    double keptShare =
        0.5;         ///< Share of the neighbours that counts, the best; the others may not see the thing.
    int threads = 0; ///< 0 means all that the machine has. The result is the same for any number.

    /// Errors: InvalidInput with a sentence.
    void validate() const;
};

/// Indices of the photos that a photo's depth is found with: the nearest ones that are far enough away.
/// walls: the room's outline; empty if it is not known. What stands behind a wall shows little of what the
/// photo shows, so such photos only make up three.
std::vector<std::size_t> sweepNeighbours(std::span<const Rigid3> roomFromPhotos, std::size_t photo,
                                         const SweepOptions& options, const Polygon& walls = {});

/// The rank of each photo in an order in which photos beside each other mostly follow each other: in strips
/// across the room that are a few photos wide. Range: finite poses.
std::vector<std::size_t> ranksByPlace(std::span<const Rigid3> roomFromPhotos);

/// The depth of a photo from neighbours whose poses are known. A sphere about the photo is swept from far to
/// near. Each pixel gets the distance at which the neighbours that fit best show the same there. Pixels
/// around count too: semi-globally at the coarse width, with an edge-aware filter at finer ones. A pixel is
/// `sure` where distances beside the best one fit much less well; on a bare wall none is. Neighbours are made
/// as bright as the photo first. Cost: with the usual options about 1 s of one core and 150 MB. Errors:
/// InvalidInput for no neighbours, empty pictures, poses that are not finite; Stopped. Source: Collins 1996
/// (sweep), Hirschmueller 2008 (semi-global), He 2010 (guided filter).
PhotoDepth sweptDepth(const PosedPicture& photo, std::span<const PosedPicture> neighbours,
                      const SweepOptions& options = {}, const std::stop_token& stop = {});

/// A depth and the pose of its photo. Owner: the depth must outlive it.
struct PosedDepth {
    const PhotoDepth* depth = nullptr;
    Rigid3 roomFromPhoto;
    LensPair lenses = {};
};

/// The depth that neighbours confirm, and planes where they do not. A neighbour confirms what it gives the
/// same distance to, within 1.5 % of 1 / distance plus 0.75 pixels of parallax. What is confirmed counts as
/// much as exceeds chance: where neighbours contradict most of what lies about, or the poses are rough,
/// nothing counts. Elsewhere planes are continued up to edges of the picture, and become even far from what
/// is known: a sphere if nothing is. Small surfaces that stand by themselves are taken off. Of the result, a
/// pixel is `sure` where it was confirmed and either evident in the sweep or on the plane of what lies about.
PhotoDepth agreeingDepth(const PosedDepth& photo, const RgbImage& picture,
                         std::span<const PosedDepth> neighbours, int threads = 0);

/// A photo with its pose and its depth. Owner: both must outlive it.
struct KnownPhoto {
    PosedPicture photo;
    const PhotoDepth* depth = nullptr;
};

/// A photo's depth, made better by what its neighbours know. What the neighbours are sure of is seen from the
/// photo, and taken over where it fits the pictures better than the photo's own depth. Edges go where they
/// fit best, by up to three pixels. A neighbour has no say where its own depth shows something nearer. Bare
/// surfaces stay as they are, since pictures of them tell no distance. What is taken over is `sure`. At last
/// planes are continued from all that is sure over what is not. Far from what is sure the photo shows the
/// room's walls, floor and ceiling, if it stands in the room and two fifths of what it surely shows towards
/// walls lie on them. Else it keeps what neighbours agreed on there, smoothed. Borders where nothing is sure
/// are evened. Shape: all depths are of one width, a multiple of 16. room: may be null. Cost: 0.7 s of one
/// core with four neighbours. Errors: InvalidInput if sizes differ; Stopped.
PhotoDepth refinedDepth(const KnownPhoto& photo, std::span<const KnownPhoto> neighbours,
                        const render::RoomShape* room, int threads = 0, const std::stop_token& stop = {});

} // namespace spherewalk::scene
