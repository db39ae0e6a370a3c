// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/records.h"

#include <algorithm>
#include <optional>
#include <set>

namespace spherewalk::store {

namespace fs = std::filesystem;

namespace {

constexpr int kMostDatabaseFindings = 100;

std::vector<std::string> databaseFindings(const Database& database) {
    std::vector<std::string> findings;
    try {
        Statement integrity = database.query(text("PRAGMA integrity_check(", kMostDatabaseFindings, ")"));
        while (integrity.step()) {
            if (integrity.text(0) != "ok") {
                findings.push_back(text("The database is damaged: ", printable(integrity.text(0), 200), "."));
            }
        }
        Statement keys = database.query(
            "SELECT \"table\", rowid, parent FROM pragma_foreign_key_check LIMIT ?", kMostDatabaseFindings);
        while (keys.step()) {
            findings.push_back(text("A row of ", printable(keys.text(0)), " refers to a row of ",
                                    printable(keys.text(2)), " that is not there."));
        }
        Statement unchosen =
            database.query("SELECT name FROM station WHERE id IN (SELECT station FROM photo) AND id "
                           "NOT IN (SELECT station FROM photo WHERE is_chosen = 1) LIMIT ?",
                           kMostDatabaseFindings);
        while (unchosen.step()) {
            findings.push_back(text("None of the photos at ", printable(unchosen.text(0)), " is chosen."));
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt) {
            throw;
        }
        findings.push_back(error.sentence());
    }
    return findings;
}

std::string hashOf(const fs::path& file, const std::stop_token& stop,
                   const std::function<void(ByteView)>& read) {
    Sha256 hash;
    readFileInPieces(file, [&](ByteView bytes) {
        throwIfStopped(stop);
        hash.update(bytes);
        read(bytes);
    });
    return hash.hex();
}

std::optional<PhotoFinding> finding(const PhotoRecord& photo, const fs::path& file,
                                    const std::stop_token& stop, const std::function<void(ByteView)>& read) {
    const auto found = [&](PhotoFinding::Kind kind, const std::string& sentence) {
        return PhotoFinding{photo.id, photo.fileName, kind, sentence};
    };
    const std::string name = text("The photo ", printable(photo.fileName));
    std::error_code failure;
    const auto size = fs::file_size(file, failure);
    if (failure) {
        return fs::exists(fs::symlink_status(file))
                   ? found(PhotoFinding::Kind::Unreadable,
                           text(name, " cannot be read: ", failure.message(), "."))
                   : found(PhotoFinding::Kind::Missing, text(name, " is missing from the photo folder."));
    }
    if (size != photo.sizeBytes) {
        return found(PhotoFinding::Kind::SizeDiffers,
                     text(name, " has ", humanBytes(size), ", and had ", humanBytes(photo.sizeBytes),
                          " when it was recorded."));
    }
    try {
        if (hashOf(file, stop, read) != photo.fileSha256) {
            return found(PhotoFinding::Kind::BytesDiffer,
                         text(name, " has been changed since it was recorded (its SHA-256 differs)."));
        }
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Stopped) {
            throw;
        }
        return found(PhotoFinding::Kind::Unreadable, error.sentence());
    }
    return std::nullopt;
}

std::vector<std::string> filesBesides(const std::set<std::string>& known, const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
        const std::string name = entry.path().filename().string();
        if (!known.contains(name)) {
            names.push_back(printable(name, 255));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

SurveyCheck SurveyStore::check(ProgressSink& progress, const std::stop_token& stop) const {
    SurveyCheck result;
    progress.progress(0, "Checking the database");
    result.database = databaseFindings(m_parts->db());
    std::vector<PhotoRecord> recorded;
    try {
        recorded = photos();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt) {
            throw;
        }
        result.database.push_back(error.sentence());
        return result;
    }
    double totalBytes = 1;
    for (const PhotoRecord& photo : recorded) {
        totalBytes += static_cast<double>(photo.sizeBytes);
    }
    double doneBytes = 0;
    double reportedBytes = 0;
    std::set<std::string> known;
    for (const PhotoRecord& photo : recorded) {
        throwIfStopped(stop);
        known.insert(photo.fileName);
        const auto read = [&](ByteView bytes) {
            reportedBytes += static_cast<double>(bytes.size());
            progress.progress(std::min(1.0, reportedBytes / totalBytes), text("Checking ", photo.fileName));
        };
        if (auto found = finding(photo, photoFolder() / photo.fileName, stop, read)) {
            result.photos.push_back(std::move(*found));
        }
        ++result.photosChecked;
        doneBytes += static_cast<double>(photo.sizeBytes);
        reportedBytes = doneBytes;
    }
    result.filesWithoutPhoto = filesBesides(known, photoFolder());
    progress.progress(1, "Checked");
    return result;
}

} // namespace spherewalk::store
