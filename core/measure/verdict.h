// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/measure/bench_report.h"

#include <string>

namespace spherewalk::measure {

/// What the tables say, in a few plain sentences.
std::string verdict(const BenchReport& report);

} // namespace spherewalk::measure
