// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/store/survey_store.h"

#include "store_parts.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/statfs.h>
#include <unistd.h>

namespace spherewalk::store {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDatabaseName = "survey.sqlite";
constexpr std::uintmax_t kQuickCheckBytes = 32 << 20; ///< a larger database is checked on request only

/// Without a slash at its end, which would hide the folder's name.
fs::path tidied(const fs::path& folder) {
    const fs::path normal = fs::absolute(folder).lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();
}

[[noreturn]] void failNoSurvey(const fs::path& folder, std::string_view why) {
    throw Error(ErrorKind::InvalidInput, text(folder.string(), " is not a survey: ", why,
                                              "; give a folder that Spherewalk has made."));
}

void checkIsSurveyFolder(const fs::path& folder) {
    std::error_code failure;
    const fs::file_status status = fs::status(folder, failure);
    if (status.type() == fs::file_type::not_found) {
        throw Error(ErrorKind::NotFound, text("There is no survey ", folder.string(), "; check the path."));
    }
    if (failure) {
        throw Error(ErrorKind::Io,
                    text("Could not open the survey ", folder.string(), ": ", failure.message(), "."));
    }
    if (!fs::is_directory(status)) {
        failNoSurvey(folder, "it is not a folder");
    }
    const auto size = fs::file_size(folder / kDatabaseName, failure);
    if (failure) {
        failNoSurvey(folder, text("it holds no readable file ", kDatabaseName));
    }
    if (size == 0) {
        throw Error(ErrorKind::Corrupt,
                    text("The survey's database ", (folder / kDatabaseName).string(),
                         " is empty. Restore it from a copy; the photos beside it are not "
                         "affected."));
    }
}

/// Whether several machines may use the folder at a time.
bool isOnShare(const fs::path& folder, const StoreOptions& options) {
    constexpr std::array<std::uint32_t, 8> kShares{0x6969,     0x517b,     0xff534d42, 0xfe534d42, // NFS, SMB
                                                   0x5346414f, 0x00c36400, 0x73757245, 0x0bd00bd0};

    struct statfs system {};

    return options.isOnShare.value_or(::statfs(folder.c_str(), &system) == 0 &&
                                      std::ranges::find(kShares, static_cast<std::uint32_t>(system.f_type)) !=
                                          kShares.end());
}

/// SQLite's write-ahead log keeps readers and the writer apart in the memory of one machine. On a share the
/// older journal stands in, which needs nothing but locks.
void chooseJournal(Database& database, const fs::path& folder, const StoreOptions& options) {
    const std::string wanted = isOnShare(folder, options) ? "delete" : "wal";
    Statement mode = database.query("PRAGMA journal_mode");
    if (mode.step() && mode.text(0) == wanted) {
        return;
    }
    mode.reset();
    try {
        database.execute(text("PRAGMA journal_mode = ", wanted));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Busy) { // a reader has it open: the next time will do
            throw;
        }
    }
}

/// Whether the database needs lock files beside it: bytes 18 and 19 of SQLite's header tell.
bool hasWriteAheadLog(const fs::path& folder) {
    constexpr std::size_t kHeader = 20;
    const FileSource file(folder / kDatabaseName);
    Bytes header(kHeader);
    file.read(0, header);
    return header[18] == 2 || header[19] == 2;
}

/// A folder that cannot be written holds no lock files for SQLite either, but for those of a writer that has
/// the survey open.
bool isUnchanging(const fs::path& folder) {
    std::error_code none;
    const auto journal = fs::file_size(folder / text(kDatabaseName, "-wal"), none);
    return ::access(folder.c_str(), W_OK) != 0 && (none || journal == 0) &&
           !fs::exists(folder / text(kDatabaseName, "-shm")) && hasWriteAheadLog(folder);
}

Database openForReading(const fs::path& folder, const StoreOptions& options) {
    const auto mode = isUnchanging(folder) ? Database::Mode::ReadUnchanging : Database::Mode::Read;
    return {folder / kDatabaseName, mode, options.patience};
}

bool isOlder(const Identity& found) {
    return found.applicationId == kApplicationId && found.version < newestVersion(migrations());
}

/// Before anything is written: a newer version's survey stays as it is.
void checkIdentity(const fs::path& folder, const Identity& found, Access access) {
    const int newest = newestVersion(migrations());
    if (found.applicationId != kApplicationId) {
        failNoSurvey(folder, text("its file ", kDatabaseName, " belongs to another program"));
    }
    if (found.version > newest) {
        throw Error(ErrorKind::Unsupported,
                    text("The survey ", folder.string(), " was written by a newer Spherewalk (format ",
                         static_cast<long long>(found.version), ", this one knows up to ", newest,
                         "); update Spherewalk to open it."));
    }
    if (isOlder(found) && access == Access::Read) {
        throw Error(
            ErrorKind::Unsupported,
            text("The survey ", folder.string(), " was written by an older Spherewalk (format ",
                 static_cast<long long>(found.version), ") and cannot be brought to format ", newest,
                 " here; close other programs that have it open, and see that it may be written to."));
    }
}

