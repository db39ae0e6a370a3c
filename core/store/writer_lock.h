// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace spherewalk::store {

/// Held as long as it lives, or until the program ends in whatever way: one survey has one writer. Source:
/// flock(2) on `writer.lock` in the survey's folder, which also names the holder's process.
class WriterLock {
  public:
    /// Errors: Busy, naming the process that holds it; Io, Full.
    explicit WriterLock(const std::filesystem::path& surveyFolder);
    ~WriterLock();
    WriterLock(const WriterLock&) = delete;
    WriterLock& operator=(const WriterLock&) = delete;

  private:
    int m_descriptor;
};

} // namespace spherewalk::store
