// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/align_survey.h"

namespace spherewalk::jobs {

/// A rotation worse than this is told: three of it are about what a robot's camera of 640 pixels can see.
inline constexpr Radians kDoubtfulSigma = Degrees(0.15);

/// The part of the photos' tilts' uncertainty that they have in common: how far the whole may lean.
Radians commonLeanSigma(const align::Alignment& alignment);

/// Notes what helps the photo, unless something that should be tried first is noted already.
void propose(Cure cure, AlignedPhoto& photo);

/// Fills in the pose, the status, and the flags for what the pose itself makes doubtful.
void giveVerdict(const align::SolvedPose& pose, const align::Alignment& alignment, AlignedPhoto& photo);

} // namespace spherewalk::jobs
