// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure_words.h"

#include "spherewalk/jobs/grid_study.h"

namespace spherewalk::jobs {

/// What the answers come to, in sentences.
std::string gridStudyReason(const GridStudy& study);

/// A line a step and scene model.
WordTable gridTable(const GridStudy& study);

/// A line a scene model: the step that holds, its photos and minutes.
WordTable gridAnswerTable(const GridStudy& study);

} // namespace spherewalk::jobs
