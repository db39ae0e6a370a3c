// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// One record of a CSV file.
struct CsvLine {
    int number = 0; ///< Number of the record's first line in the file, counted from 1.
    std::vector<std::string> fields;
};

/// The records of a CSV file (RFC 4180). Fields may be quoted, and a quote in a quoted field is doubled.
/// Lines end with CR LF or LF. Blank lines are left out, and unquoted fields lose the blanks around them. A
/// byte order mark is ignored. Errors: InvalidInput for a quote that is never closed.
std::vector<CsvLine> parseCsv(std::string_view csv, const std::string& source);

/// The field as parseCsv() reads it back. It is quoted if it holds a comma, a quote or a line break.
std::string csvField(std::string_view words);

} // namespace spherewalk::jobs
