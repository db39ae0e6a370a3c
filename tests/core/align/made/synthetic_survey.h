// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace spherewalk::align {

/// A survey that exists only as points on the walls, floor, ceiling and furniture of a room, and as what
/// photos would see of them.
struct SyntheticSurveyOptions {
    std::uint64_t seed = 1;
    int columns = 5;
    int rows = 5;
    double stepM = 0.2;
    int stopsARail = 6; ///< rails run along x; the last of a row may be shorter
    Eigen::Vector3d roomM = {5, 4, 2.6};
    Eigen::Vector3d originM = Eigen::Vector3d::Zero(); ///< the room's south-west corner on the floor
    double heightM = 1.2;
    int points = 3000;
    double lensAheadM = 0;  ///< LensPair::aheadM of the camera
    double seenShare = 0.5; ///< of the points that a photo finds
    bool isPlain = false;   ///< points on one wall alone

    double sigmaRad = Radians(Degrees(0.05)).value(); ///< of bearings
    Radians tiltSigma = Degrees(0.5);                 ///< true tilts; the priors say upright
    double positionSigmaM = 0.003; ///< of the true positions about the planned ones, along x and y
    double heightSigmaM = 0.001;   ///< of the true heights
    double placementSigmaM = 0;    ///< of a rail's x and y
    Radians placementSigma;        ///< of a rail's heading
    bool hasAnyYaw = true;         ///< false: small ones
    double wrongShare = 0.2;       ///< of a pair's matches: to random other points
    double repeatedShare = 0.05;   ///< of a pair's matches: to the next repetition on a wall

    double reachM = 0.65; ///< pairs of photos up to this far apart
    int mostMatches = 400;

    int blurredEvery = 0;  ///< of every so many photos the third is blurred; 0: none. Range: 0, or above 2
    double blurFactor = 4; ///< what a blurred photo's bearings err by; they state no more than others
};

struct SyntheticSurvey {
    std::vector<Rigid3> roomFromPhoto; ///< the truth
    std::vector<PhotoPrior> photos;
    std::vector<PhotoPair> pairs;
    std::vector<std::vector<bool>> isRight; ///< one a match: the truth
};

SyntheticSurvey syntheticSurvey(const SyntheticSurveyOptions& options);

/// The same photos with only the pairs that this predicate keeps.
template <class Predicate>
SyntheticSurvey withPairs(SyntheticSurvey survey, const Predicate& keeps) {
    SyntheticSurvey kept = survey;
    kept.pairs.clear();
    kept.isRight.clear();
    for (std::size_t i = 0; i < survey.pairs.size(); ++i) {
        if (keeps(survey.pairs[i])) {
            kept.pairs.push_back(survey.pairs[i]);
            kept.isRight.push_back(survey.isRight[i]);
        }
    }
    return kept;
}

/// One pair alone: a at the origin, b at the offset, turned as told; all else as the options say.
struct SyntheticPair {
    PhotoPair pair;
    Eigen::Quaterniond aFromB;
    Eigen::Vector3d baselineInA; ///< metres
};

SyntheticPair syntheticPair(const SyntheticSurveyOptions& options, const Eigen::Vector3d& offsetM,
                            const Eigen::Quaterniond& roomFromB);

} // namespace spherewalk::align
