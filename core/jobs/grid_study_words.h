// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report_parts.h"

#include "spherewalk/jobs/grid_study.h"

namespace spherewalk::jobs {

/// What the answers come to, in sentences.
std::string gridStudyReason(const GridStudy& study);

/// A line a step and scene model.
sheet::Table gridTable(const GridStudy& study);

/// A line a scene model: the step that holds, its photos and minutes.
sheet::Table gridAnswerTable(const GridStudy& study);

} // namespace spherewalk::jobs
