// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::align {

/// No wall is between lenses that are no farther apart.
inline constexpr double kBesideM = 0.6;

/// How much two placed photos show of each other's things.
struct PhotoAgreement {
    int a = 0;
    int b = 0;
    /// Number of things that each shares with third photos, counted as its usual neighbours show them.
    double expected = 0;
    double seen = 0;   ///< Of these, those that the other photo shows where they belong.
    double apartM = 0; ///< Between the lenses.
    /// What is seen of the things expected from one side, the better one. A blurred photo shows little, but
    /// what it shows is seen beside it. At least 1 if too few things are expected from one side.
    double betterShare = 1;
    double rangeM = 0; ///< Median distance of what either photo sees, the larger one.
    /// What is seen of the things that third photos share and that the photo has in sight from nearly the
    /// same side, seen from one side, the better one. At least 1 if few are in sight of either photo.
    double shareInSight = 1;
};

/// The agreement of each pair whose photos both have a pose, in their order. Shape: roomFromPhoto has one
/// entry a photo, empty where the photo was not solved; isInlier is what fittingMatches() returns. Frames:
/// the room's. Errors: InvalidInput if the lists' lengths differ or a pair names a photo that does not exist.
std::vector<PhotoAgreement> photoAgreements(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                            std::span<const PhotoPair> pairs,
                                            std::span<const std::vector<bool>> isInlier);

/// Cuts photos into parts within which neighbours show what they see of each other's things. Where two parts
/// are joined although neither shows what should stand around it by the other, what joined them is something
/// that is there twice: a room with the same furniture, or a door like another.
///
/// Two photos disagree if less than `leastShare` of the expected things is seen. Where fewer than 20 things
/// are expected, nothing speaks against the pair. Two photos contradict each other if hardly any of 50 things
/// or more is there, although they stand nearer to each other than things usually do, so that hardly a wall
/// hides them; or if they stand within besideM, so that no wall is between their lenses, and both show less
/// than half of what most of five such pairs or more show, unless they share 0.9 of what is usual in sight,
/// as on either side of a door; or if of what each has in sight of the other's things they share less than
/// 0.6 of what most of five pairs or more share that are as far apart to 0.2 m. Two pairs between the same
/// parts count like one that contradicts if each shares less than 0.85 of that, and if less than 0.6 of what
/// is expected is seen. Photos that contradict each other are never in one part, unless between their parts
/// three times as many pairs tell what is in sight, five at least, and half of them share 0.9 of what is
/// usual; and the pairs that agree least are cut between them. besideM: 0 where lengths are not in metres;
/// then what photos show beside each other and in sight is not asked.
///
/// Shape: isPlaced has one entry a photo, and all photos that agreements name are placed. The result has one
/// entry a photo: the number of its part, 0 for the one with the most photos; -1 for photos that are not
/// placed.
std::vector<int> agreeingParts(const std::vector<bool>& isPlaced, std::span<const PhotoAgreement> agreements,
                               double leastShare, double besideM = kBesideM);

/// Each two photos that contradict each other by themselves, as agreeingParts() has it, but also those that
/// share what is in sight. The smaller index comes first, and the list ascends. besideM: as there.
std::vector<std::pair<int, int>> contradictingPhotos(std::span<const PhotoAgreement> agreements,
                                                     double besideM = kBesideM);

/// Joins to the largest part the others of three photos and more that agree with it alone, the larger ones
/// first: what is of another place bends, before it is cut off, how the rooms of one place stand to each
/// other, and these then seem to be several places. partsWhereCut: what agreeingParts() returns for the poses
/// without any pair between different parts. Numbers of parts that were joined are left out.
std::vector<int>
rejoinedParts(std::vector<int> parts,
              const std::function<std::vector<int>(const std::vector<int>& parts)>& partsWhereCut);

} // namespace spherewalk::align
