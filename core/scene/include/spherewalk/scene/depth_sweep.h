// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/rigid3.h"

#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::scene {

/// A photo whose depth is wanted, or that helps to find a neighbour's. Owner: the picture must outlive it.
struct PosedPicture {
    const RgbImage* picture = nullptr; ///< equirectangular
    Rigid3 roomFromPhoto;
};

/// How far away what each pixel of a photo shows is. Frames: the photo's own. Shape: width x width / 2.
struct PhotoDepth {
    Image<float, 1> inverseM; ///< 1 / distance along the pixel's ray, above 0
    MaskImage sure;           ///< 255 where the neighbours bear it out, 0 where it is filled in from beside
};

struct SweepOptions {
    int width = 1024;       ///< of the depth, a power of two times coarseWidth
    int coarseWidth = 512;  ///< at which all distances are tried, a multiple of 64
    int distances = 128;    ///< tried, evenly spread in 1 / distance
    double nearestM = 0.45; ///< of the distances tried
    double farthestM = 20;
    int neighbours = 6;           ///< at most
    double leastBaselineM = 0.05; ///< a photo nearer than that says nothing about distance
    double keptShare = 0.5; ///< of the neighbours, those that fit best: the others may not see the thing
    int threads = 0;        ///< 0: all that the machine has; the result is the same for any number

    /// Errors: InvalidInput with a sentence.
    void validate() const;
};

/// The photos, by index, that a photo's depth is found with: the nearest ones that are far enough away.
std::vector<std::size_t> sweepNeighbours(std::span<const Rigid3> roomFromPhotos, std::size_t photo,
                                         const SweepOptions& options);

/// The depth of a photo from neighbours whose poses are known: a sphere about the photo is swept from far to
/// near, and at each pixel the distance is taken at which the neighbours show the same there (mean difference
/// of those that fit best), together with what the pixels around say (semi-global, then, at finer sizes,
/// edge-aware). Nothing in it is `sure` yet; see agreeingDepth(). Cost: with the usual options about 2.5 s of
/// one core and 150 MB. Errors: InvalidInput for no neighbours, empty pictures, poses that are not finite;
/// Stopped. Source: Collins 1996 (sweep), Hirschmueller 2008 (semi-global), He 2010 (guided filter).
PhotoDepth sweptDepth(const PosedPicture& photo, std::span<const PosedPicture> neighbours,
                      const SweepOptions& options = {}, const std::stop_token& stop = {});

/// A depth and where it was found.
struct PosedDepth {
    const PhotoDepth* depth = nullptr;
    Rigid3 roomFromPhoto;
};

/// The depth with `sure` set where at least one neighbour's depth says the same within a tolerance (a share
/// of 1 / distance, plus what a pixel of parallax is), and with the other pixels taken over from sure ones
/// beside them that look alike; of two candidates the farther, since what one photo alone sees lies behind.
/// Surfaces are smoothed at the end.
PhotoDepth agreeingDepth(const PosedDepth& photo, const RgbImage& picture,
                         std::span<const PosedDepth> neighbours, int threads = 0);

} // namespace spherewalk::scene
