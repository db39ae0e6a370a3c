// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/photo/april_tag.h"
#include "spherewalk/render/dataset_format.h"

#include <span>
#include <string>
#include <vector>

namespace spherewalk::compare {

/// A pose at which a picture may have been taken, by the tags that it shows.
struct TagPose {
    Rigid3 roomFromCamera;
    double sigmaM = 0;        ///< Standard deviation of the position along the worst axis.
    Radians sigmaRotation;    ///< Standard deviation of the rotation about the worst axis.
    double misfit = 0;        ///< Root mean square of the corners' misses, in their standard deviations.
    std::vector<int> numbers; ///< The tags that were used.
    std::vector<int> moved;   ///< Tags that hang elsewhere than they did, by this pose.
};

/// What the tags of a picture tell.
struct TagRegistration {
    std::string why; ///< If there is no pose, a sentence that says why.
    /// The poses that most tags agree with, best first. A single small tag often leaves two, mirrored about
    /// the line of sight, and so do two tags that contradict each other.
    std::vector<TagPose> poses;
};

/// The pose of a camera from the tags that its picture shows: least squares over the corners of all of them,
/// from the two poses that each tag alone allows. A tag that contradicts the others is left out, and so is a
/// number that the picture shows twice. known: where tags hang in the room. Frames: optical. Source: Collins
/// and Bartoli 2014 (IPPE).
TagRegistration registeredByTags(std::span<const photo::SeenTag> seen,
                                 std::span<const render::DatasetTag> known);

} // namespace spherewalk::compare
