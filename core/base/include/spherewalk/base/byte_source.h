// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace spherewalk {

/// Bytes of which parts are read, wherever they are. Threads: const, any number at a time.
class ByteSource {
  public:
    virtual ~ByteSource() = default;

    /// As it was when the source was opened.
    virtual std::uint64_t sizeBytes() const = 0;
    /// Fills all of `into` with the bytes from `offset` on. Errors: Corrupt if the source ends before; Io.
    virtual void read(std::uint64_t offset, std::span<std::uint8_t> into) const = 0;
    /// What the bytes are, for sentences.
    virtual const std::string& name() const = 0;
};

/// Bytes in memory. Owner: the bytes must outlive the source.
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

/// An open file. It is read, not mapped: a file that is cut while it is in use is an error here, and not a
/// signal that ends the program.
class FileSource : public ByteSource {
  public:
    /// Errors: NotFound, Io; InvalidInput for what is no regular file.
    explicit FileSource(const std::filesystem::path& file);
    ~FileSource() override;
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;

    std::uint64_t sizeBytes() const override { return m_sizeBytes; }

    void read(std::uint64_t offset, std::span<std::uint8_t> into) const override;

    const std::string& name() const override { return m_name; }

    /// Asks the system to read all of it now, in the background: many reads of small parts then wait for the
    /// disk once. Nothing happens where that is not possible.
    void fetchAhead() const;

  private:
    std::string m_name;
    int m_descriptor = -1;
    std::uint64_t m_sizeBytes = 0;
};

} // namespace spherewalk
