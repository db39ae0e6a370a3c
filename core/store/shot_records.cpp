// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace spherewalk::store {

namespace {

constexpr std::array<std::pair<ShotStep, const char*>, 6> kSteps{{{ShotStep::Intended, "intended"},
                                                                  {ShotStep::Started, "started"},
                                                                  {ShotStep::Taken, "taken"},
                                                                  {ShotStep::Downloaded, "downloaded"},
                                                                  {ShotStep::NotTaken, "not_taken"},
                                                                  {ShotStep::Unclear, "unclear"}}};
constexpr const char* kSelectShot = "SELECT id, station, step, intended_utc, camera_serial, latest_file_url, "
                                    "total_entries, command_id, file_url, note, photo FROM shot ";

std::string stepName(ShotStep step) {
    return std::find_if(kSteps.begin(), kSteps.end(), [&](const auto& entry) { return entry.first == step; })
        ->second;
}

ShotRecord shotOf(const Database& database, const Statement& row) {
    const std::string name = row.text(2);
    const auto* step =
        std::find_if(kSteps.begin(), kSteps.end(), [&](const auto& entry) { return entry.second == name; });
    const auto intended = parseIsoUtc(row.text(3));
    if (step == kSteps.end() || !intended) {
        database.failCorrupt("the record of a shot cannot be");
    }
    return {.id = row.integer(0),
            .station = row.integer(1),
            .step = step->first,
            .intendedAt = *intended,
            .cameraSerial = row.text(4),
            .latestFileUrl = row.text(5),
            .totalEntries = row.integer(6),
            .commandId = row.text(7),
            .fileUrl = row.text(8),
            .note = row.text(9),
            .photo = row.isNull(10) ? std::nullopt : std::optional(row.integer(10))};
}

std::vector<ShotRecord> allShots(const Database& database, Statement rows) {
    std::vector<ShotRecord> result;
    while (rows.step()) {
        result.push_back(shotOf(database, rows));
    }
    return result;
}

void checkMayBecome(const ShotRecord& shot, ShotStep next, std::initializer_list<ShotStep> from) {
    if (std::find(from.begin(), from.end(), shot.step) == from.end()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Shot ", static_cast<long long>(shot.id), " is recorded as ", stepName(shot.step),
                         ", and cannot become ", stepName(next), "."));
    }
}

} // namespace

ShotRecord SurveyStore::beginShot(std::int64_t station, const std::string& cameraSerial,
                                  const std::string& latestFileUrl, std::int64_t totalEntries) {
    checkText("camera's serial number", cameraSerial);
    checkText("latest file's address on the camera", latestFileUrl, 4000);
    const Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requireStation(station);
    database.run(
        "INSERT INTO shot (station, step, intended_utc, changed_utc, camera_serial, latest_file_url, "
        "total_entries) VALUES (?1, 'intended', ?2, ?2, ?3, ?4, ?5)",
        station, nowUtc(), cameraSerial, latestFileUrl, totalEntries);
    ShotRecord recorded = shot(database.lastInsertId());
    transaction.commit();
    return recorded;
}

void SurveyStore::markStarted(std::int64_t shotId, const std::string& commandId) {
    checkText("camera's command id", commandId);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), ShotStep::Started, {ShotStep::Intended});
    m_parts->db().run("UPDATE shot SET step = 'started', command_id = ?, changed_utc = ? WHERE id = ?",
                      commandId, nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::markTaken(std::int64_t shotId, const std::string& fileUrl) {
    checkText("photo's address on the camera", fileUrl, 4000);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), ShotStep::Taken, {ShotStep::Intended, ShotStep::Started, ShotStep::Unclear});
    m_parts->db().run("UPDATE shot SET step = 'taken', file_url = ?, changed_utc = ? WHERE id = ?", fileUrl,
                      nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::markNotTaken(std::int64_t shotId) {
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), ShotStep::NotTaken,
                   {ShotStep::Intended, ShotStep::Started, ShotStep::Unclear});
    m_parts->db().run("UPDATE shot SET step = 'not_taken', changed_utc = ? WHERE id = ?", nowUtc(), shotId);
    transaction.commit();
}

void SurveyStore::markUnclear(std::int64_t shotId, const std::string& why) {
    checkText("reason", why, 4000);
    Transaction transaction(m_parts->writable());
    checkMayBecome(shot(shotId), ShotStep::Unclear, {ShotStep::Intended, ShotStep::Started, ShotStep::Taken});
    m_parts->db().run("UPDATE shot SET step = 'unclear', note = ?, changed_utc = ? WHERE id = ?", why,
                      nowUtc(), shotId);
    transaction.commit();
}

std::int64_t SurveyStore::recordDownload(std::int64_t shotId, const NewPhoto& photo) {
    Transaction transaction(m_parts->writable());
    const ShotRecord taken = shot(shotId);
    checkMayBecome(taken, ShotStep::Downloaded, {ShotStep::Taken});
    if (taken.station != photo.station) {
        throw Error(ErrorKind::InvalidInput,
                    text("The photo ", printable(photo.fileName), " cannot be recorded at station ",
                         static_cast<long long>(photo.station), ": its shot was taken at station ",
                         static_cast<long long>(taken.station), "."));
    }
    const std::int64_t added = m_parts->insertPhoto(photo);
    m_parts->db().run("UPDATE shot SET step = 'downloaded', photo = ?, changed_utc = ? WHERE id = ?", added,
                      nowUtc(), shotId);
    transaction.commit();
    return added;
}

std::vector<ShotRecord> SurveyStore::openShots() const {
    return allShots(
        m_parts->db(),
        m_parts->db().query(text(kSelectShot, "WHERE step IN ('intended', 'started', 'taken') ORDER BY id")));
}

std::vector<ShotRecord> SurveyStore::unclearShots() const {
    return allShots(m_parts->db(),
                    m_parts->db().query(text(kSelectShot, "WHERE step = 'unclear' ORDER BY id")));
}

ShotRecord SurveyStore::shot(std::int64_t id) const {
    Statement row = m_parts->db().query(text(kSelectShot, "WHERE id = ?"), id);
    if (!row.step()) {
        m_parts->failNotFound("shot", id);
    }
    return shotOf(m_parts->db(), row);
}

} // namespace spherewalk::store
