// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_journal.h"

#include "photo_intake.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/new_files.h"

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
    return m_store.use([&](store::SurveyStore& store) {
        return shotOf(store.beginShot(station, cameraSerial, baseline.latestFileUrl, baseline.totalEntries));
    });
}

void StoreJournal::started(std::int64_t shot, const std::string& commandId) {
    m_store.use([&](store::SurveyStore& store) { store.markStarted(shot, commandId); });
}

void StoreJournal::taken(std::int64_t shot, const std::string& fileUrl) {
    m_store.use([&](store::SurveyStore& store) { store.markTaken(shot, fileUrl); });
}

void StoreJournal::notTaken(std::int64_t shot) {
    m_store.use([&](store::SurveyStore& store) { store.markNotTaken(shot); });
}

void StoreJournal::unclear(std::int64_t shot, const std::string& why) {
    m_store.use([&](store::SurveyStore& store) { store.markUnclear(shot, why); });
}

void StoreJournal::downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) {
    Arrival arrival;
    std::string surveyId;
    std::string stationName;
    m_store.use([&](const store::SurveyStore& store) {
        const store::ShotRecord record = store.shot(shot);
        const store::StationRecord station = store.station(record.station);
        surveyId = store.info().uuid;
        stationName = station.name;
        arrival.station = record.station;
        arrival.positionM = station.station.positionM;
        arrival.cameraSerial = record.cameraSerial;
    });
    arrival.jpeg = readFile(photo.temporaryFile);
    arrival.source = photo.cameraFileName;
    arrival.cameraFileName = photo.cameraFileName;
    arrival.fileUrl = photo.fileUrl;
    TaggedPhoto taggedPhoto = tagged(arrival, surveyId, stationName); // slow: nobody waits for the store
    if (taggedPhoto.row.cameraSha256 != photo.cameraSha256) {
        throw Error(ErrorKind::Corrupt,
                    "The downloaded photo changed on the disk before it was recorded; the next run "
                    "downloads it again.");
    }
    m_store.use([&](store::SurveyStore& store) {
        if (store.shot(shot).step !=
            store::ShotStep::Taken) { // given up meanwhile: its name is another's now
            throw Error(ErrorKind::NotFound, text("The photo of ", stationName,
                                                  " is not known to be its own any more; take it again."));
        }
        store.recordDownload(shot, put(store, std::move(taggedPhoto)));
    });
    std::error_code ignored; // a leftover is replaced by the next download of this photo
    std::filesystem::remove(photo.temporaryFile, ignored);
}

std::vector<camera::Shot> StoreJournal::openShots() const {
    std::vector<camera::Shot> shots;
    for (const store::ShotRecord& record :
         m_store.use([](const store::SurveyStore& store) { return store.openShots(); })) {
        const bool isFetchable = record.step == store::ShotStep::Taken && camera::isMarked(record.fileUrl);
        if (m_view == View::All || isFetchable) {
            shots.push_back(shotOf(record));
        }
    }
    return shots;
}

std::filesystem::path StoreJournal::downloadFolder() const {
    return m_store.use([](const store::SurveyStore& store) { return store.downloadFolder(); });
}

} // namespace spherewalk::jobs
