// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sqlite3.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spherewalk::store {

class Database;

/// A prepared statement. Errors: SQLite's, translated; Corrupt for a column that does not hold what is asked
/// for, as a damaged or forged database may.
class Statement {
  public:
    Statement(const Database& database, std::string_view sql);

    /// Runs to the next row, and returns whether there is one.
    bool step();
    /// Makes the statement ready for another run with other values.
    void reset();

    void bind(int index, std::int64_t value);
    void bind(int index, double value);
    void bind(int index, std::string_view value);
    void bind(int index, std::nullopt_t none);

    void bind(int index, int value) { bind(index, static_cast<std::int64_t>(value)); }

    void bind(int index, bool value) { bind(index, static_cast<std::int64_t>(value)); }

    void bind(int index, const std::string& value) { bind(index, std::string_view(value)); }

    void bind(int index, const char* value) { bind(index, std::string_view(value)); }

    template <class Value>
    void bind(int index, const std::optional<Value>& value) {
        value ? bind(index, *value) : bind(index, std::nullopt);
    }

    template <class... Values>
    Statement& with(const Values&... values) {
        int index = 0;
        (bind(++index, values), ...);
        return *this;
    }

    bool isNull(int column) const;
    std::int64_t integer(int column, std::int64_t least = INT64_MIN, std::int64_t most = INT64_MAX) const;

    bool boolean(int column) const { return integer(column, 0, 1) != 0; }

    /// A finite number.
    double real(int column) const;
    std::optional<double> optionalReal(int column) const;
    std::string text(int column) const;

  private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
    };

    [[noreturn]] void refuse(int column) const;

    const Database* m_database;
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// One connection. Threads: one at a time.
class Database {
  public:
    enum class Mode {
        Read,
        ReadUnchanging, ///< Without locks, for a folder that cannot be written and holds no journal.
        Write,
        Create,
    };

    /// Errors: SQLite's, translated.
    Database(std::filesystem::path file, Mode mode, std::chrono::milliseconds patience);

    const std::filesystem::path& file() const { return m_file; }

    sqlite3* handle() const { return m_handle.get(); }

    /// Runs all statements of a script, which may change the database.
    void execute(const std::string& sql);

    /// Runs one statement that changes the database.
    template <class... Values>
    void run(std::string_view sql, const Values&... values) {
        Statement(*this, sql).with(values...).step();
    }

    /// A statement that reads. The caller steps through its rows.
    template <class... Values>
    Statement query(std::string_view sql, const Values&... values) const {
        Statement statement(*this, sql);
        statement.with(values...);
        return statement;
    }

    /// The first column of the first row of a query.
    std::int64_t integer(std::string_view sql) const;

    std::int64_t lastInsertId() const { return sqlite3_last_insert_rowid(handle()); }

    int changes() const { return sqlite3_changes(handle()); }

    /// Writes a whole consistent copy, durably.
    void copyTo(const std::filesystem::path& copy) const;

    /// Throws the error that SQLite's code means; the sentence names the database.
    [[noreturn]] void fail(int code) const;
    /// Throws Corrupt with this reason.
    [[noreturn]] void failCorrupt(std::string_view reason) const;

  private:
    struct Close {
        void operator()(sqlite3* handle) const { sqlite3_close(handle); }
    };

    std::filesystem::path m_file;
    std::unique_ptr<sqlite3, Close> m_handle;
};

/// Makes the changes during its life take effect together: at commit(), or not at all.
class Transaction {
  public:
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Writes the changes; they are on disk when the function returns.
    void commit();

  private:
    Database& m_database;
};

/// Makes this program the survey's one writer while the object lives. The lock ends with the program, however
/// that ends. Source: flock(2) on `writer.lock` in the survey's folder; the file names the holder's process.
class WriterLock {
  public:
    /// Errors: Busy, naming the process that holds it; Io, Full.
    explicit WriterLock(const std::filesystem::path& surveyFolder);
    ~WriterLock();
    WriterLock(const WriterLock&) = delete;
    WriterLock& operator=(const WriterLock&) = delete;

  private:
    int m_descriptor;
};

/// "SphW": the application id by which SQLite files tell that they are surveys.
inline constexpr std::int64_t kApplicationId = 0x53706857;

/// Takes a database of the version before to this version.
struct Migration {
    int version;
    const char* sql;
};

/// All migrations, with versions 1, 2, ... in order. This program reads and writes the last version.
std::span<const Migration> migrations();

/// The version of the last migration.
int newestVersion(std::span<const Migration> all);

/// The program and the format that a database belongs to.
struct Identity {
    std::int64_t applicationId = 0;
    std::int64_t version = 0;
};

/// Reads what the database says of itself.
Identity identity(const Database& database);

/// Makes an empty database a survey of the newest version.
void makeSchema(Database& database, std::span<const Migration> all);

/// Brings an older survey up to date, one transaction per version. A copy is kept before as
/// `<file>.before-v<newest>`. A survey that is up to date stays as it is.
void migrate(Database& database, std::span<const Migration> all);

} // namespace spherewalk::store
