// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace spherewalk::store {

namespace {

constexpr int kMostTextBytes = 64 << 20; ///< Limit of one value; a solution's report is the longest.

/// The file as SQLite's URI for a database that nobody changes.
std::string unchangingUri(const std::filesystem::path& file) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(file).string()) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
            byte == '/' || byte == '.' || byte == '-' || byte == '_') {
            uri += c;
        } else {
            uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
        }
    }
    return uri + "?immutable=1";
}

int openFlags(Database::Mode mode) {
    switch (mode) {
    case Database::Mode::Read:
        return SQLITE_OPEN_READONLY;
    case Database::Mode::ReadUnchanging:
        return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    case Database::Mode::Write:
        return SQLITE_OPEN_READWRITE;
    case Database::Mode::Create:
        break;
    }
    return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
}

bool isOutOfSpace(int systemError) {
    return systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG;
}

std::string lockHolder(int descriptor) {
    std::array<char, 32> digits{};
    const ssize_t count = ::pread(descriptor, digits.data(), digits.size(), 0);
    const std::string_view written(digits.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    const auto process = parseNumber(written.substr(0, written.find('\n')));
    return process ? text(" (process ", static_cast<long long>(*process), ")") : "";
}

} // namespace

Statement::Statement(const Database& database, std::string_view sql) : m_database(&database) {
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK) {
        database.fail(code);
    }
    m_statement.reset(statement);
}

bool Statement::step() {
    const int code = sqlite3_step(m_statement.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        m_database->fail(code);
    }
    return code == SQLITE_ROW;
}

void Statement::reset() {
    sqlite3_reset(m_statement.get()); // repeats the error that step() has thrown
}

void Statement::bind(int index, std::int64_t value) {
    if (const int code = sqlite3_bind_int64(m_statement.get(), index, value)) {
        m_database->fail(code);
    }
}

void Statement::bind(int index, double value) {
    if (const int code = sqlite3_bind_double(m_statement.get(), index, value)) {
        m_database->fail(code);
    }
}

void Statement::bind(int index, std::string_view value) {
    if (const int code = sqlite3_bind_text64(m_statement.get(), index, value.data() ? value.data() : "",
                                             value.size(), SQLITE_TRANSIENT, SQLITE_UTF8)) {
        m_database->fail(code);
    }
}

void Statement::bind(int index, std::nullopt_t /*none*/) {
    if (const int code = sqlite3_bind_null(m_statement.get(), index)) {
        m_database->fail(code);
    }
}

bool Statement::isNull(int column) const {
    return sqlite3_column_type(m_statement.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column, std::int64_t least, std::int64_t most) const {
    const std::int64_t value = sqlite3_column_int64(m_statement.get(), column);
    if (sqlite3_column_type(m_statement.get(), column) != SQLITE_INTEGER || value < least || value > most) {
        refuse(column);
    }
    return value;
}

double Statement::real(int column) const {
    const int type = sqlite3_column_type(m_statement.get(), column);
    const double value = sqlite3_column_double(m_statement.get(), column);
    if ((type != SQLITE_FLOAT && type != SQLITE_INTEGER) || !std::isfinite(value)) {
        refuse(column);
    }
    return value;
}

std::optional<double> Statement::optionalReal(int column) const {
    return isNull(column) ? std::nullopt : std::optional(real(column));
}

std::string Statement::text(int column) const {
    if (sqlite3_column_type(m_statement.get(), column) != SQLITE_TEXT) {
        refuse(column);
    }
    const auto* first = reinterpret_cast<const char*>(sqlite3_column_text(m_statement.get(), column));
    if (first == nullptr) {
        m_database->fail(SQLITE_NOMEM);
    }
    return {first, static_cast<std::size_t>(sqlite3_column_bytes(m_statement.get(), column))};
}

void Statement::refuse(int column) const {
    const char* name = sqlite3_column_name(m_statement.get(), column);
    m_database->failCorrupt(spherewalk::text("its value of \"", printable(name ? name : "?"),
                                             "\" is none that a survey can have"));
}

Database::Database(std::filesystem::path file, Mode mode, std::chrono::milliseconds patience)
    : m_file(std::move(file)) {
    sqlite3* handle = nullptr;
    const std::string name = mode == Mode::ReadUnchanging ? unchangingUri(m_file) : m_file.string();
    const int code = sqlite3_open_v2(name.c_str(), &handle, openFlags(mode), nullptr);
    m_handle.reset(handle);
    if (code != SQLITE_OK) {
        fail(code);
    }
    sqlite3_extended_result_codes(handle, 1);
    sqlite3_busy_timeout(handle, static_cast<int>(patience.count()));
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMostTextBytes);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    // A forged schema must not run functions of its choice.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    execute("PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL;");
}

void Database::execute(const std::string& sql) {
    if (const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr)) {
        fail(code);
    }
}

std::int64_t Database::integer(std::string_view sql) const {
    Statement statement(*this, sql);
    if (!statement.step()) {
        failCorrupt("it does not answer");
    }
    return statement.integer(0);
}

