// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/marking.h"

#include <QString>

#include <string>

namespace spherewalk::ui {

/// "Rail 3, stop 5", in the user's language, for a station that the plan has named; other names as they are.
QString stationWords(const std::string& name);
/// Where the lens is to be: "x 1.20 m, y 0.80 m, lens at 1.20 m".
QString positionWords(const survey::Station& station);
/// How the rail is laid, with tape distances.
QString railWords(const survey::RailMark& rail);

} // namespace spherewalk::ui
