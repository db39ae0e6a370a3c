// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "position_evidence.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace spherewalk::align {

/// The direction that is up for most photos of the part, in the part's frame: as photos say, or their own z.
Eigen::Vector3d upInPart(std::span<const PhotoPrior> photos, const RoughRotations& rotations, int part);

/// The ways in which the part may lie in the room so that many baselines point where the positions say, the
/// one with the most first. Where many photos stand wrongly the right one may be the second. Empty if no
/// baseline tells.
std::vector<Eigen::Quaterniond> likelyHeadings(const PositionEvidence& evidence, const Eigen::Vector3d& up);

/// roomFromPart, turned from where the evidence has it so that the baselines which fit about fit best.
Eigen::Quaterniond refinedHeading(const PositionEvidence& evidence, const Eigen::Vector3d& up);

} // namespace spherewalk::align
