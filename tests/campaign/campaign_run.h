// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verdicts.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace spherewalk::campaign {

/// The fault that a person carries the cart on and presses the button while nobody knows whether a shot was
/// taken.
constexpr const char* kButtonInDoubt = "button while a shot is in doubt";

struct RunOptions {
    std::string cli;
    std::filesystem::path templateSurvey; ///< copied for each run
    unsigned seed = 0;
    std::filesystem::path keepIn; ///< where what a run leaves is kept that broke a rule; nowhere if empty
};

struct RunReport {
    unsigned seed = 0;
    std::map<std::string, int> faults; ///< armed, by name
    std::map<std::string, int> deeds;  ///< what people did, by name
    int programs = 0;
    int kills = 0;
    int powerCycles = 0;
    std::vector<double> stopSeconds; ///< from Ctrl-C to the program's end
    Findings findings;
};

/// One survey, from the first photo to the last, with everything going wrong that the seed says.
RunReport run(const RunOptions& options);

} // namespace spherewalk::campaign
