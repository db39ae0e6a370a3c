// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_depth.h"

namespace spherewalk::scene {

/// Where a photo was taken, and how far away things are around it.
struct PhotoWithDepth {
    Rigid3 roomFromPhoto;
    const render::DepthMap* depth = nullptr; ///< Owner: the caller. Null if nothing is known.
};

/// A photo as it would look if it had been taken at another place and turned as a photo there. Two photos of
/// an unchanged room then show the same thing at the same pixel. Each direction is followed as far as
/// here.depth says; without it things are endlessly far, and the photo is only turned. What something hides
/// from `there`, as there.depth says, is half as bright. Frames: the result has that of the photo at `here`.
/// Shape: the result has the picture's size. Cost: half a second for 5376 x 2688 pixels on two threads.
RgbImage photoSeenFrom(const PhotoWithDepth& here, const RgbImage& picture, const PhotoWithDepth& there,
                       int threads = 0);

} // namespace spherewalk::scene
