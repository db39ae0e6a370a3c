// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report_parts.h"

#include "spherewalk/jobs/compare_robot.h"

#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A line a picture, and the means; before and after in one cell.
sheet::Table compareTable(const CompareReport& report);

/// What is to be said besides, a sentence each: poses that were refused, and the colour correction.
std::vector<std::string> compareSentences(const CompareReport& report);

} // namespace spherewalk::jobs
