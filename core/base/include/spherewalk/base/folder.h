// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

namespace spherewalk {

/// Throws if there is already anything by this name, even a broken link.
/// `what` names the thing in the sentence, for example "the dataset". Errors: Exists.
void requireAbsent(const std::filesystem::path& folder, std::string_view what);

/// Makes a folder that is either complete or absent. The function `fill` gets a temporary path beside the
/// final one and writes everything there. When all of it is on the disk, the folder is renamed.
/// After an error nothing is left. A program that is killed leaves a folder that ends in ".part", which
/// the next call for the same folder removes.
/// Errors: Exists; Full and Io, also for filesystem errors of fill; all other errors of fill.
void makeFolder(const std::filesystem::path& folder, std::string_view what,
                const std::function<void(const std::filesystem::path&)>& fill);

/// A new, empty folder where the system keeps temporary files. The destructor removes it and its content.
/// What a program left that was killed is removed by the next one that makes a folder of the same name.
class TemporaryFolder {
  public:
    /// The folder's name begins with `name`, so that people know which program made it.
    /// Errors: Io, with a sentence that mentions TMPDIR.
    explicit TemporaryFolder(std::string_view name);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }

  private:
    std::shared_ptr<const void> m_lock; ///< Tells other programs that the folder is in use.
    std::filesystem::path m_path;
};

} // namespace spherewalk
