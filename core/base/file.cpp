// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/file.h"

#include "file_fault.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace spherewalk {

namespace {

[[noreturn]] void failFile(int code, const std::string& tried, const std::filesystem::path& file) {
    const std::string reason = std::strerror(code);
    const std::string name = file.string();
    switch (code) {
    case ENOENT:
    case ENOTDIR:
        throw Error(ErrorKind::NotFound,
                    text("Could not ", tried, " ", name, ": there is no such file or folder."));
    case EEXIST:
        throw Error(ErrorKind::Exists, text("Could not ", tried, " ", name, ": it exists already."));
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        throw Error(
            ErrorKind::Full,
            text("Could not ", tried, " ", name, ": the disk is full; free some space and try again."),
            reason);
    case EACCES:
    case EPERM:
    case EROFS:
        throw Error(ErrorKind::Io,
                    text("Could not ", tried, " ", name, ": ", reason, "; check the permissions."));
    default:
        throw Error(ErrorKind::Io, text("Could not ", tried, " ", name, ": ", reason, "."));
    }
}

std::atomic<FileFault*> installedFault{nullptr};

/// The result of the system call. Where a test lets the operation fail, the result is -1 with errno set.
template <class Name, class Call>
auto attempt(FileOperation operation, const Name& file, const Call& call) -> decltype(call()) {
    FileFault* fault = installedFault.load(std::memory_order_acquire);
    if (const int code = fault == nullptr ? 0 : fault->errorOf(operation, file)) {
        errno = code;
        return -1;
    }
    return call();
}

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
  public:
    explicit Descriptor(int value) : m_value(value) {}

    ~Descriptor() { ::close(m_value); }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int value() const { return m_value; }

  private:
    int m_value;
};

/// Without waiting for the other end of a pipe, which is then refused.
constexpr int kForReading = O_RDONLY | O_NONBLOCK | O_CLOEXEC;

int openForReading(const std::filesystem::path& file) {
    const int descriptor =
        attempt(FileOperation::Open, file, [&] { return ::open(file.c_str(), kForReading); });
    if (descriptor < 0) {
        failFile(errno, "read", file);
    }
    return descriptor;
}

/// Size of an open regular file; anything else (a folder, a device) is refused.
std::uint64_t regularSize(const Descriptor& descriptor, const std::filesystem::path& file) {
    struct stat status {};

    if (::fstat(descriptor.value(), &status) != 0) {
        failFile(errno, "read", file);
    }
    if (!S_ISREG(status.st_mode)) {
        throw Error(ErrorKind::InvalidInput, text("Could not read ", file.string(), ": it is not a file."));
    }
    return static_cast<std::uint64_t>(status.st_size);
}

std::size_t readSome(const Descriptor& descriptor, std::span<std::uint8_t> into,
                     const std::filesystem::path& file) {
    for (;;) {
        const ssize_t count = attempt(FileOperation::Read, file,
                                      [&] { return ::read(descriptor.value(), into.data(), into.size()); });
        if (count >= 0) {
            return static_cast<std::size_t>(count);
        }
        if (errno != EINTR) {
            failFile(errno, "read", file);
        }
    }
}

[[noreturn]] void failShort(const std::string& name) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read ", name, ": it ends too early; copy the file again."));
}

[[noreturn]] void failPart(int code, const std::string& name) {
    throw Error(code == ENOENT || code == ENOTDIR ? ErrorKind::NotFound : ErrorKind::Io,
                text("Could not read ", name, ": ", std::string(std::strerror(code)), "."));
}

/// Gives a complete file its final name unless that is taken. Returns 0, or -1 with errno.
int renameToNew(const std::filesystem::path& from, const std::filesystem::path& to) {
    const int moved = attempt(FileOperation::Rename, to, [&] {
        return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE);
    });
    if (moved == 0 || (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP)) {
        return moved;
    }
    // On a file system without the flag, exFAT for example, an empty file takes the name first.
    const int placeholder = attempt(FileOperation::Open, to, [&] {
        return ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    });
    if (placeholder < 0) {
        return -1;
    }
    ::close(placeholder);
    const int replaced =
        attempt(FileOperation::Rename, to, [&] { return ::rename(from.c_str(), to.c_str()); });
    if (replaced != 0) {
        const int code = errno;
        ::unlink(to.c_str());
        errno = code;
    }
    return replaced;
}

} // namespace

FileFault* replaceFileFault(FileFault* fault) {
    return installedFault.exchange(fault);
}

int faultOf(FileOperation operation, const std::filesystem::path& path) {
    FileFault* fault = installedFault.load(std::memory_order_acquire);
    return fault == nullptr ? 0 : fault->errorOf(operation, path);
}

Bytes readFile(const std::filesystem::path& file, std::uint64_t maxBytes) {
    const Descriptor descriptor(openForReading(file));
    const std::uint64_t size = regularSize(descriptor, file);
    if (size > maxBytes) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not read ", file.string(), ": it has ", humanBytes(size), ", more than the ",
                         humanBytes(maxBytes), " that such a file may have."));
    }
    Bytes bytes(size);
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const std::size_t count = readSome(descriptor, std::span(bytes).subspan(filled), file);
        if (count == 0) {
            break;
        }
        filled += count;
    }
    bytes.resize(filled);
    return bytes;
}

