// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/unknowns.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// Which matches show one thing: features joined by matches, over all photos, are one track.
/// Shape: as the pairs and their matches. isUsed: of the same shape; the others join nothing and get a track
/// of their own, as those whose features have no index.
std::vector<std::vector<int>> tracks(std::span<const PhotoPair> pairs,
                                     std::span<const std::vector<bool>> isUsed);

/// Whether this share of the tracks holds this one. The same for any other tracks.
bool isHeldOut(int track, double share);

/// The pairs of one component, and what is known of all matches.
struct Candidates {
    std::span<const PhotoPair> pairs;         ///< All pairs.
    std::span<const PairEstimate> estimates;  ///< One a pair.
    std::span<const std::vector<int>> tracks; ///< One list a pair, one entry a match.
    std::vector<int> chosen;                  ///< Indices of the component's pairs.
    std::vector<int> indexOf;                 ///< The place of each photo within the component.
    std::span<const double> noise;            ///< photoNoise(), one a photo.
    /// Whether places are solved along from the start. Then two photos that may stand at one place by their
    /// tags have a baseline still, if their matches show one.
    bool solvesPlaces = false;
};

/// How far each photo's bearings scatter beyond what their features state, at least 1 and against the usual
/// photo. A blurred photo has more. The pairs' own fits tell it, so no wrong position can: the variance of a
/// pair is the mean of its two photos', and most pairs of a photo say the same.
std::vector<double> photoNoise(std::size_t photos, std::span<const PhotoPair> pairs,
                               std::span<const PairEstimate> estimates);

/// Which matches are wanted.
struct Selection {
    int mostAPair = 250; ///< Spread evenly over the directions.
    double heldOutShare = 0;
    bool wantsHeldOut = false; ///< Whether the held-out matches alone are wanted, or all others.
    int threads = 0;
};

/// The pairs' inliers by their estimates, without those that lie behind the photos.
std::vector<UsedPair> estimatedMatches(const Candidates& candidates, const Unknowns& unknowns,
                                       std::span<const PhotoPrior> priors, const Selection& selection);

/// The matches that agree with the photos' present poses, whatever the estimates said: in one plane with the
/// baseline and in front. scale: of the residuals.
std::vector<UsedPair> agreeingMatches(const Candidates& candidates, const Unknowns& unknowns,
                                      std::span<const PhotoPrior> priors, double scale,
                                      const Selection& selection);

/// The scale of the residuals of these matches at these poses: 1 if the matches' sigmas are right.
double residualScale(std::span<const UsedPair> pairs, std::span<const PhotoState> states);

/// How a match fits the poses of its photos.
enum class Judgement {
    Agrees,
    AlongBaseline, ///< It says nothing.
    OutOfPlane,
    Behind,
};

Judgement judge(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
                double scale);

/// The pair without its matches. It is a turn alone where the photos stand too close.
UsedPair emptyPair(const Candidates& candidates, const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                   int pair);

/// Writes the match as it is used. Returns false for a match whose bearings are no directions.
bool usedMatch(const Candidates& candidates, int pair, int match, UsedMatch& into);

} // namespace spherewalk::align
