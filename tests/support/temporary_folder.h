// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace spherewalk::test {

/// A new empty folder, removed with all that is in it at the end of the scope.
class TemporaryFolder {
  public:
    TemporaryFolder() : TemporaryFolder(std::filesystem::temp_directory_path()) {}

    explicit TemporaryFolder(const std::filesystem::path& parent) {
        std::string pattern = (parent / "spherewalk-test-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error("mkdtemp failed");
        }
        m_path = pattern;
    }

    ~TemporaryFolder() {
        if (beforeRemoval != nullptr && m_isChecked) {
            beforeRemoval(m_path);
        }
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Does not throw. A test program may set it to look at what its tests leave.
    static inline void (*beforeRemoval)(const std::filesystem::path&) = nullptr;

    /// Says that what lies in the folder at the end is wrong on purpose.
    void leaveUnchecked() { m_isChecked = false; }

    const std::filesystem::path& path() const { return m_path; }

    std::filesystem::path operator/(const std::filesystem::path& name) const { return m_path / name; }

  private:
    std::filesystem::path m_path;
    bool m_isChecked = true;
};

} // namespace spherewalk::test
