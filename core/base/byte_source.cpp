// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/byte_source.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spherewalk {

namespace {

[[noreturn]] void failShort(const std::string& name) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read ", name, ": it ends too early; copy the file again."));
}

[[noreturn]] void failIo(int code, const std::string& name) {
    throw Error(code == ENOENT || code == ENOTDIR ? ErrorKind::NotFound : ErrorKind::Io,
                text("Could not read ", name, ": ", std::string(std::strerror(code)), "."));
}

} // namespace

void MemorySource::read(std::uint64_t offset, std::span<std::uint8_t> into) const {
    if (offset > m_bytes.size() || into.size() > m_bytes.size() - offset) {
        failShort(m_name);
    }
    std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(offset), into.size(), into.begin());
}

FileSource::FileSource(const std::filesystem::path& file)
    : m_name(file.string()), m_descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};

    if (m_descriptor < 0) {
        failIo(errno, m_name);
    }
    if (::fstat(m_descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(m_descriptor);
        throw Error(ErrorKind::InvalidInput, text("Could not read ", m_name, ": it is not a file."));
    }
    m_sizeBytes = static_cast<std::uint64_t>(status.st_size);
}

FileSource::~FileSource() {
    ::close(m_descriptor);
}

void FileSource::read(std::uint64_t offset, std::span<std::uint8_t> into) const {
    if (offset > m_sizeBytes || into.size() > m_sizeBytes - offset) {
        failShort(m_name);
    }
    while (!into.empty()) {
        const ssize_t count = ::pread(m_descriptor, into.data(), into.size(), static_cast<off_t>(offset));
        if (count == 0) {
            failShort(m_name);
        }
        if (count < 0) {
            if (errno == EINTR) {
                continue;
            }
            failIo(errno, m_name);
        }
        into = into.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

void FileSource::fetchAhead() const {
    ::posix_fadvise(m_descriptor, 0, 0, POSIX_FADV_WILLNEED); // advice: if it fails, reads are only slower
}

} // namespace spherewalk
