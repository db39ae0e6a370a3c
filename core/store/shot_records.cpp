// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <initializer_list>

namespace spherewalk::store {

namespace {

constexpr const char* kSelectShot = "SELECT id, station, step, intended_utc, camera_serial, latest_file_url, "
                                    "total_entries, command_id, file_url, note, photo FROM shot ";

survey::ShotStep stepOf(const Database& database, const std::string& name) {
    try {
        return survey::shotStepNamed(name);
    } catch (const Error&) {
        database.failCorrupt("the record of a shot cannot be");
    }
}

survey::Shot shotFrom(const Database& database, const Statement& row) {
    const auto intended = parseIsoUtc(row.text(3));
    if (!intended) {
        database.failCorrupt("the record of a shot cannot be");
    }
    return {.id = row.integer(0),
            .station = row.integer(1),
            .step = stepOf(database, row.text(2)),
            .intendedAt = *intended,
            .cameraSerial = row.text(4),
            .baseline = {row.text(5), row.integer(6)},
            .commandId = row.text(7),
            .fileUrl = row.text(8),
            .note = row.text(9),
            .photo = row.isNull(10) ? std::nullopt : std::optional(row.integer(10))};
}

std::vector<survey::Shot> allShots(const Database& database, Statement rows) {
    std::vector<survey::Shot> result;
    while (rows.step()) {
        result.push_back(shotFrom(database, rows));
    }
    return result;
}

void checkMayBecome(const survey::Shot& shot, survey::ShotStep next,
                    std::initializer_list<survey::ShotStep> from) {
    if (std::find(from.begin(), from.end(), shot.step) == from.end()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Shot ", static_cast<long long>(shot.id), " is recorded as ", name(shot.step),
                         ", and cannot become ", name(next), "."));
    }
}

} // namespace

survey::Shot SurveyStore::beginShot(std::int64_t station, const std::string& cameraSerial,
                                    const survey::Baseline& baseline) {
    checkText("camera's serial number", cameraSerial);
    checkText("latest file's address on the camera", baseline.latestFileUrl, 4000);
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requireStation(station);
    database.run(
        "INSERT INTO shot (station, step, intended_utc, changed_utc, camera_serial, latest_file_url, "
        "total_entries) VALUES (?1, 'intended', ?2, ?2, ?3, ?4, ?5)",
        station, nowUtc(), cameraSerial, baseline.latestFileUrl, baseline.totalEntries);
    survey::Shot recorded = shot(database.lastInsertId());
    transaction.commit();
    return recorded;
}

void SurveyStore::markStarted(std::int64_t shotId, const std::string& commandId) {
    checkText("camera's command id", commandId);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), survey::ShotStep::Started, {survey::ShotStep::Intended});
    m_parts->writable().run("UPDATE shot SET step = 'started', command_id = ?, changed_utc = ? WHERE id = ?",
                            commandId, nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::markTaken(std::int64_t shotId, const std::string& fileUrl) {
    checkText("photo's address on the camera", fileUrl, 4000);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), survey::ShotStep::Taken,
                   {survey::ShotStep::Intended, survey::ShotStep::Started, survey::ShotStep::Unclear});
    m_parts->writable().run("UPDATE shot SET step = 'taken', file_url = ?, changed_utc = ? WHERE id = ?",
                            fileUrl, nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::markNotTaken(std::int64_t shotId) {
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), survey::ShotStep::NotTaken,
                   {survey::ShotStep::Intended, survey::ShotStep::Started, survey::ShotStep::Unclear});
    m_parts->writable().run("UPDATE shot SET step = 'not_taken', changed_utc = ? WHERE id = ?", nowUtc(),
                            shotId);
    transaction.commit();
}

void SurveyStore::markUnclear(std::int64_t shotId, const std::string& why, const std::string& fileUrl) {
    checkText("reason", why, 4000);
    checkText("photo's address on the camera", fileUrl, 4000);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), survey::ShotStep::Unclear,
                   {survey::ShotStep::Intended, survey::ShotStep::Started, survey::ShotStep::Taken});
    m_parts->writable().run(
        "UPDATE shot SET step = 'unclear', note = ?, file_url = ?, changed_utc = ? WHERE id = ?", why,
        fileUrl, nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::giveUp(std::int64_t shotId) {
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), survey::ShotStep::NotTaken,
                   {survey::ShotStep::Intended, survey::ShotStep::Started, survey::ShotStep::Taken,
                    survey::ShotStep::Unclear});
    m_parts->writable().run(
        "UPDATE shot SET step = 'not_taken', note = 'A person gave it up.', changed_utc = ? WHERE id = ?",
        nowUtc(), shotId);
    transaction.commit();
}

namespace {

/// Errors: InvalidInput.
void checkIsOfStation(const survey::Shot& taken, const NewPhoto& photo) {
    checkMayBecome(taken, survey::ShotStep::Downloaded, {survey::ShotStep::Taken});
    if (taken.station != photo.station) {
        throw Error(ErrorKind::InvalidInput,
                    text("The photo ", printable(photo.fileName), " cannot be recorded at station ",
                         static_cast<long long>(photo.station), ": its shot was taken at station ",
                         static_cast<long long>(taken.station), "."));
    }
}

void markDownloaded(Database& database, std::int64_t shot, std::int64_t photo) {
    database.run("UPDATE shot SET step = 'downloaded', photo = ?, changed_utc = ? WHERE id = ?", photo,
                 nowUtc(), shot);
}

} // namespace

std::int64_t SurveyStore::recordDownload(std::int64_t shotId, const NewPhoto& photo) {
    Transaction transaction(m_parts->writable());
    const survey::Shot taken = shot(shotId);
    checkIsOfStation(taken, photo);
    NewPhoto row = photo;
    row.choose = photo.choose && !photoAfter(taken);
    const std::int64_t added = m_parts->insertPhoto(row);
    markDownloaded(m_parts->writable(), shotId, added);
    transaction.commit();
    return added;
}

void SurveyStore::recordDownload(std::int64_t shotId, std::int64_t photoId) {
    Transaction transaction(m_parts->writable());
    const PhotoRecord known = photo(photoId);
    checkIsOfStation(shot(shotId), known);
    if (const auto other = shotOf(photoId)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The photo ", printable(known.fileName), " cannot be recorded for shot ",
                         static_cast<long long>(shotId), ": it belongs to shot ",
                         static_cast<long long>(other->id), "."));
    }
    markDownloaded(m_parts->writable(), shotId, photoId);
    transaction.commit();
}

std::vector<survey::Shot> SurveyStore::openShots() const {
    return allShots(
        m_parts->db(),
        m_parts->db().query(text(kSelectShot, "WHERE step IN ('intended', 'started', 'taken') ORDER BY id")));
}

std::vector<survey::Shot> SurveyStore::unclearShots() const {
    return allShots(m_parts->db(),
                    m_parts->db().query(text(kSelectShot, "WHERE step = 'unclear' ORDER BY id")));
}

std::optional<survey::Shot> SurveyStore::shotOf(std::int64_t photo) const {
    Statement row = m_parts->db().query(text(kSelectShot, "WHERE photo = ?"), photo);
    return row.step() ? std::optional(shotFrom(m_parts->db(), row)) : std::nullopt;
}

survey::Shot SurveyStore::shot(std::int64_t id) const {
    Statement row = m_parts->db().query(text(kSelectShot, "WHERE id = ?"), id);
    if (!row.step()) {
        m_parts->failNotFound("shot", id);
    }
    return shotFrom(m_parts->db(), row);
}

} // namespace spherewalk::store
