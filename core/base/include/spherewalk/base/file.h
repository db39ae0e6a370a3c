// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace spherewalk {

/// Files are read whole, in pieces, or by parts, and they are written durably. Every error is a sentence that
/// names the file. Errors of all functions: NotFound, Exists, Io, Full (disk or quota), InvalidInput.

/// All bytes of a regular file. Errors: also Corrupt, before anything is read, for more than maxBytes.
Bytes readFile(const std::filesystem::path& file, std::uint64_t maxBytes = UINT64_MAX);

/// All bytes of a regular file as text. Errors: those of readFile().
std::string readTextFile(const std::filesystem::path& file, std::uint64_t maxBytes = UINT64_MAX);

/// Calls `take` with the file's bytes in order, in pieces of up to one megabyte.
void readFileInPieces(const std::filesystem::path& file, const std::function<void(ByteView)>& take);

/// Bytes that are read by parts, from memory or from a file. Threads: const functions, any number at a time.
class ByteSource {
  public:
    virtual ~ByteSource() = default;

    /// The size that the source had when it was opened.
    virtual std::uint64_t sizeBytes() const = 0;
    /// Fills all of `into` with the bytes from `offset` on. Errors: Corrupt if the source ends earlier; Io.
    virtual void read(std::uint64_t offset, std::span<std::uint8_t> into) const = 0;
    /// The name of the source in sentences.
    virtual const std::string& name() const = 0;
};

/// A source in memory. Owner: the bytes must outlive the source.
class MemorySource : public ByteSource {
  public:
    MemorySource(ByteView bytes, std::string name) : m_bytes(bytes), m_name(std::move(name)) {}

    std::uint64_t sizeBytes() const override { return m_bytes.size(); }

    void read(std::uint64_t offset, std::span<std::uint8_t> into) const override;

    const std::string& name() const override { return m_name; }

  private:
    ByteView m_bytes;
    std::string m_name;
};

/// An open file, which is read and not mapped. A file that is cut while it is in use therefore gives an
/// Error, and not a signal that ends the program.
class FileSource : public ByteSource {
  public:
    /// Errors: NotFound, Io; InvalidInput for anything but a regular file.
    explicit FileSource(const std::filesystem::path& file);
    ~FileSource() override;
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;

    std::uint64_t sizeBytes() const override { return m_sizeBytes; }

    void read(std::uint64_t offset, std::span<std::uint8_t> into) const override;

    const std::string& name() const override { return m_name; }

    /// Asks the system to read the whole file in the background, so that many small reads wait for the disk
    /// only once. The call returns at once, and never fails.
    void fetchAhead() const;

  private:
    std::string m_name;
    int m_descriptor = -1;
    std::uint64_t m_sizeBytes = 0;
};

/// A file that is written under a temporary name beside its final one. commit() makes it appear there,
/// complete and synced. Without commit() the destructor removes it.
class DurableFile {
  public:
    enum class Overwrite { No, Yes };

    explicit DurableFile(std::filesystem::path finalName);
    ~DurableFile();
    DurableFile(const DurableFile&) = delete;
    DurableFile& operator=(const DurableFile&) = delete;

    const std::filesystem::path& temporaryName() const { return m_temporaryName; }

    /// The bytes that were written so far.
    std::uint64_t sizeBytes() const { return m_sizeBytes; }

    /// Appends the bytes.
    void write(ByteView bytes);
    /// Syncs the bytes, moves the file to its final name, and syncs the folder.
    /// Errors: Exists, atomically, for Overwrite::No if the final name has been taken meanwhile.
    void commit(Overwrite overwrite = Overwrite::No);

  private:
    std::filesystem::path m_finalName;
    std::filesystem::path m_temporaryName;
    int m_descriptor = -1;
    std::uint64_t m_sizeBytes = 0;
};

/// Writes the whole file durably, as DurableFile does.
void writeFile(const std::filesystem::path& file, ByteView bytes,
               DurableFile::Overwrite overwrite = DurableFile::Overwrite::Yes);

/// Makes the folder and its missing parents. A folder that exists already stays as it is. Errors: Io.
void ensureFolder(const std::filesystem::path& folder);

/// Makes renames and new files of this folder survive a power cut.
void syncFolder(const std::filesystem::path& folder);

/// True if a file from outside may use this name for a path inside its own folder. Such a name is relative
/// and UTF-8, has no control characters or backslashes, and none of its parts is empty, "." or "..".
bool isSafeRelativePath(std::string_view name);

} // namespace spherewalk
