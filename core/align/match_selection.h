// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unknowns.h"
#include "used_pair.h"

#include "spherewalk/align/pair_estimate.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// The pairs of one component and what is known of all their matches.
struct Candidates {
    std::span<const PhotoPair> pairs;         ///< all
    std::span<const PairEstimate> estimates;  ///< one a pair
    std::span<const std::vector<int>> tracks; ///< one a match
    std::vector<int> chosen;                  ///< the component's pairs
    std::vector<int> indexOf;                 ///< a photo's place within the component
};

/// Which matches are wanted.
struct Selection {
    int mostAPair = 250; ///< spread evenly over the directions
    double heldOutShare = 0;
    bool wantsHeldOut = false; ///< the held out ones alone, instead of all others
    int threads = 0;
};

/// The pairs' inliers as the estimates name them, those that lie behind left out.
std::vector<UsedPair> estimatedMatches(const Candidates& candidates, const Unknowns& unknowns,
                                       std::span<const PhotoPrior> priors, const Selection& selection);

/// The matches that agree with where the photos are, whatever the estimates said: in one plane with the
/// baseline and in front. scale: of the residuals.
std::vector<UsedPair> agreeingMatches(const Candidates& candidates, const Unknowns& unknowns,
                                      std::span<const PhotoPrior> priors, double scale,
                                      const Selection& selection);

/// The residuals' scale over these matches, where the photos are now.
double residualScale(std::span<const UsedPair> pairs, std::span<const PhotoState> states);

/// A match against where its photos are.
enum class Judgement {
    Agrees,
    AlongBaseline, ///< says nothing
    OutOfPlane,
    Behind,
};

Judgement judge(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
                double scale);

/// The pair without matches, as it will be solved: a turn alone where the photos stand too close.
UsedPair emptyPair(const Candidates& candidates, const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                   int pair);

/// The match as it is used; nothing but unit vectors and a sensible sigma. Range: usable matches.
bool usedMatch(const Candidates& candidates, int pair, int match, UsedMatch& into);

} // namespace spherewalk::align
