// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A part of a photo that shows something else than its neighbours see there.
struct ChangedContent {
    int photo = 0;
    Eigen::Vector3d directionInPhoto = Eigen::Vector3d::UnitX(); ///< unit, the middle of the part
    Radians radius;                                              ///< of a disc about as large
    double confidence = 0;                                       ///< in [0, 1]
    std::string reason; ///< a sentence: "What its 8 neighbours see there is not in this photo."
};

struct ContentCheckOptions {
    int threads = 0; ///< 0: all that the machine has
};

/// Finds photos in which something moved, vanished or came in (a chair, a door, a person): compact parts,
/// from about 8 degrees across, that should show many things on which the photo's neighbours agree with one
/// another, and show hardly any of them where they should be.
///
/// roomFromPhoto: one a photo; nothing where it was not solved. isInlier: one list a pair, of the same order,
/// one entry a match: whether the match fits the solved poses. Matches need their features' indices: without
/// them nothing tells that two neighbours see the same thing.
///
/// What vanished or is covered is told only where it is much, as furniture that hides things looks alike;
/// what stands elsewhere in the photo is told sooner.
///
/// Not judged: photos with fewer than three neighbours; parts with little to recognise; photos that differ
/// from their neighbours in more than four parts (they are wrong as a whole); changes that some neighbours
/// share. So if from one photo on all later ones see the chair elsewhere, nothing is reported: each photo has
/// neighbours that agree with it. At the survey's rim, where all neighbours stand to one side, what is missed
/// may also be hidden by what stands nearer: there only clear changes are told.
///
/// Frames: bearings and directions in the photo's panorama frame. Errors: InvalidInput if the lists' lengths
/// differ or a pair names a photo that does not exist. Threads: the result is the same for any number. Cost:
/// about 10 ms a photo with 12 neighbours.
std::vector<ChangedContent> changedContent(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                           std::span<const PhotoPair> pairs,
                                           std::span<const std::vector<bool>> isInlier,
                                           const ContentCheckOptions& options = {});

} // namespace spherewalk::align
