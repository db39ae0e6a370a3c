// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_time.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::practice {

/// A photo on the camera.
struct StoredFile {
    std::string name;
    std::uint64_t sizeBytes = 0;
    int width = 0;
    int height = 0;
    ZonedTime time;
};

/// The practice camera's memory: a folder on the disk that outlives it. Threads: one at a time.
class CameraStorage {
  public:
    /// folder: empty for a temporary one, removed at the end. Errors: Io, Corrupt.
    CameraStorage(std::filesystem::path folder, std::uint64_t seed);
    CameraStorage(const CameraStorage&) = delete;
    CameraStorage& operator=(const CameraStorage&) = delete;

    const std::filesystem::path& folder() const { return m_folder; }

    /// "/files/<id>/", with which the path of every file's URL begins.
    const std::string& urlFolder() const { return m_urlFolder; }

    int nextShotNumber() const { return m_nextShot; }

    /// The number of the next shot, never given again, not even after a restart.
    int takeShotNumber();
    std::string fileName(int shot) const;
    /// Deletes all, and gives the names again from the first, as a reset of the camera's counter does.
    void restartNames();
    std::string urlPath(const std::string& name) const;
    /// "100RICOH/R0010001.JPG", by which API level 1 names it.
    static std::string uri(const std::string& name);

    void add(const std::string& name, ByteView bytes, const ZonedTime& time);
    void remove(const std::string& name);

    /// Oldest first.
    const std::vector<StoredFile>& files() const { return m_files; }

    std::uint64_t usedBytes() const;
    /// The file of a URL or its path, whatever its host.
    std::optional<StoredFile> find(std::string_view url) const;
    std::filesystem::path path(const std::string& name) const;

  private:
    void load();
    void save() const;

    std::filesystem::path m_folder;
    std::optional<TemporaryFolder> m_temporary;
    std::string m_id;
    std::string m_urlFolder;
    int m_nextShot = 1;
    int m_namedFrom = 0; ///< the last shot before the names began anew
    std::vector<StoredFile> m_files;
};

} // namespace spherewalk::practice
