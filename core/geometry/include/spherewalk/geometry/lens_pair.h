// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace spherewalk {

/// The two lenses of a spherical camera. They look along the photo's +x and -x axis, and stand so far before
/// and behind its middle. A thing two metres away is seen 0.3 degrees aside by a lens one centimetre away.
/// Most cameras join both pictures as if the lenses stood in one place. 0: they do, or nobody knows.
/// Frames: the photo's. Units: metres.
struct LensPair {
    double aheadM = 0;

    /// 1 for the front lens and -1 for the back one, by the lens that a photo shows a direction with. Range:
    /// any length but 0. At the seam it is the front one.
    static double side(const Eigen::Vector3d& direction) { return direction.x() < 0 ? -1 : 1; }

    /// Where the lens stands that sees this direction.
    Eigen::Vector3d place(const Eigen::Vector3d& direction) const { return {side(direction) * aheadM, 0, 0}; }

    /// The direction in which the photo shows a point, not normalised. The point is given times `inverse`, so
    /// that it may be endlessly far. Between the two lenses, where neither looks, it is off by less than
    /// their distance.
    Eigen::Vector3d directionTo(const Eigen::Vector3d& pInPhoto, double inverse = 1) const {
        return pInPhoto - inverse * place(pInPhoto);
    }
};

} // namespace spherewalk
