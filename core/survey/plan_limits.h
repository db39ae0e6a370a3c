// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

namespace spherewalk::survey {

/// Errors: InvalidInput, with a step that fits, if so many stops make more than kMostStations.
void refuseTooMany(int stops, const PlanOptions& options);

} // namespace spherewalk::survey
