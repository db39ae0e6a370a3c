// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <set>

namespace spherewalk::store {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kWidestPhoto = 1 << 20;
constexpr std::string_view kNoHash = "its SHA-256 is not given as 64 lower-case hexadecimal digits";
constexpr const char* kSelectPhoto =
    "SELECT id, station, file_name, camera_file_name, camera_serial, file_url, camera_sha256, file_sha256, "
    "size_bytes, width, height, taken_utc, added_utc, x_m, y_m, z_m, is_chosen, note FROM photo ";

bool isFileName(std::string_view name) {
    return isSafeRelativePath(name) && name.find('/') == std::string_view::npos && name.size() <= 255;
}

bool isHash(std::string_view hash) {
    return hash.size() == 64 && hash.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

[[noreturn]] void refusePhoto(const std::string& fileName, std::string_view why) {
    throw Error(ErrorKind::InvalidInput,
                text("The photo ", printable(fileName), " cannot be recorded: ", why, "."));
}

void checkPhotoName(const std::string& fileName, const std::string& sha256,
                    const Eigen::Vector3d& positionM) {
    if (!isFileName(fileName)) {
        refusePhoto(fileName, "its name is no file's name");
    }
    if (!isHash(sha256)) {
        refusePhoto(fileName, kNoHash);
    }
    if (!positionM.allFinite()) {
        refusePhoto(fileName, "its position is not a number");
    }
}

void checkPhotoFile(const fs::path& file, std::uint64_t sizeBytes) {
    std::error_code failure;
    const auto size = fs::file_size(file, failure);
    if (failure) {
        throw Error(ErrorKind::NotFound,
                    text("The photo ", file.string(), " cannot be recorded: there is no such file."));
    }
    if (size != sizeBytes || size == 0) {
        throw Error(ErrorKind::Corrupt,
                    text("The photo ", file.string(), " cannot be recorded: it has ", humanBytes(size),
                         ", and should have ", humanBytes(sizeBytes), "."));
    }
}

void checkPhoto(const NewPhoto& photo) {
    checkPhotoName(photo.fileName, photo.fileSha256, photo.positionM);
    if (!isHash(photo.cameraSha256)) {
        refusePhoto(photo.fileName, kNoHash);
    }
    if (photo.width < 1 || photo.height < 1 || photo.width > kWidestPhoto || photo.height > kWidestPhoto) {
        refusePhoto(photo.fileName, text("it cannot have ", photo.width, " x ", photo.height, " pixels"));
    }
    checkText("camera's file name", photo.cameraFileName);
    checkText("camera's serial number", photo.cameraSerial);
    checkText("photo's address on the camera", photo.fileUrl, 4000);
    checkText("photo's note", photo.note, 4000);
}

/// Before the rules of the tables refuse it without saying why.
void checkIsNew(const Database& database, const NewPhoto& photo) {
    Statement same = database.query("SELECT photo.file_name, station.name, camera_sha256 = ?1 FROM photo "
                                    "JOIN station ON station.id = photo.station "
                                    "WHERE camera_sha256 = ?1 OR file_name = ?2 ORDER BY 3 DESC",
                                    photo.cameraSha256, photo.fileName);
    if (!same.step()) {
        return;
    }
    const std::string where = text(printable(same.text(0)), " at ", printable(same.text(1)));
    throw Error(ErrorKind::Exists,
                same.boolean(2) ? text("The photo ", printable(photo.fileName),
                                       " is in the survey already, as ", where, ".")
                                : text("The photo ", printable(photo.fileName),
                                       " cannot be recorded: ", where, " has that name; choose another."));
}

PhotoRecord photoOf(const Database& database, const Statement& row) {
    PhotoRecord photo;
    photo.id = row.integer(0);
    photo.station = row.integer(1);
    photo.fileName = row.text(2);
    photo.cameraFileName = row.text(3);
    photo.cameraSerial = row.text(4);
    photo.fileUrl = row.text(5);
    photo.cameraSha256 = row.text(6);
    photo.fileSha256 = row.text(7);
    photo.sizeBytes = static_cast<std::uint64_t>(row.integer(8, 1));
    photo.width = static_cast<int>(row.integer(9, 1, kWidestPhoto));
    photo.height = static_cast<int>(row.integer(10, 1, kWidestPhoto));
    const auto added = parseIsoUtc(row.text(12));
    if (!row.isNull(11)) {
        photo.takenAt = parseIsoUtc(row.text(11));
    }
    // Opened by name in the photo folder: a forged name must not lead out of it.
    if (!isFileName(photo.fileName) || !added || (!row.isNull(11) && !photo.takenAt)) {
        database.failCorrupt("the record of a photo cannot be");
    }
    photo.addedAt = *added;
    photo.positionM = {row.real(13), row.real(14), row.real(15)};
    photo.choose = row.boolean(16);
    photo.note = row.text(17);
    return photo;
}

/// The name with something before its extension.
std::string withSuffix(const std::string& name, const std::string& suffix) {
    const fs::path path(name);
    return text(path.stem().string(), "_", suffix, path.extension().string());
}

bool hasTheseBytes(const fs::path& file, const std::string& sha256) {
    return fs::is_regular_file(file) && sha256HexOfFile(file) == sha256;
}

std::vector<PhotoRecord> allPhotos(const Database& database, Statement rows) {
    std::vector<PhotoRecord> result;
    while (rows.step()) {
        result.push_back(photoOf(database, rows));
    }
    return result;
}

std::int64_t stationOfPhoto(const Database& database, std::int64_t photo) {
    Statement row = database.query("SELECT station FROM photo WHERE id = ?", photo);
    row.step();
    return row.integer(0);
}

/// A photo leaves the active solution if that does not have it at this place. Returns whether it did.
bool leaveActiveSolution(Database& database, std::int64_t photo, const Eigen::Vector3d& positionM) {
    constexpr double kSamePlaceM = 0.05; // a solution that found the place by itself stays true
    constexpr std::string_view kOfActive =
        "FROM solution_photo WHERE photo = ? AND solution IN (SELECT id FROM solution WHERE is_active = 1)";
    Statement solved = database.query(text("SELECT x_m, y_m, z_m ", kOfActive), photo);
    if (!solved.step() ||
        (Eigen::Vector3d(solved.real(0), solved.real(1), solved.real(2)) - positionM).norm() <= kSamePlaceM) {
        return false;
    }
    solved.reset();
    database.run(text("DELETE ", kOfActive), photo);
    return true;
}

void chooseNewest(Database& database, std::int64_t station) {
    database.run("UPDATE photo SET is_chosen = 1 WHERE id = (SELECT max(id) FROM photo WHERE station = ?1) "
                 "AND NOT EXISTS (SELECT 1 FROM photo WHERE station = ?1 AND is_chosen = 1)",
                 station);
}

} // namespace

std::string photoAtStation(std::string_view fileName, std::string_view station) {
    if (station.starts_with("unplanned position (")) {
        return std::string(fileName); // A position says less than the file's name.
    }
    constexpr std::string_view kPlace = "place of ";
    const std::size_t place = station.find(kPlace);
    if (place != station.npos) {
        const fs::path file(fileName);
        const fs::path namesake(station.substr(place + kPlace.size()));
        const bool isLonger = file.extension() == namesake.extension() && // as freePhotoName() makes it
                              file.stem().string().starts_with(namesake.stem().string() + "_");
        if (file == namesake || isLonger) {
            return file.string();
        }
    }
    return text(fileName, " (", station, ")");
}

void SurveyStore::Parts::requirePhoto(std::int64_t photo) const {
    if (!db().query("SELECT 1 FROM photo WHERE id = ?", photo).step()) {
        failNotFound("photo", photo);
    }
}

std::int64_t SurveyStore::Parts::insertPhoto(const NewPhoto& photo) {
    checkPhoto(photo);
    requireStation(photo.station);
    checkIsNew(db(), photo);
    checkPhotoFile(folder / "photos" / photo.fileName, photo.sizeBytes);
    const bool isFirst = !db().query("SELECT 1 FROM photo WHERE station = ?", photo.station).step();
    const bool isChosen = photo.choose || isFirst;
    if (isChosen) {
        writable().run("UPDATE photo SET is_chosen = 0 WHERE station = ?", photo.station);
    }
    writable().run(
        "INSERT INTO photo (station, file_name, camera_file_name, camera_serial, file_url, camera_sha256, "
        "file_sha256, size_bytes, width, height, taken_utc, added_utc, x_m, y_m, z_m, is_chosen, note) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        photo.station, photo.fileName, photo.cameraFileName, photo.cameraSerial, photo.fileUrl,
        photo.cameraSha256, photo.fileSha256, static_cast<std::int64_t>(photo.sizeBytes), photo.width,
        photo.height, photo.takenAt ? std::optional(isoUtc(*photo.takenAt)) : std::nullopt, nowUtc(),
        photo.positionM.x(), photo.positionM.y(), photo.positionM.z(), isChosen, photo.note);
    return writable().lastInsertId();
}

std::vector<PhotoRecord> SurveyStore::photos() const {
    return allPhotos(m_parts->db(), m_parts->db().query(text(kSelectPhoto, "ORDER BY station, id")));
}

std::vector<PhotoRecord> SurveyStore::photosAt(std::int64_t station) const {
    return allPhotos(m_parts->db(),
                     m_parts->db().query(text(kSelectPhoto, "WHERE station = ? ORDER BY id"), station));
}

std::vector<PhotoRecord> SurveyStore::chosenPhotos() const {
    return allPhotos(m_parts->db(),
                     m_parts->db().query(text(kSelectPhoto, "WHERE is_chosen = 1 ORDER BY station")));
}

std::vector<PhotoRecord> SurveyStore::keptPhotos() const {
    return allPhotos(m_parts->db(),
                     m_parts->db().query(text(kSelectPhoto, "WHERE ", kIsKept, " ORDER BY station")));
}

std::optional<PhotoRecord> SurveyStore::chosenPhoto(std::int64_t station) const {
    Statement row = m_parts->db().query(text(kSelectPhoto, "WHERE is_chosen = 1 AND station = ?"), station);
    return row.step() ? std::optional(photoOf(m_parts->db(), row)) : std::nullopt;
}

std::optional<PhotoRecord> SurveyStore::photoAfter(const survey::Shot& shot) const {
    Statement row = m_parts->db().query(
        text(kSelectPhoto, "WHERE station = ?1 AND ", kIsKept,
             " AND (id IN (SELECT photo FROM shot WHERE id > ?2) OR (added_utc > ?3 AND id NOT IN (SELECT "
             "photo FROM shot WHERE photo IS NOT NULL)))"),
        shot.station, shot.id, isoUtc(shot.intendedAt));
    return row.step() ? std::optional(photoOf(m_parts->db(), row)) : std::nullopt;
}

std::optional<PhotoRecord> SurveyStore::findPhoto(const std::string& cameraSha256) const {
    Statement row = m_parts->db().query(text(kSelectPhoto, "WHERE camera_sha256 = ?"), cameraSha256);
    return row.step() ? std::optional(photoOf(m_parts->db(), row)) : std::nullopt;
}

PhotoRecord SurveyStore::photo(std::int64_t id) const {
    Statement row = m_parts->db().query(text(kSelectPhoto, "WHERE id = ?"), id);
    if (!row.step()) {
        m_parts->failNotFound("photo", id);
    }
    return photoOf(m_parts->db(), row);
}

std::int64_t SurveyStore::addPhoto(const NewPhoto& photo) {
    Transaction transaction(m_parts->writable());
    const std::int64_t id = m_parts->insertPhoto(photo);
    transaction.commit();
    return id;
}

void SurveyStore::choosePhoto(std::int64_t photoId) {
    Database& database = m_parts->writable();
    Transaction transaction(database);
    const std::int64_t station = photo(photoId).station;
    database.run("UPDATE photo SET is_chosen = 0 WHERE station = ?", station);
    database.run("UPDATE photo SET is_chosen = 1 WHERE id = ?", photoId);
    transaction.commit();
}

std::string SurveyStore::freePhotoName(const std::string& cameraFileName,
                                       const std::string& fileSha256) const {
    if (!isHash(fileSha256)) {
        throw Error(ErrorKind::InvalidInput, "A photo's SHA-256 has 64 lower-case hexadecimal digits.");
    }
    // With room for a suffix; a name that is none, as a damaged camera may give, is not used at all.
    const bool isUsable =
        isFileName(cameraFileName) && cameraFileName.size() <= 180 && cameraFileName[0] != '.';
    const std::string name = isUsable ? cameraFileName : "photo.JPG";
    for (const std::size_t digits : {0U, 8U, 64U}) {
        std::string candidate = digits == 0 ? name : withSuffix(name, fileSha256.substr(0, digits));
        const fs::path file = photoFolder() / candidate;
        if (!m_parts->db().query("SELECT 1 FROM photo WHERE file_name = ?", candidate).step() &&
            (!fs::exists(file) || hasTheseBytes(file, fileSha256))) {
            return candidate;
        }
    }
    throw Error(ErrorKind::Exists, text("Could not name the photo ", name,
                                        ": the survey has a photo with the same bytes already."));
}

bool SurveyStore::Parts::movePhoto(const MovedPhoto& moved) {
    requireStation(moved.station);
    const Eigen::Vector3d& p = moved.positionM;
    const bool isElsewhere =
        !db().query("SELECT 1 FROM photo WHERE id = ? AND x_m = ? AND y_m = ? AND z_m = ?", moved.photo,
                    p.x(), p.y(), p.z())
             .step();
    checkPhotoFile(folder / "photos" / moved.fileName, moved.sizeBytes);
    if (moved.choose) {
        writable().run("UPDATE photo SET is_chosen = 0 WHERE station = ?", moved.station);
    }
    writable().run("UPDATE photo SET station = ?, x_m = ?, y_m = ?, z_m = ?, file_name = ?, file_sha256 = ?, "
                   "size_bytes = ?, is_chosen = ? WHERE id = ?",
                   moved.station, moved.positionM.x(), moved.positionM.y(), moved.positionM.z(),
                   moved.fileName, moved.fileSha256, static_cast<std::int64_t>(moved.sizeBytes), moved.choose,
                   moved.photo);
    return isElsewhere && leaveActiveSolution(writable(), moved.photo, p);
}

std::vector<std::int64_t> SurveyStore::movePhotos(const std::vector<MovedPhoto>& photos) {
    Database& database = m_parts->writable();
    Transaction transaction(database);
    std::set<std::int64_t> stations;
    for (const MovedPhoto& moved : photos) {
        m_parts->requirePhoto(moved.photo);
        checkPhotoName(moved.fileName, moved.fileSha256, moved.positionM);
        stations.insert({stationOfPhoto(database, moved.photo), moved.station});
        // Photos that change places must not stand in each other's way.
        database.run("UPDATE photo SET is_chosen = 0 WHERE id = ?", moved.photo);
    }
    std::vector<std::int64_t> unsolved;
    for (const MovedPhoto& moved : photos) {
        if (m_parts->movePhoto(moved)) {
            unsolved.push_back(moved.photo);
        }
    }
    for (const std::int64_t station : stations) {
        chooseNewest(database, station);
    }
    transaction.commit();
    return unsolved;
}

} // namespace spherewalk::store
