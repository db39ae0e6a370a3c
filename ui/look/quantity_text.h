// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <cstdint>

namespace spherewalk::ui {

/// A duration as people say it, in the user's language: "45 s", "18 min", "2 h 17 min".
QString durationText(std::chrono::duration<double> duration);

/// A byte count as people say it, in powers of ten: "512 bytes", "4.2 MB".
QString bytesText(std::uint64_t bytes);

} // namespace spherewalk::ui
