// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace spherewalk::practice {

/// As 32 hexadecimal digits. For HTTP digest authentication only, which asks for it. Source: RFC 1321.
std::string md5Hex(std::string_view text);

} // namespace spherewalk::practice