void Database::copyTo(const std::filesystem::path& copy) const {
    std::filesystem::path incomplete = copy;
    incomplete += ".part";
    std::error_code none;
    std::filesystem::remove(incomplete, none);
    {
        const Database target(incomplete, Mode::Create, std::chrono::milliseconds(0));
        sqlite3_backup* backup = sqlite3_backup_init(target.handle(), "main", handle(), "main");
        if (backup == nullptr) {
            target.fail(sqlite3_errcode(target.handle()));
        }
        const int copied = sqlite3_backup_step(backup, -1);
        const int finished = sqlite3_backup_finish(backup);
        if (copied != SQLITE_DONE || finished != SQLITE_OK) {
            target.fail(finished != SQLITE_OK ? finished : copied);
        }
    }
    std::error_code failure;
    std::filesystem::rename(incomplete, copy, failure);
    if (failure) {
        throw Error(ErrorKind::Io, spherewalk::text("Could not keep a copy of the database as ",
                                                    copy.string(), ": ", failure.message(), "."));
    }
    syncFolder(copy.parent_path());
}

void Database::fail(int code) const {
    const int systemError = m_handle ? sqlite3_system_errno(m_handle.get()) : 0;
    const std::string what = spherewalk::text("the survey's database ", m_file.string());
    ErrorKind kind = ErrorKind::Io;
    std::string sentence;
    switch (code & 0xff) {
    case SQLITE_NOTADB:
        failCorrupt("it is no database");
    case SQLITE_CORRUPT:
    case SQLITE_FORMAT:
    case SQLITE_TOOBIG:
        failCorrupt("its contents contradict each other");
    case SQLITE_ERROR:
    case SQLITE_SCHEMA:
        failCorrupt("its tables are not those of a survey");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        kind = ErrorKind::Busy;
        sentence = spherewalk::text("Could not use ", what,
                                    ": another program is using it; try again when it is done.");
        break;
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
    case SQLITE_AUTH:
        sentence = spherewalk::text("Could not open ", what, ": ",
                                    systemError != 0 ? std::strerror(systemError) : "it may not be written",
                                    "; check the permissions.");
        break;
    case SQLITE_IOERR:
        sentence = spherewalk::text(
            "Could not read or write ", what, ": ",
            systemError != 0 ? std::strerror(systemError) : "the disk does not answer", "; check the disk.");
        break;
    default:
        kind = ErrorKind::Internal;
        sentence = spherewalk::text("Could not use ", what, ": an unexpected failure in SQLite.");
    }
    if ((code & 0xff) == SQLITE_FULL || ((code & 0xff) == SQLITE_IOERR && isOutOfSpace(systemError))) {
        kind = ErrorKind::Full;
        sentence =
            spherewalk::text("Could not write ", what, ": the disk is full; free some space and try again. ",
                             "What was recorded before is kept.");
    }
    throw Error(kind, sentence,
                spherewalk::text("SQLite ", code, ": ",
                                 m_handle ? sqlite3_errmsg(m_handle.get()) : sqlite3_errstr(code)));
}

void Database::failCorrupt(std::string_view reason) const {
    throw Error(ErrorKind::Corrupt,
                spherewalk::text("The survey's database ", m_file.string(), " is damaged: ", reason,
                                 ". Restore it from a copy; the photos beside it are not affected."),
                m_handle ? sqlite3_errmsg(m_handle.get()) : "");
}

Transaction::Transaction(Database& database) : m_database(database) {
    m_database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    // After some failures SQLite has rolled back by itself.
    if (sqlite3_get_autocommit(m_database.handle()) == 0) {
        sqlite3_exec(m_database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit() {
    m_database.execute("COMMIT");
}

WriterLock::WriterLock(const std::filesystem::path& surveyFolder)
    : m_descriptor(::open((surveyFolder / "writer.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (m_descriptor < 0) {
        throw Error(ErrorKind::Io, text("Could not open the survey ", surveyFolder.string(),
                                        " for writing: ", std::strerror(errno),
                                        "; check the permissions, or open it for reading."));
    }
    if (::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        const std::string process = lockHolder(m_descriptor);
        ::close(m_descriptor);
        if (reason != EWOULDBLOCK) {
            throw Error(ErrorKind::Io, text("Could not lock the survey ", surveyFolder.string(),
                                            " for writing: ", std::strerror(reason), "."));
        }
        throw Error(ErrorKind::Busy,
                    text("The survey ", surveyFolder.string(), " is being written by another program",
                         process, "; close it there, or open it here for reading."));
    }
    // The process number only serves the sentence above: on a full disk the lock holds without it.
    const std::string process = text(static_cast<long long>(::getpid()), "\n");
    if (::ftruncate(m_descriptor, 0) == 0) {
        [[maybe_unused]] const ssize_t written = ::pwrite(m_descriptor, process.data(), process.size(), 0);
    }
}

WriterLock::~WriterLock() {
    ::close(m_descriptor);
}

} // namespace spherewalk::store
