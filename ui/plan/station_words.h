// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/records.h"
#include "spherewalk/survey/marking.h"

#include <QString>

namespace spherewalk::ui {

/// "Rail 3, stop 5", in the user's language; the station's own name where it lies on no rail.
QString stationWords(const store::StationRecord& station, const survey::PlanOptions& options);
/// Where the lens is to be: "x 1.20 m, y 0.80 m, lens at 1.20 m".
QString positionWords(const survey::Station& station);
/// How the rail is laid, with tape distances.
QString railWords(const survey::RailMark& rail);

} // namespace spherewalk::ui
