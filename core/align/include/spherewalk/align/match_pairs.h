// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::align {

struct NeighbourOptions {
    int directions = 8;     ///< A photo is paired with the nearest in each of so many directions, [1, 64].
    int farDirections = 0;  ///< It is also paired with a farther one in so many directions, [0, 64].
    int mostAtOnePlace = 4; ///< It is paired with so many photos of its own place, [1, 1000].
    /// Pairs are no longer than this, except those that connect components. Photos much farther apart than
    /// the room is wide have little in common.
    double mostDistanceM = 2.5;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// The pairs of photos to compare: each pair once, a < b, sorted. Distances are measured across the floor;
/// heights are ignored. Photos within a centimetre are of one place. Components without a connection get the
/// shortest pairs that connect them. Errors: InvalidInput for positions that are not finite. Cost: grows with
/// the square of the number of photos; half a second for 5000.
std::vector<std::pair<int, int>> neighbours(std::span<const Eigen::Vector3d> positionsM,
                                            const NeighbourOptions& options = {});

/// The neighbours that are worth another look: the pairs of neighbours() whose photos these estimates leave
/// in different parts of the survey. Photos that no estimate joins to any other are parts of their own. A
/// pair of less than 20 inliers joins nothing unless a triangle confirms it, since a single wrong pair would
/// join two rooms. Errors: those of neighbours(); InvalidInput for an estimate of photos that do not exist.
std::vector<std::pair<int, int>> neighboursApart(std::span<const Eigen::Vector3d> positionsM,
                                                 std::span<const PairEstimate> estimates,
                                                 const NeighbourOptions& options = {});

/// The compared pairs that are worth a wide look (wideOptions()): those of photos that fewer than three pairs
/// hold with so many inliers or more. Each pair once, sorted. Range: estimates name photos below `photos`.
std::vector<std::pair<int, int>> loosePairs(int photos, std::span<const PairEstimate> estimates,
                                            int strongInliers);

struct MatchOptions {
    double mostRatio = 0.8;      ///< Largest ratio of the best to the second best distance, (0, 1].
    Radians reach = Degrees(30); ///< How far a thing may move between two photos that are turned alike.
    bool isGuided = true;        ///< Compares only what lies within reach, once the rotation is known.
    int firstLook = 400;         ///< Features of each photo that the rotation is sought with, [50, 50000].
    int leastVotes = 12;         ///< Matches of the first look that must agree on the rotation.

    bool operator==(const MatchOptions&) const = default;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// A rotation that many matches of two photos agree on up to their parallax. It is good to about 10 degrees.
struct CoarseRotation {
    Eigen::Quaterniond aFromB = Eigen::Quaterniond::Identity();
    int votes = 0;
    int rivalVotes = 0; ///< Votes of the best rotation that differs clearly.
};

/// The rotation that the strongest features of both photos agree on. Empty where too few agree, or where a
/// second rotation explains about as much, as in a room that looks alike to several sides. The same input
/// gives the same result.
std::optional<CoarseRotation> coarseRotation(const Features& a, const Features& b,
                                             const MatchOptions& options);

/// Features that are each other's nearest by descriptor, and clearly nearer than the second nearest. They
/// come in the order of a's features, each feature at most once. guess: a rotation to search around; without
/// it a coarse rotation is sought first. Errors: InvalidInput for features of different detectors. Threads:
/// any. Cost: 20 ms for 2000 features each.
std::vector<Correspondence> matchFeatures(const Features& a, const Features& b, const MatchOptions& options,
                                          const std::optional<Eigen::Quaterniond>& guess = {});

/// The matches of each pair, in the order of the pairs. Range: pairs hold indices into photos, the first less
/// than the second. Errors: InvalidInput; Stopped. Stop: heard at each pair. Threads: the result is the same
/// for any number; 0 means all that the machine has.
std::vector<PhotoPair> matchPairs(std::span<const Features> photos,
                                  std::span<const std::pair<int, int>> pairs, const MatchOptions& options,
                                  int threads, ProgressSink& progress, const std::stop_token& stop);

/// Makes pairs that were matched in another look name photos and features as all looks do. Then pairs of
/// different looks share things. looked: the features that this look found in `photos`, in their order;
/// photos: indices, ascending; known: the bearings of all features of each photo so far, by number. A feature
/// that lies where a known one does gets its number; others get new ones, and their bearings are added.
void renumber(std::span<const Features> looked, std::span<const int> photos, int look,
              std::vector<std::vector<Eigen::Vector3f>>& known, std::span<PhotoPair> pairs);

/// How much work goes into the pictures: 0.1, 0.5, 1.5 and 3.5 s of one core a photo, matching included.
enum class Effort {
    Draft,  ///< A first look: headings to a few tenths of a degree.
    Normal, ///< The choice for every day.
    Fine,   ///< Uses more of the picture.
    Exact,  ///< Uses all that the pictures give.
};

/// The effort as options and reports spell it: "draft", "normal", "fine", "exact".
std::string_view name(Effort effort);

/// Errors: InvalidInput, listing the names.
Effort effortNamed(std::string_view name);

struct EffortOptions {
    FeatureOptions features;
    MatchOptions match;
    NeighbourOptions neighbours;
    PairOptions pair; ///< Without what is known of the photos.
};

/// The options of all steps that an effort stands for.
EffortOptions optionsFor(Effort effort);

/// The options of a wide look, at photos that share little: things are described as they look from aslant,
/// too, and may lie anywhere in the other photo.
EffortOptions wideOptions();

} // namespace spherewalk::align
