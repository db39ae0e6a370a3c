// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/shard.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace spherewalk::jobs {

/// What is known of a frame that was rendered, as lines of CSV without its name.
struct FrameLines {
    std::string what;  ///< the same in every run
    std::string times; ///< how long it took, and what it was made of meanwhile
};

/// Frames of a walk that are there, told by files beside them, one of each part: so that a run that was
/// stopped goes on, and parts that were rendered by other processes count. Files of other walks, and lines
/// that were cut off, are left out.
class WalkJournal {
  public:
    /// key: of all that the frames depend on. Errors: those of reading files and of making the folder.
    WalkJournal(const std::filesystem::path& folder, const std::string& key, const Shard& shard);

    const std::map<std::size_t, FrameLines>& frames() const { return m_frames; }

    /// Reads what other processes have added since.
    void refresh();

    /// Errors: Io, Full.
    void add(std::size_t frame, const FrameLines& lines);

  private:
    void read(const std::filesystem::path& file);

    std::string m_prefix; ///< of the names of this walk's files
    std::filesystem::path m_file;
    std::ofstream m_out;
    std::map<std::size_t, FrameLines> m_frames;
};

} // namespace spherewalk::jobs
