// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// Which matches fit the poses found, one list a pair in their order, one entry a match: in one plane with
/// the baseline and in front; alike in direction where two photos share a place. A pair with a photo that has
/// no pose fits nothing. Shape: roomFromPhoto has one entry a photo, empty where the photo was not solved.
std::vector<std::vector<bool>> fittingMatches(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                              std::span<const PhotoPair> pairs);

/// A region of a photo that shows something else than the photo's neighbours see there.
struct ChangedContent {
    int photo = 0;
    Eigen::Vector3d directionInPhoto = Eigen::Vector3d::UnitX(); ///< Middle of the region, unit.
    Radians radius;                                              ///< Of a disc of about the same size.
    double confidence = 0;                                       ///< In [0, 1].
    std::string reason; ///< A sentence: "What its 8 neighbours see there is not in this photo."
};

struct ContentCheckOptions {
    int threads = 0; ///< 0 means all that the machine has.
    /// Whether features were looked for in this direction of a photo's frame. Empty: everywhere.
    std::function<bool(const Eigen::Vector3d&)> isSearched = nullptr;
};

/// Finds photos in which something moved, vanished or came in (a chair, a door, a person). Reported are
/// compact regions, from about 8 degrees across. Such a region should show many things on which the photo's
/// neighbours agree with one another, and hardly any of them is where it should be.
///
/// Shape: roomFromPhoto has one entry a photo, empty where the photo was not solved; isInlier is what
/// fittingMatches() returns. Matches need their features' indices: without them nothing tells that two
/// neighbours see the same thing.
///
/// Things that vanished or are covered are reported only where there is much of them, and neighbours look at
/// them from within 12 degrees, since furniture that hides things looks alike. Things that stand elsewhere in
/// the photo are reported sooner.
///
/// Not judged are: directions that were not searched for features; photos with fewer than three neighbours;
/// regions with little to recognise; photos that differ from their neighbours in more than four regions (they
/// are wrong as a whole); changes that some neighbours share. So if all photos from one on see the chair
/// elsewhere, nothing is reported. At the survey's rim all neighbours stand to one side, and nearer things
/// may hide what is missed; only clear changes are reported there.
///
/// Frames: bearings and directions in the photo's panorama frame. Errors: InvalidInput if the lists' lengths
/// differ or a pair names a photo that does not exist. Threads: the result is the same for any number. Cost:
/// about 10 ms a photo with 12 neighbours.
std::vector<ChangedContent> changedContent(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                           std::span<const PhotoPair> pairs,
                                           std::span<const std::vector<bool>> isInlier,
                                           const ContentCheckOptions& options = {});

} // namespace spherewalk::align
