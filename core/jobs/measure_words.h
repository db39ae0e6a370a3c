// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report_parts.h"

#include "spherewalk/jobs/measure_report.h"

#include <string>
#include <vector>

namespace spherewalk::jobs {

/// What was compared with what.
std::string subjectWords(const MeasureReport& report);

/// A line a scene model.
sheet::Table sceneTable(const MeasureReport& report);

/// A line a scene model and sampling: time and error.
sheet::Table rungTable(const MeasureReport& report);

/// After words for choiceTable(): on what it rests, if that needs to be said.
std::string choiceBasis(const MeasureReport& report);

/// A line a tolerance. With a robot's pictures: what leaving photos out chooses, and what the pictures say of
/// that.
sheet::Table choiceTable(const MeasureReport& report);

/// Sentences, one a scene model.
std::vector<std::string> predictionWords(const MeasureReport& report);

} // namespace spherewalk::jobs
