// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace spherewalk::align {

using Box = Eigen::AlignedBox3d;

struct FurnishedOptions {
    int rows = 5; ///< stations along x and along y
    int columns = 5;
    double stepM = 0.2;
    double neighboursM = 0.42; ///< so far apart photos are compared
    double positionSigmaM = 0; ///< of the poses given, off the true ones
    int pointsOnWalls = 3000;
    double pointsPerM2 = 120; ///< on furniture
};

/// Photos of a room with boxes for furniture, which hide what lies behind them; each photo may be taken while
/// the chair stands elsewhere. Matches are simulated: things that both photos show, found with some luck, and
/// wrong ones; inliers are those that fit the epipolar geometry of the poses.
class FurnishedSurvey {
  public:
    FurnishedSurvey(const FurnishedOptions& options, spherewalk::test::Random& random);

    /// Where the chair stood when each photo was taken; nothing: it was carried out.
    std::vector<std::optional<Eigen::Vector3d>> chairAtM;

    /// Makes the pictures' matches.
    void expose(spherewalk::test::Random& random);

    std::vector<std::optional<Rigid3>> roomFromPhoto;
    std::vector<PhotoPair> pairs;
    std::vector<std::vector<bool>> isInlier;

    static Eigen::Vector3d chairM() { return {2.9, 1.6, 0.9}; }

  private:
    struct Seen {
        int thing = 0; ///< index among the points; the chair's come last
        Eigen::Vector3d bearing;
    };

    std::vector<Seen> seenBy(int photo, spherewalk::test::Random& random) const;
    void match(int a, int b, const std::vector<std::vector<Seen>>& seen, spherewalk::test::Random& random);
    bool fits(int a, int b, const Correspondence& match) const;

    double m_neighboursM;
    std::vector<Rigid3> m_truth;
    std::vector<Eigen::Vector3d> m_pointsM;
    std::vector<Eigen::Vector3d> m_chairPointsM; ///< relative to the chair's middle
    std::vector<Box> m_boxes;
};

} // namespace spherewalk::align
