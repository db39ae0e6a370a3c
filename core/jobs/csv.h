// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

struct CsvLine {
    int number = 0; ///< of its first line in the file, from 1
    std::vector<std::string> fields;
};

/// The records of a CSV (RFC 4180: fields may be quoted, quotes are doubled; CR LF or LF), blank lines left
/// out and blanks around unquoted fields removed. Errors: InvalidInput for a quote that is not closed.
std::vector<CsvLine> parseCsv(std::string_view csv, const std::string& source);

/// A field as parseCsv() reads it back, quoted if it has to be.
std::string csvField(std::string_view words);

} // namespace spherewalk::jobs
