// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "device/osc_protocol.h"
#include "photo/camera_time.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/folder.h"

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

/// The practice camera's memory, a folder on the disk. Threads: one at a time.
class CameraStorage {
  public:
    /// folder: empty for a temporary folder, which the destructor removes. Errors: Io; Corrupt for a damaged
    /// record.
    CameraStorage(std::filesystem::path folder, std::uint64_t seed);
    CameraStorage(const CameraStorage&) = delete;
    CameraStorage& operator=(const CameraStorage&) = delete;

    const std::filesystem::path& folder() const { return m_folder; }

    /// "/files/<id>/", the beginning of the path of each file's URL.
    const std::string& urlFolder() const { return m_urlFolder; }

    int nextShotNumber() const { return m_nextShot; }

    /// Takes the number of the next shot. No number comes twice, not even after a restart.
    int takeShotNumber();
    std::string fileName(int shot) const;
    /// Deletes all files, and gives their names again, as a reset of the camera's counter does.
    void restartNames();
    std::string urlPath(const std::string& name) const;
    /// "100RICOH/R0010001.JPG", the name of a file at API level 1.
    static std::string uri(const std::string& name);

    /// Stores a file. Errors: Exists, Io, Full.
    void add(const std::string& name, ByteView bytes, const ZonedTime& time);
    /// Errors: Io.
    void remove(const std::string& name);

    /// Oldest first.
    const std::vector<StoredFile>& files() const { return m_files; }

    std::uint64_t usedBytes() const;
    /// The file of a URL with any host, or of its path. Returns nothing if there is no such file.
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
    int m_namedFrom = 0; ///< The last shot before the names began again.
    std::vector<StoredFile> m_files;
};

// The commands about files. Errors: OscError for parameters that the API refuses.

/// The results of camera.listFiles. baseUrl: "http://host:port", with which file URLs begin.
Json listedFiles(const CameraStorage& storage, const Json& parameters, const std::string& baseUrl);
/// The results of camera.listImages of API level 1.
Json listedImages(const CameraStorage& storage, const Json& parameters);
/// Does camera.delete: it deletes all named files, or none.
void deleteFiles(CameraStorage& storage, const Json& parameters);

} // namespace spherewalk::practice
