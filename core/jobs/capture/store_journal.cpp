// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/store_journal.h"

#include "parts/photo_intake.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/shot_settler.h"

namespace spherewalk::jobs {

survey::Shot StoreJournal::begin(std::int64_t station, const std::string& cameraSerial,
                                 const survey::Baseline& baseline) {
    return m_store.use(
        [&](store::SurveyStore& store) { return store.beginShot(station, cameraSerial, baseline); });
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

void StoreJournal::unclear(std::int64_t shot, const std::string& why, const std::string& fileUrl) {
    m_store.use([&](store::SurveyStore& store) { store.markUnclear(shot, why, fileUrl); });
}

namespace {

/// Ends a shot whose photo the survey has already. A photo that was brought in by hand for the same station
/// is the shot's own; any other is a matter for a person.
void endWithKnown(store::SurveyStore& store, const survey::Shot& shot, const std::string& fileUrl,
                  const store::PhotoRecord& known) {
    if (known.station == shot.station && !store.shotOf(known.id)) {
        store.recordDownload(shot.id, known.id);
        return;
    }
    store.markUnclear(shot.id,
                      text("The file ", camera::fileNameOfUrl(fileUrl),
                           " on the camera is in the survey already: it is the photo ", known.fileName,
                           " of ", store.station(known.station).name,
                           ". Retag that photo if it belongs here, or take this station again."),
                      shot.fileUrl);
}

} // namespace

survey::Shot StoreJournal::downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) {
    Arrival arrival;
    std::string surveyId;
    std::string stationName;
    m_store.use([&](const store::SurveyStore& store) {
        const survey::Shot record = store.shot(shot);
        const store::StationRecord station = store.station(record.station);
        surveyId = store.info().uuid;
        stationName = station.name;
        arrival.station = record.station;
        arrival.positionM = station.station.positionM;
        arrival.isPlaced = station.isPlaceKnown;
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
    survey::Shot ended = m_store.use([&](store::SurveyStore& store) {
        const survey::Shot taken = store.shot(shot);
        if (taken.step != survey::ShotStep::Taken) { // given up meanwhile: its name is another's now
            throw Error(ErrorKind::NotFound, text("The photo of ", stationName,
                                                  " is not known to be its own any more; take it again."));
        }
        if (const auto known = store.findPhoto(photo.cameraSha256)) {
            endWithKnown(store, taken, photo.fileUrl, *known);
        } else {
            store.recordDownload(shot, put(store, std::move(taggedPhoto)));
        }
        return store.shot(shot);
    });
    std::error_code ignored; // a leftover is replaced by the next download of this photo
    std::filesystem::remove(photo.temporaryFile, ignored);
    return ended;
}

std::vector<survey::Shot> StoreJournal::openShots() const {
    std::vector<survey::Shot> shots =
        m_store.use([](const store::SurveyStore& store) { return store.openShots(); });
    if (m_view == View::Fetching) {
        std::erase_if(shots, [](const survey::Shot& shot) {
            return shot.step != survey::ShotStep::Taken || !camera::isMarked(shot.fileUrl);
        });
    }
    return shots;
}

std::filesystem::path StoreJournal::downloadFolder() const {
    return m_store.use([](const store::SurveyStore& store) { return store.downloadFolder(); });
}

} // namespace spherewalk::jobs
