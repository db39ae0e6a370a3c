// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace spherewalk::ui {

/// A word of a page for browsers, or what core says of photos, in the window's language. Threads: any.
std::string pageWord(const std::string& english);

} // namespace spherewalk::ui
