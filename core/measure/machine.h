// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/measure/bench_report.h"

#include <cstdint>
#include <stop_token>

namespace spherewalk::measure {

/// This machine and this build. Errors: Stopped. Cost: a tenth of a second, for twoThreadGain.
Machine thisMachine(const std::stop_token& stop);

/// The most memory that this program has had so far.
std::uint64_t peakResidentBytes();

} // namespace spherewalk::measure
