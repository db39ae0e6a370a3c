// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace spherewalk {

/// A new, empty folder where the system keeps temporary files, removed with all that is in it at the end.
class TemporaryFolder {
  public:
    /// name: its beginning, so that people know whose it is. Errors: Io, naming TMPDIR.
    explicit TemporaryFolder(std::string_view name);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }

  private:
    std::filesystem::path m_path;
};

} // namespace spherewalk
