// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/text_table.h"

#include <algorithm>

namespace spherewalk::measure {

namespace {

constexpr std::size_t kGap = 3;

std::string padding(std::size_t width, const std::string& cell) {
    return std::string(width - cell.size(), ' ');
}

} // namespace

std::string TextTable::text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : m_rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string result;
    for (const auto& row : m_rows) {
        std::string line = "  ";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blank = padding(widths[i], row[i]);
            line +=
                std::string(i == 0 ? 0 : kGap, ' ') + (i < m_leftColumns ? row[i] + blank : blank + row[i]);
        }
        result += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return result;
}

} // namespace spherewalk::measure
