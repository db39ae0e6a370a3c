// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "file_fault.h" // of core/base, whose folder the test has on its include path

#include <sqlite3.h>

#include <cerrno>
#include <map>
#include <mutex>

namespace spherewalk::test {

/// SQLite's file operations, which ask the installed FileFault before they open, write or sync. As long as
/// the object lives, they are the ones that databases use. Owner: at most one object at a time.
class FailingDatabase {
  public:
    FailingDatabase() {
        original() = sqlite3_vfs_find(nullptr);
        m_system = *original();
        m_system.zName = "failing";
        m_system.xOpen = open;
        sqlite3_vfs_register(&m_system, 1);
    }

    ~FailingDatabase() {
        sqlite3_vfs_unregister(&m_system);
        sqlite3_vfs_register(original(), 1);
    }

    FailingDatabase(const FailingDatabase&) = delete;
    FailingDatabase& operator=(const FailingDatabase&) = delete;

  private:
    /// The operations of an open file, in place of the original ones.
    struct Methods {
        sqlite3_io_methods own; // first, so that a file's pointer to it is a pointer to this
        const sqlite3_io_methods* original;
    };

    static sqlite3_vfs*& original() {
        static sqlite3_vfs* system = nullptr;
        return system;
    }

    static const sqlite3_io_methods* originalOf(sqlite3_file* file) {
        return reinterpret_cast<const Methods*>(file->pMethods)->original;
    }

    static int write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
        if (const int code = faultOf(FileOperation::Write, "database")) {
            return code == ENOSPC ? SQLITE_FULL : SQLITE_IOERR_WRITE;
        }
        return originalOf(file)->xWrite(file, bytes, count, offset);
    }

    static int sync(sqlite3_file* file, int flags) {
        const bool fails = faultOf(FileOperation::Sync, "database") != 0;
        return fails ? SQLITE_IOERR_FSYNC : originalOf(file)->xSync(file, flags);
    }

    static int open(sqlite3_vfs* /*system*/, const char* name, sqlite3_file* file, int flags, int* outFlags) {
        if (name != nullptr && faultOf(FileOperation::Open, name) != 0) {
            file->pMethods = nullptr;
            return SQLITE_CANTOPEN;
        }
        const int result = original()->xOpen(original(), name, file, flags, outFlags);
        if (file->pMethods != nullptr) {
            static std::mutex mutex;
            static std::map<const sqlite3_io_methods*, Methods> known;
            const std::scoped_lock lock(mutex);
            const auto [entry, isNew] =
                known.try_emplace(file->pMethods, Methods{*file->pMethods, file->pMethods});
            entry->second.own.xWrite = write;
            entry->second.own.xSync = sync;
            file->pMethods = &entry->second.own;
        }
        return result;
    }

    sqlite3_vfs m_system{};
};

} // namespace spherewalk::test
