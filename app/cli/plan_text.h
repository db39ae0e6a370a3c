// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/survey/plan_report.h"

#include <string>

namespace spherewalk::cli {

/// What a plan costs and leaves out, for people.
std::string planText(const survey::PlanReport& report, const survey::PlanOptions& options);

Json planJson(const survey::PlanReport& report, const survey::PlanOptions& options);

} // namespace spherewalk::cli
