// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/measure_report.h"

#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A table as every form of the report shows it.
struct WordTable {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
};

/// For a screen.
std::string tableText(const WordTable& words, std::size_t leftColumns);

/// "-" if it is not known.
std::string optionalPx(const std::optional<double>& value);

/// What was compared with what.
std::string subjectWords(const MeasureReport& report);

/// A line a scene model.
WordTable sceneTable(const MeasureReport& report);

/// A line a scene model and sampling: time and error.
WordTable rungTable(const MeasureReport& report);

/// A line a tolerance. With a robot's pictures: what leaving photos out chooses, and what the pictures say of
/// that.
WordTable choiceTable(const MeasureReport& report);

/// Sentences, one a scene model.
std::vector<std::string> predictionWords(const MeasureReport& report);

} // namespace spherewalk::jobs