/// Opening for writing brings a survey to the newest format. Where that cannot be, checkIdentity() says so.
void bringUpToDate(const fs::path& folder, const StoreOptions& options) {
    try {
        SurveyStore::open(folder, Access::Write, options);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Busy && error.kind() != ErrorKind::Io) {
            throw;
        }
    }
}

void checkIntegrity(const Database& database) {
    std::error_code none;
    if (fs::file_size(database.file(), none) > kQuickCheckBytes) {
        return;
    }
    Statement result = database.query("PRAGMA quick_check(1)");
    if (!result.step() || result.text(0) != "ok") {
        database.failCorrupt("its pages contradict each other");
    }
}

void limitSize(Database& database, const StoreOptions& options) {
    if (options.maxDatabaseBytes > 0) {
        const std::int64_t page = database.integer("PRAGMA page_size");
        const auto pages = static_cast<long long>(options.maxDatabaseBytes) / std::max<std::int64_t>(page, 1);
        database.execute(text("PRAGMA max_page_count = ", pages));
    }
}

/// Moves a complete folder to its final name unless that is taken, atomically.
void moveIntoPlace(const fs::path& from, const fs::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
        return;
    }
    if (errno == EINVAL || errno == ENOSYS) { // a file system without the flag
        errno = fs::exists(to) ? EEXIST : 0;
        if (errno == 0 && std::rename(from.c_str(), to.c_str()) == 0) {
            return;
        }
    }
    if (errno == EEXIST || errno == ENOTEMPTY) {
        throw Error(ErrorKind::Exists, text("Could not create the survey ", to.string(),
                                            ": there is something by that name already; "
                                            "open it, or choose another name."));
    }
    throw Error(ErrorKind::Io,
                text("Could not create the survey ", to.string(), ": ", std::strerror(errno), "."));
}

/// A folder that disappears with what is in it unless it is moved away.
class IncompleteFolder {
  public:
    explicit IncompleteFolder(const fs::path& finalName) : m_path(finalName) {
        m_path += text(".", static_cast<long long>(::getpid()), ".part");
        std::error_code failure;
        fs::remove_all(m_path, failure);
        fs::create_directory(m_path, failure);
        if (failure) {
            const bool noParent = !fs::exists(finalName.parent_path());
            throw Error(
                noParent ? ErrorKind::NotFound : ErrorKind::Io,
                text("Could not create the survey ", finalName.string(), ": ", failure.message(),
                     noParent ? "; create the folder it shall lie in first." : "; check the permissions."));
        }
    }

    ~IncompleteFolder() {
        std::error_code ignored; // after the move there is nothing left
        fs::remove_all(m_path, ignored);
    }

    IncompleteFolder(const IncompleteFolder&) = delete;
    IncompleteFolder& operator=(const IncompleteFolder&) = delete;

    const fs::path& path() const { return m_path; }

  private:
    fs::path m_path;
};

void makeFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directory(folder, failure);
    if (failure) {
        throw Error(ErrorKind::Io,
                    text("Could not create the folder ", folder.string(), ": ", failure.message(), "."));
    }
}

} // namespace

SurveyStore SurveyStore::create(const fs::path& folder, const std::string& name, const survey::Room& room,
                                const survey::PlanOptions& options, const survey::Plan& plan,
                                const StoreOptions& storeOptions) {
    room.validate();
    options.validate(room);
    checkPlan(plan);
    checkText("name of the survey", name);
    const fs::path final = tidied(folder);
    if (fs::symlink_status(final).type() != fs::file_type::not_found) {
        throw Error(ErrorKind::Exists, text("Could not create the survey ", final.string(),
                                            ": there is something by that name already; open it, or choose "
                                            "another name."));
    }
    const IncompleteFolder incomplete(final);
    makeFolder(incomplete.path() / "photos");
    {
        Database database(incomplete.path() / kDatabaseName, Database::Mode::Create, storeOptions.patience);
        limitSize(database, storeOptions);
        makeSchema(database, migrations());
        Transaction transaction(database);
        database.run("INSERT INTO survey VALUES (1, ?, ?, ?, 0, 0, 0, 0, 0, 0, 0, 0, 0)", randomUuid(), name,
                     nowUtc());
        insertPlan(database, room, options, plan);
        insertProfile(database, survey::CaptureProfile{});
        transaction.commit();
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
    }
    syncFolder(incomplete.path());
    moveIntoPlace(incomplete.path(), final);
    syncFolder(final.parent_path());
    return open(final, Access::Write, storeOptions);
}

