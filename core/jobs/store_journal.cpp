// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_journal.h"

#include "photo_intake.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

namespace spherewalk::jobs {

namespace {

camera::ShotStep stepOf(store::ShotStep step) {
    switch (step) {
    case store::ShotStep::Intended:
        return camera::ShotStep::Intended;
    case store::ShotStep::Started:
        return camera::ShotStep::Started;
    case store::ShotStep::Taken:
        return camera::ShotStep::Taken;
    case store::ShotStep::Downloaded:
        return camera::ShotStep::Downloaded;
    case store::ShotStep::NotTaken:
        return camera::ShotStep::NotTaken;
    case store::ShotStep::Unclear:
        break;
    }
    return camera::ShotStep::Unclear;
}

camera::Shot shotOf(const store::ShotRecord& record) {
    camera::Shot shot;
    shot.id = record.id;
    shot.station = record.station;
    shot.step = stepOf(record.step);
    shot.intendedAt = record.intendedAt;
    shot.cameraSerial = record.cameraSerial;
    shot.baseline = {record.latestFileUrl, record.totalEntries};
    shot.commandId = record.commandId;
    shot.fileUrl = record.fileUrl;
    shot.note = record.note;
    return shot;
}

} // namespace

camera::Shot StoreJournal::begin(std::int64_t station, const std::string& cameraSerial,
                                 const camera::Baseline& baseline) {
    return shotOf(m_store.beginShot(station, cameraSerial, baseline.latestFileUrl, baseline.totalEntries));
}

void StoreJournal::started(std::int64_t shot, const std::string& commandId) {
    m_store.markStarted(shot, commandId);
}

void StoreJournal::taken(std::int64_t shot, const std::string& fileUrl) {
    m_store.markTaken(shot, fileUrl);
}

void StoreJournal::notTaken(std::int64_t shot) {
    m_store.markNotTaken(shot);
}

void StoreJournal::unclear(std::int64_t shot, const std::string& why) {
    m_store.markUnclear(shot, why);
}

void StoreJournal::downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) {
    const store::ShotRecord record = m_store.shot(shot);
    Arrival arrival;
    arrival.jpeg = readFile(photo.temporaryFile);
    arrival.source = photo.cameraFileName;
    arrival.station = record.station;
    arrival.positionM = m_store.station(record.station).station.positionM;
    arrival.cameraFileName = photo.cameraFileName;
    arrival.cameraSerial = record.cameraSerial;
    arrival.fileUrl = photo.fileUrl;
    const store::NewPhoto row = takeIn(m_store, arrival);
    if (row.cameraSha256 != photo.cameraSha256) {
        throw Error(ErrorKind::Corrupt,
                    "The downloaded photo changed on the disk before it was recorded; the next run "
                    "downloads it again.");
    }
    m_store.recordDownload(shot, row);
    std::error_code ignored; // a leftover is replaced by the next download of this photo
    std::filesystem::remove(photo.temporaryFile, ignored);
}

std::vector<camera::Shot> StoreJournal::openShots() const {
    std::vector<camera::Shot> shots;
    for (const store::ShotRecord& record : m_store.openShots()) {
        shots.push_back(shotOf(record));
    }
    return shots;
}

std::filesystem::path StoreJournal::downloadFolder() const {
    return m_store.downloadFolder();
}

} // namespace spherewalk::jobs
