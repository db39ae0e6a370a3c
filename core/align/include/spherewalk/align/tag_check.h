// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A length with its standard deviation, both in units of another length.
struct Scale {
    double value = 1;
    double sigma = 0;
};

/// What the tags of the largest component have in common, as its photos see it.
struct TagFrame {
    bool isMirrored = false; ///< One axis points the wrong way, or the two axes are exchanged.
    /// Length of the tags' y axis over that of their x axis, 1 if both are right. Empty where photos on one
    /// line, or too few of them, do not tell.
    std::optional<Scale> yOverX;
};

/// What is wrong with all tags at once, from the directions of the pairs' baselines. A few wrong tags do not
/// change the result. Errors: InvalidInput for an estimate of photos that do not exist.
TagFrame tagFrame(std::span<const PhotoPrior> photos, std::span<const PairEstimate> estimates);

/// Length of the tags' y axis over that of their x axis, by where the photos were found to be: the pictures
/// give the shape of the solved places, whatever its scale. It is far better known than from directions
/// alone. A few wrong tags do not change it. Empty for fewer than 6 photos, and for photos on one line.
/// Shape: one entry a photo in both. Units: metres.
std::optional<Scale> yOverX(std::span<const Eigen::Vector2d> tagged, std::span<const Eigen::Vector2d> solved);

/// Length of the solved positions over their true length: how far the floor that the matches show lies below
/// the lenses, over how far it should. It is right if the photos' heights above the floor are. Empty where
/// the matches show no floor. Shape: roomFromPhoto has one entry a photo, empty where the photo was not
/// solved; isInlier is what fittingMatches() returns. Range: photos above z = 0.
std::optional<Scale> scaleByFloor(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                  std::span<const PhotoPair> pairs,
                                  std::span<const std::vector<bool>> isInlier);

/// Two photos that were taken at one place although their tags lie apart.
struct OnePlace {
    int a = 0; ///< Index among the photos, less than b.
    int b = 0;
    double tagsApartM = 0;
};

/// The pairs without parallax, where the survey's other pairs have it, unless most third photos lie in other
/// directions from one of both than from the other. Values that are not finite are passed
/// over.
std::vector<OnePlace> photosAtOnePlace(std::span<const PhotoPrior> photos,
                                       std::span<const PairEstimate> estimates);

} // namespace spherewalk::align
