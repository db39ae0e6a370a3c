// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace spherewalk::photo {

/// Foreign text up to its first NUL, without blanks around, printable, of at most 200 bytes.
std::string plainText(std::string_view foreign);

} // namespace spherewalk::photo
