// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>

namespace spherewalk::ui {

/// A duration as people say it, in the user's language: "45 s", "18 min", "2 h 17 min".
QString durationText(std::chrono::duration<double> duration);

} // namespace spherewalk::ui
