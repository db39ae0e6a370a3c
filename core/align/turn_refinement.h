// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "epipolar_refinement.h"

#include <span>

namespace spherewalk::align {

/// Takes the baseline out of a fit where a turn alone explains what the baseline does: of two photos from
/// one place any baseline lies in one plane with everything. inside: the bearings that are judged.
void preferTurn(const Bearings& bearings, std::span<const int> inside, EpipolarFit& fit);

} // namespace spherewalk::align
