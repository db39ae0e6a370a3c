// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"

#include <filesystem>
#include <string>
#include <vector>

namespace spherewalk::campaign {

/// What the camera's own truth says of a survey at the end.
struct Findings {
    int photos = 0;
    int exposures = 0; ///< that the program asked for
    int buttonPictures = 0;
    int toldShots = 0;                   ///< of which the operator has been told that they need a look
    std::vector<std::string> violations; ///< sentences
};

/// Compares the survey with the truth: no stored photo lost, none at another station than its own, none with
/// another exposure than the profile's, no second exposure that the operator was not told of. said: all that
/// the programs have said.
Findings examine(const std::filesystem::path& survey, const std::filesystem::path& truthFile,
                 const Json& exposure, const std::string& said);

} // namespace spherewalk::campaign
