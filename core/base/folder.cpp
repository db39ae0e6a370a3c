// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/folder.h"

#include "file_fault.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <string>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace spherewalk {

namespace fs = std::filesystem;

namespace {

/// Throws what the file system would throw, where a test lets the operation fail.
void throwIfFaulty(FileOperation operation, const fs::path& path) {
    if (const int code = faultOf(operation, path)) {
        throw fs::filesystem_error("a fault of a test", path, std::error_code(code, std::generic_category()));
    }
}

/// Shows that the program that uses a folder still runs, also to programs on other machines.
class FolderLock {
  public:
    explicit FolderLock(const fs::path& folder)
        : m_descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)),
          m_isHeld(m_descriptor >= 0 && ::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0) {}

    ~FolderLock() {
        if (m_descriptor >= 0) {
            ::close(m_descriptor);
        }
    }

    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    bool isHeld() const { return m_isHeld; }

  private:
    int m_descriptor;
    bool m_isHeld;
};

/// Removes the folders prefix + process + ... + suffix whose process was killed: it runs no more, and does
/// not hold their lock.
void removeLeftovers(const fs::path& parent, std::string_view prefix, std::string_view suffix) {
    std::error_code failure; // what cannot be removed does no harm
    for (fs::directory_iterator entry(parent, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(prefix) || !name.ends_with(suffix)) {
            continue;
        }
        pid_t process = 0;
        const char* const digits = name.c_str() + prefix.size();
        const auto [rest, code] = std::from_chars(digits, name.c_str() + name.size(), process);
        const bool isOurs =
            code == std::errc() && process > 0 && (*rest == '-' || std::string_view(rest) == suffix);
        if (isOurs && ::kill(process, 0) != 0 && errno == ESRCH && FolderLock(entry->path()).isHeld()) {
            std::error_code ignored;
            fs::remove_all(entry->path(), ignored);
        }
    }
}

/// Removed with all its content, unless it was moved to its final place.
class UnfinishedFolder {
  public:
    explicit UnfinishedFolder(fs::path finalPlace) : m_finalPlace(std::move(finalPlace)) {
        removeLeftovers(m_finalPlace.has_parent_path() ? m_finalPlace.parent_path() : ".",
                        m_finalPlace.filename().string() + ".", ".part");
        m_path = m_finalPlace;
        m_path += text(".", ::getpid(), ".part");
        throwIfFaulty(FileOperation::MakeFolder, m_path);
        fs::remove_all(m_path);
        fs::create_directories(m_path);
        m_lock.emplace(m_path);
    }

    ~UnfinishedFolder() {
        std::error_code ignored; // a leftover with the name .part does no harm: nothing takes it for whole
        fs::remove_all(m_path, ignored);
    }

    UnfinishedFolder(const UnfinishedFolder&) = delete;
    UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

    const fs::path& path() const { return m_path; }

    void moveIntoPlace() {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(m_path)) {
            if (entry.is_directory()) {
                syncFolder(entry.path());
            }
        }
        syncFolder(m_path);
        throwIfFaulty(FileOperation::Rename, m_finalPlace);
        fs::rename(m_path, m_finalPlace);
        syncFolder(m_finalPlace.has_parent_path() ? m_finalPlace.parent_path() : ".");
    }

  private:
    fs::path m_finalPlace;
    fs::path m_path;
    std::optional<FolderLock> m_lock;
};

} // namespace

void requireAbsent(const fs::path& folder, std::string_view what) {
    if (fs::exists(fs::symlink_status(folder))) {
        throw Error(ErrorKind::Exists, text("Could not write ", what, " ", folder.string(),
                                            ": it exists already; choose another name, or remove it first."));
    }
}

void makeFolder(const fs::path& folder, std::string_view what,
                const std::function<void(const fs::path&)>& fill) {
    try {
        requireAbsent(folder, what);
        UnfinishedFolder unfinished(folder);
        fill(unfinished.path());
        requireAbsent(folder, what); // somebody may have made it meanwhile; rename would replace an empty one
        unfinished.moveIntoPlace();
    } catch (const fs::filesystem_error& failure) {
        const bool isFull = failure.code() == std::errc::no_space_on_device;
        throw Error(
            isFull ? ErrorKind::Full : ErrorKind::Io,
            text("Could not write ", what, " ", folder.string(), ": ", failure.code().message(), "."));
    }
}

TemporaryFolder::TemporaryFolder(std::string_view name) {
    std::error_code failure;
    const fs::path parent = fs::temp_directory_path(failure);
    const std::string prefix = text(name, "-");
    removeLeftovers(parent, prefix, "");
    std::string pattern = (parent / text(prefix, ::getpid(), "-XXXXXX")).string();
    if (failure || ::mkdtemp(pattern.data()) == nullptr) {
        throw Error(ErrorKind::Io, text("Could not make a temporary folder ", pattern, ": ",
                                        failure ? failure.message() : std::string(std::strerror(errno)),
                                        "; set TMPDIR to a folder that can be written."));
    }
    m_path = pattern;
    m_lock = std::make_shared<const FolderLock>(m_path);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored; // what is left of a temporary folder does no harm
    fs::remove_all(m_path, ignored);
}

} // namespace spherewalk
