// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace spherewalk::measure {

/// Rows of cells for a screen: the first columns flush left, the others flush right, as wide as they need.
class TextTable {
  public:
    explicit TextTable(std::size_t leftColumns = 1) : m_leftColumns(leftColumns) {}

    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }

    /// Each row indented, with its end of line.
    std::string text() const;

  private:
    std::size_t m_leftColumns;
    std::vector<std::vector<std::string>> m_rows;
};

} // namespace spherewalk::measure
