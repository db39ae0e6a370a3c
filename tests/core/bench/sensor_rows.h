// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace spherewalk::test {

/// The rows of frames that a sensor takes.
inline std::set<std::string> sensorRows() {
    std::set<std::string> rows;
    for (const char* effect :
         {"all", "defocus", "exposure", "jpeg", "motion_blur", "noise", "rolling_shutter", "vignetting"}) {
        rows.insert(std::string("view.with_sensor.") + effect);
    }
    return rows;
}

} // namespace spherewalk::test
