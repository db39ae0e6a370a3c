// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/marking.h"

#include <QString>

#include <string>

namespace spherewalk::ui {

/// Returns "Rail 3, stop 5" in the user's language for a name that the plan gave. Other names are returned
/// unchanged.
QString stationWords(const std::string& name);
/// Says where the lens belongs: "x 1.20 m, y 0.80 m, lens at 1.20 m". Frames: room.
QString positionWords(const survey::Station& station);
/// Says how the rail is laid, with the tape distances of the marking-out sheet.
QString railWords(const survey::RailMark& rail, const survey::Room& room);

} // namespace spherewalk::ui
