// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk_journal.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <sstream>
#include <vector>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr char kBetween = '\t'; ///< in no file name that a dataset has
constexpr std::string_view kEnd = "end";

} // namespace

WalkJournal::WalkJournal(const fs::path& folder, const std::string& key, const Shard& shard)
    : m_prefix(key.substr(0, 16)),
      m_file(folder / "parts" / text(m_prefix, ".", shard.index + 1, "-of-", shard.count, ".tsv")) {
    ensureFolder(m_file.parent_path());
    refresh();
    m_out.open(m_file, std::ios::app);
    m_out << '\n'; // after a line that was cut off
}

void WalkJournal::refresh() {
    for (const fs::directory_entry& entry : fs::directory_iterator(m_file.parent_path())) {
        if (entry.path().filename().string().starts_with(m_prefix)) {
            read(entry.path());
        }
    }
}

void WalkJournal::read(const fs::path& file) {
    std::istringstream all(readTextFile(file));
    for (std::string line; std::getline(all, line);) {
        std::vector<std::string> fields;
        std::istringstream rest(line);
        for (std::string field; std::getline(rest, field, kBetween);) {
            fields.push_back(field);
        }
        const auto frame = fields.size() == 4 && fields[3] == kEnd ? parseNumber(fields[0]) : std::nullopt;
        if (frame && *frame >= 0 && *frame < 1e15) {
            m_frames[static_cast<std::size_t>(*frame)] = {fields[1], fields[2]};
        }
    }
}

void WalkJournal::add(std::size_t frame, const FrameLines& lines) {
    m_out << frame << kBetween << lines.what << kBetween << lines.times << kBetween << kEnd << std::endl;
    if (!m_out) {
        throw Error(ErrorKind::Io, text("Could not write ", m_file.string(), "; is the disk full?"));
    }
    m_frames[frame] = lines;
}

} // namespace spherewalk::jobs
