// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::align {

/// Width in pixels of the pictures that the check works on. They are half as high.
inline constexpr int kSightWidth = 512;

/// A photo of the survey, small. The picture is absent if it could not be read, the pose if it is not solved.
struct SightPhoto {
    RgbImage picture; ///< Equirectangular, kSightWidth pixels wide.
    std::optional<Rigid3> roomFromPhoto;
};

/// Something in a photo that stands where other photos look through.
struct ForeignThing {
    int photo = 0;
    Eigen::Vector3d directionInPhoto = Eigen::Vector3d::UnitX(); ///< Middle of the area, unit.
    double part = 0;                                             ///< Part of the sphere, in [0, 1].
};

struct ForeignCheck {
    std::vector<ForeignThing> things; ///< In the order of the photos, the largest of each first.
    std::vector<bool> isJudged;       ///< For each photo, whether other photos near it could be compared.
};

struct ForeignCheckOptions {
    MaskImage mask;  ///< Equirectangular of any size; what is 0 is not searched. Empty: all is searched.
    int threads = 0; ///< 0 means all that the machine has.
};

/// Finds persons and other things that stand in some photos and not in others.
///
/// The poses say where each photo looks. From its neighbours each photo learns how far away things are, as an
/// interval of distances. A direction of a photo is then followed from near to far. At each distance other
/// photos look through, see a surface there, or are hidden from the place. The direction is foreign if it
/// meets a surface that others see, the photo shows something else, and all nearer places are seen through.
/// What furniture hides from the others is therefore never foreign, since nobody looks through it.
///
/// A thing that stands at the same place in several photos is found too, if more photos look through its
/// place than show it. What is foreign in one photo is taken from it, and those photos are searched again
/// that had it to go by: it may be the reason why nothing was foreign there. It is not found if all
/// neighbours show it, or if it lies on the line from one of two photos to the other. Things smaller than 0.2
/// % of the sphere are not told. Searched is from 45 degrees below the horizon to 30 degrees above it,
/// against photos that stand 8 cm to 3 m away.
///
/// Stop: Error{Stopped}. Threads: the result is the same for any number. Cost: 0.4 s a photo and core, and as
/// much again for photos beside one with something foreign.
ForeignCheck foreignThings(std::span<const SightPhoto> photos, const ForeignCheckOptions& options,
                           ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