SurveyStore SurveyStore::open(const fs::path& folder, Access access, const StoreOptions& options) {
    auto parts = std::make_unique<Parts>();
    parts->folder = tidied(folder);
    checkIsSurveyFolder(parts->folder);
    parts->database.emplace(openForReading(parts->folder, options));
    if (access == Access::Read && isOlder(identity(parts->db()))) {
        parts->database.reset();
        bringUpToDate(parts->folder, options);
        parts->database.emplace(openForReading(parts->folder, options));
    }
    checkIdentity(parts->folder, identity(parts->db()), access);
    if (access == Access::Write) {
        parts->lock.emplace(parts->folder);
        parts->database.emplace(parts->folder / kDatabaseName, Database::Mode::Write, options.patience);
        limitSize(*parts->database, options);
        chooseJournal(*parts->database, parts->folder, options);
    }
    checkIntegrity(parts->db());
    if (access == Access::Write) {
        migrate(*parts->database, migrations());
        fs::create_directories(parts->folder / "photos");
    }
    return SurveyStore(std::move(parts));
}

SurveyStore::SurveyStore(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {
}

SurveyStore::~SurveyStore() = default;
SurveyStore::SurveyStore(SurveyStore&&) noexcept = default;
SurveyStore& SurveyStore::operator=(SurveyStore&&) noexcept = default;

const fs::path& SurveyStore::folder() const {
    return m_parts->folder;
}

fs::path SurveyStore::photoFolder() const {
    return m_parts->folder / "photos";
}

fs::path SurveyStore::downloadFolder() const {
    fs::path incoming = m_parts->folder / "incoming";
    if (m_parts->lock) {
        std::error_code failure;
        fs::create_directory(incoming, failure);
        if (failure) {
            throw Error(ErrorKind::Io, text("Could not create the folder ", incoming.string(), ": ",
                                            failure.message(), "."));
        }
    }
    return incoming;
}

SurveyInfo SurveyStore::info() const {
    Statement row = m_parts->db().query("SELECT uuid, name, created_utc FROM survey");
    if (!row.step()) {
        m_parts->db().failCorrupt("it does not say which survey it is");
    }
    return {row.text(0), row.text(1), m_parts->moment(row, 2)};
}

std::int64_t SurveyStore::dataVersion() const {
    return m_parts->db().integer("PRAGMA data_version");
}

Counts SurveyStore::counts() const {
    const auto count = [&](const char* sql) {
        return static_cast<int>(std::min<std::int64_t>(m_parts->db().integer(sql), INT32_MAX));
    };
    return {.stations = count(text("SELECT count(*) FROM station WHERE ", kIsWanted).c_str()),
            .stationsWithPhoto = count(text("SELECT count(*) FROM photo WHERE ", kIsKept).c_str()),
            .photos = count("SELECT count(*) FROM photo"),
            .rejectedPhotos =
                count(text("SELECT count(*) FROM photo WHERE is_chosen = 1 AND NOT (", kIsKept, ")").c_str()),
            .openShots = count("SELECT count(*) FROM shot WHERE step IN ('intended', 'started', 'taken')"),
            .unclearShots = count("SELECT count(*) FROM shot WHERE step = 'unclear'"),
            .solutions = count("SELECT count(*) FROM solution")};
}

Database& SurveyStore::Parts::writable() {
    if (!lock) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not change the survey ", folder.string(), ": it is open for reading only."));
    }
    return *database;
}

void SurveyStore::Parts::requireStation(std::int64_t station) const {
    if (!db().query("SELECT 1 FROM station WHERE id = ?", station).step()) {
        failNotFound("station", station);
    }
}

void SurveyStore::Parts::failNotFound(std::string_view what, std::int64_t id) const {
    throw Error(ErrorKind::NotFound, text("There is no ", what, " ", static_cast<long long>(id),
                                          " in the survey ", folder.string(), "."));
}

Moment SurveyStore::Parts::moment(const Statement& row, int column) const {
    const auto moment = parseIsoUtc(row.text(column));
    if (!moment) {
        db().failCorrupt("a time in it is none");
    }
    return *moment;
}

std::string nowUtc() {
    return isoUtc(systemClock().utc());
}

void checkText(std::string_view what, std::string_view value, std::size_t maxBytes) {
    if (value.size() > maxBytes || printable(value, value.size()) != value) {
        throw Error(ErrorKind::InvalidInput, text("The ", what, " \"", printable(value),
                                                  "\" cannot be used: it must be one line of UTF-8 ",
                                                  "text of at most ", maxBytes, " bytes."));
    }
}

} // namespace spherewalk::store