std::string readTextFile(const std::filesystem::path& file, std::uint64_t maxBytes) {
    const Bytes bytes = readFile(file, maxBytes);
    return std::string(textOf(bytes));
}

void readFileInPieces(const std::filesystem::path& file, const std::function<void(ByteView)>& take) {
    const Descriptor descriptor(openForReading(file));
    regularSize(descriptor, file);
    Bytes buffer(1 << 20);
    while (const std::size_t count = readSome(descriptor, buffer, file)) {
        take(ByteView(buffer).first(count));
    }
}

void MemorySource::read(std::uint64_t offset, std::span<std::uint8_t> into) const {
    if (offset > m_bytes.size() || into.size() > m_bytes.size() - offset) {
        failShort(m_name);
    }
    std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(offset), into.size(), into.begin());
}

FileSource::FileSource(const std::filesystem::path& file)
    : m_name(file.string()),
      m_descriptor(attempt(FileOperation::Open, file, [&] { return ::open(file.c_str(), kForReading); })) {
    struct stat status {};

    if (m_descriptor < 0) {
        failPart(errno, m_name);
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
        const ssize_t count = attempt(FileOperation::Read, m_name, [&] {
            return ::pread(m_descriptor, into.data(), into.size(), static_cast<off_t>(offset));
        });
        if (count == 0) {
            failShort(m_name);
        }
        if (count < 0) {
            if (errno == EINTR) {
                continue;
            }
            failPart(errno, m_name);
        }
        into = into.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

void FileSource::fetchAhead() const {
    ::posix_fadvise(m_descriptor, 0, 0, POSIX_FADV_WILLNEED); // advice: if it fails, reads are only slower
}

DurableFile::DurableFile(std::filesystem::path finalName) : m_finalName(std::move(finalName)) {
    static std::atomic<unsigned> counter{0};
    m_temporaryName = m_finalName;
    m_temporaryName += text(".", ::getpid(), "-", counter++, ".part");
    m_descriptor = attempt(FileOperation::Open, m_finalName, [&] {
        return ::open(m_temporaryName.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    });
    if (m_descriptor < 0) {
        failFile(errno, "write", m_finalName);
    }
}

DurableFile::~DurableFile() {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
        ::unlink(m_temporaryName.c_str());
    }
}

void DurableFile::write(ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t count = attempt(FileOperation::Write, m_finalName,
                                      [&] { return ::write(m_descriptor, bytes.data(), bytes.size()); });
        if (count < 0) {
            if (errno == EINTR) {
                continue;
            }
            failFile(errno, "write", m_finalName);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        m_sizeBytes += static_cast<std::uint64_t>(count);
    }
}

void DurableFile::commit(Overwrite overwrite) {
    if (attempt(FileOperation::Sync, m_finalName, [&] { return ::fsync(m_descriptor); }) != 0) {
        failFile(errno, "write", m_finalName);
    }
    const int moved = overwrite == Overwrite::No
                          ? renameToNew(m_temporaryName, m_finalName)
                          : attempt(FileOperation::Rename, m_finalName,
                                    [&] { return ::rename(m_temporaryName.c_str(), m_finalName.c_str()); });
    if (moved != 0) {
        failFile(errno, "write", m_finalName);
    }
    ::close(std::exchange(m_descriptor, -1));
    syncFolder(m_finalName.has_parent_path() ? m_finalName.parent_path() : ".");
}

void writeFile(const std::filesystem::path& file, ByteView bytes, DurableFile::Overwrite overwrite) {
    DurableFile output(file);
    output.write(bytes);
    output.commit(overwrite);
}

void ensureFolder(const std::filesystem::path& folder) {
    std::error_code failure(faultOf(FileOperation::MakeFolder, folder), std::generic_category());
    if (!failure) {
        std::filesystem::create_directories(folder, failure);
    }
    if (failure) {
        throw Error(ErrorKind::Io,
                    text("Could not make the folder ", folder.string(), ": ", failure.message(), "."));
    }
}

void syncFolder(const std::filesystem::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        failFile(errno, "sync", folder);
    }
    const Descriptor guard(descriptor);
    // Some file systems cannot sync a folder and say EINVAL; their renames are as durable as they get.
    const int synced = attempt(FileOperation::Sync, folder, [&] { return ::fsync(descriptor); });
    if (synced != 0 && errno != EINVAL) {
        failFile(errno, "sync", folder);
    }
}

bool isSafeRelativePath(std::string_view name) {
    if (name.empty() || name.front() == '/' || name.size() > 1024 || printable(name, name.size()) != name) {
        return false;
    }
    if (name.find('\\') != std::string_view::npos) {
        return false;
    }
    while (!name.empty()) {
        const std::size_t slash = name.find('/');
        const std::string_view part = name.substr(0, slash);
        if (part.empty() || part == "." || part == "..") {
            return false;
        }
        if (slash == std::string_view::npos) {
            return true;
        }
        name.remove_prefix(slash + 1);
    }
    return false; // ends in a slash
}

} // namespace spherewalk
