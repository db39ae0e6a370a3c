// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace spherewalk {

/// The small seam to the file system: whole files in, durable files out, every failure a sentence that names
/// the file. Errors of all functions: NotFound, Exists, Io, Full (disk or quota), InvalidInput.

/// All bytes of a file. A file larger than maxBytes is refused as Corrupt before it is read.
Bytes readFile(const std::filesystem::path& file, std::uint64_t maxBytes = UINT64_MAX);

/// The same as text.
std::string readTextFile(const std::filesystem::path& file, std::uint64_t maxBytes = UINT64_MAX);

/// The file's bytes in order, in pieces of up to a megabyte.
void readFileInPieces(const std::filesystem::path& file, const std::function<void(ByteView)>& take);

/// A file that is written under a temporary name beside its final one, and appears there only by commit(),
/// complete and synced. Dropped uncommitted, it leaves nothing behind.
class DurableFile {
  public:
    enum class Overwrite { No, Yes };

    explicit DurableFile(std::filesystem::path finalName);
    ~DurableFile();
    DurableFile(const DurableFile&) = delete;
    DurableFile& operator=(const DurableFile&) = delete;

    const std::filesystem::path& temporaryName() const { return m_temporaryName; }

    std::uint64_t sizeBytes() const { return m_sizeBytes; }

    void write(ByteView bytes);
    /// Syncs the bytes, moves the file to its final name, and syncs the folder. Overwrite::No refuses with
    /// Exists, atomically, if the final name has been taken meanwhile.
    void commit(Overwrite overwrite = Overwrite::No);

  private:
    std::filesystem::path m_finalName;
    std::filesystem::path m_temporaryName;
    int m_descriptor = -1;
    std::uint64_t m_sizeBytes = 0;
};

/// Writes the whole file durably; see DurableFile.
void writeFile(const std::filesystem::path& file, ByteView bytes,
               DurableFile::Overwrite overwrite = DurableFile::Overwrite::Yes);

/// Makes the folder, and those above it, unless they are there. Errors: Io.
void ensureFolder(const std::filesystem::path& folder);

/// Makes a rename or a new file in this folder survive a power cut.
void syncFolder(const std::filesystem::path& folder);

/// True for a name that a file from outside may use for a path inside its own folder: relative, UTF-8 without
/// control characters or backslashes, not empty, and without "." or ".." parts.
bool isSafeRelativePath(std::string_view name);

} // namespace spherewalk
