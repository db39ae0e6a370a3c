// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace spherewalk::align {

struct MatchOptions {
    double mostRatio = 0.8;      ///< of the distances to the best and the second best candidate, (0, 1]
    Radians reach = Degrees(30); ///< how far a thing may move between two photos that are turned alike
    bool isGuided = true;        ///< compare only what lies within reach, if the photos' rotation is seen
    int firstLook = 400;         ///< features of each photo that the rotation is sought with, [50, 50000]
    int leastVotes = 12;         ///< matches of the first look that must agree on the rotation

    bool operator==(const MatchOptions&) const = default;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// A rotation that many matches of two photos agree on up to their parallax: good to about 10 degrees.
struct CoarseRotation {
    Eigen::Quaterniond aFromB = Eigen::Quaterniond::Identity();
    int votes = 0;
    int rivalVotes = 0; ///< of the best rotation that is another one
};

/// From the strongest features of each; nothing where too few agree or a second rotation explains about as
/// much, as in a room that looks alike to several sides. The same input gives the same result.
std::optional<CoarseRotation> coarseRotation(const Features& a, const Features& b,
                                             const MatchOptions& options);

/// Features that are each other's nearest by descriptor and clearly nearer than the second nearest, in the
/// order of a's features; each place at most once. guess: of the rotation, searched around instead of a first
/// look. Errors: InvalidInput for features of different detectors. Threads: any. Cost: 20 ms for 2000
/// features each.
std::vector<Correspondence> matchFeatures(const Features& a, const Features& b, const MatchOptions& options,
                                          const std::optional<Eigen::Quaterniond>& guess = {});

} // namespace spherewalk::align
