// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::test {

/// The first thing that makes XML or HTML malformed; "" for well-formed markup. Each tag must be closed in
/// its turn, and each ampersand must begin one of the four entities that the program writes.
inline std::string markupDefect(std::string_view markup) {
    constexpr std::array<std::string_view, 2> kNeverClosed{"meta", "img"};
    constexpr std::array<std::string_view, 4> kEntities{"&lt;", "&gt;", "&amp;", "&quot;"};
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = markup.find_first_of("<>&", at)) != std::string_view::npos; ++at) {
        const std::string_view rest = markup.substr(at);
        if (rest[0] == '&') {
            if (std::none_of(kEntities.begin(), kEntities.end(),
                             [&](std::string_view entity) { return rest.starts_with(entity); })) {
                return "bare ampersand in " + std::string(rest.substr(0, 30));
            }
            continue;
        }
        const std::size_t end = rest.find('>');
        if (rest[0] == '>' || end == std::string_view::npos || rest.find('<', 1) < end) {
            return "bare bracket in " + std::string(rest.substr(0, 30));
        }
        const std::string_view tag = rest.substr(1, end - 1);
        const std::string name(tag.substr(0, tag.find_first_of(" \n")));
        at += end;
        if (name.starts_with('/')) {
            if (open.empty() || open.back() != name.substr(1)) {
                return "<" + name + "> closes nothing";
            }
            open.pop_back();
        } else if (!tag.ends_with('/') && !name.starts_with('!') &&
                   std::find(kNeverClosed.begin(), kNeverClosed.end(), name) == kNeverClosed.end()) {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

} // namespace spherewalk::test
