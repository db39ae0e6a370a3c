// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_text.h"

#include "spherewalk/base/text.h"

namespace spherewalk::photo {

std::string plainText(std::string_view foreign) {
    constexpr std::string_view kBlanks = " \t\r\n";
    constexpr std::size_t kMaxBytes = 200;
    foreign = foreign.substr(0, foreign.find('\0'));
    const std::size_t first = foreign.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return printable(foreign.substr(first, foreign.find_last_not_of(kBlanks) - first + 1), kMaxBytes);
}

} // namespace spherewalk::photo
