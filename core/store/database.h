// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sqlite3.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::store {

class Database;

/// A prepared statement. Errors: SQLite's, translated; Corrupt for a column that does not hold what is asked
/// for, as a damaged or forged database may.
class Statement {
  public:
    Statement(const Database& database, std::string_view sql);

    /// True if there is a row.
    bool step();
    /// Makes the statement ready for other values.
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

    /// Finite.
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
        ReadUnchanging, ///< a folder that cannot be written and holds no journal: without locks
        Write,
        Create,
    };

    /// Errors: SQLite's, translated.
    Database(std::filesystem::path file, Mode mode, std::chrono::milliseconds patience);

    const std::filesystem::path& file() const { return m_file; }

    sqlite3* handle() const { return m_handle.get(); }

    /// Runs all statements of a script.
    void execute(const std::string& sql) const;

    /// Runs one statement to its end.
    template <class... Values>
    void run(std::string_view sql, const Values&... values) const {
        Statement(*this, sql).with(values...).step();
    }

    template <class... Values>
    Statement query(std::string_view sql, const Values&... values) const {
        Statement statement(*this, sql);
        statement.with(values...);
        return statement;
    }

    /// The first column of the first row.
    std::int64_t integer(std::string_view sql) const;

    std::int64_t lastInsertId() const { return sqlite3_last_insert_rowid(handle()); }

    int changes() const { return sqlite3_changes(handle()); }

    /// Writes a whole consistent copy, durably.
    void copyTo(const std::filesystem::path& copy) const;

    /// Throws what the code means, with a sentence that names the survey.
    [[noreturn]] void fail(int code) const;
    /// Corrupt, with this reason.
    [[noreturn]] void failCorrupt(std::string_view reason) const;

  private:
    struct Close {
        void operator()(sqlite3* handle) const { sqlite3_close(handle); }
    };

    std::filesystem::path m_file;
    std::unique_ptr<sqlite3, Close> m_handle;
};

/// All or nothing: rolled back unless committed.
class Transaction {
  public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// On disk when it returns.
    void commit();

  private:
    const Database& m_database;
};

} // namespace spherewalk::store
