// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/csv.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <utility>

namespace spherewalk::jobs {

namespace {

std::string trimmed(const std::string& field) {
    const std::size_t begin = field.find_first_not_of(" \t");
    return begin == std::string::npos ? "" : field.substr(begin, field.find_last_not_of(" \t") - begin + 1);
}

/// Takes one character after the other and collects records.
class Reader {
  public:
    void take(char c) {
        if (m_inQuotes) {
            takeQuoted(c);
        } else if (c == '"' && (m_wasQuoted || trimmed(m_field).empty())) {
            // Either the field's first quote, or the second of a doubled one.
            m_field = m_wasQuoted ? m_field + '"' : "";
            m_inQuotes = true;
        } else if (c == ',') {
            endField();
        } else if (c == '\n') {
            endLine();
            ++m_number;
        } else if (c != '\r') {
            m_field += c;
        }
    }

    std::vector<CsvLine> finish(const std::string& source) {
        if (m_inQuotes) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not read ", source, ": a quote that opens in line ", m_line.number,
                             " is never closed."));
        }
        endLine();
        return std::move(m_lines);
    }

  private:
    void takeQuoted(char c) {
        if (c == '"') {
            m_inQuotes = false;
            m_wasQuoted = true;
            return;
        }
        m_number += c == '\n' ? 1 : 0;
        m_field += c;
    }

    void endField() {
        m_line.fields.push_back(m_wasQuoted ? m_field : trimmed(m_field));
        m_field.clear();
        m_wasQuoted = false;
    }

    void endLine() {
        const bool blank = m_line.fields.empty() && !m_wasQuoted && trimmed(m_field).empty();
        endField();
        if (!blank) {
            m_lines.push_back(m_line);
        }
        m_line = {m_number + 1, {}};
    }

    std::vector<CsvLine> m_lines;
    CsvLine m_line{1, {}};
    std::string m_field;
    int m_number = 1;
    bool m_inQuotes = false;
    bool m_wasQuoted = false;
};

} // namespace

std::vector<CsvLine> parseCsv(std::string_view csv, const std::string& source) {
    if (csv.starts_with("\xef\xbb\xbf")) { // the byte order mark that spreadsheets write
        csv.remove_prefix(3);
    }
    Reader reader;
    for (const char c : csv) {
        reader.take(c);
    }
    return reader.finish(source);
}

std::string csvField(std::string_view words) {
    if (words.find_first_of(",\"\r\n") == std::string_view::npos) {
        return std::string(words);
    }
    std::string quoted = "\"";
    for (const char letter : words) {
        quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return quoted + "\"";
}

} // namespace spherewalk::jobs
