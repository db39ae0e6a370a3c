// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/photo_intake.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/photo/integrity.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/position_tag.h"

#include <cstdio>

namespace spherewalk::jobs {

namespace {

/// The moment that the camera's local time and zone stand for; nothing without a zone, which would be a
/// guess.
std::optional<store::Moment> takenAt(const photo::PhotoMetadata& metadata) {
    int year = 0;
    unsigned month = 0;
    unsigned day = 0;
    int hour = 0;
    int minute = 0;
    int second = 0;
    char sign = 0;
    int zoneHour = 0;
    int zoneMinute = 0;
    if (std::sscanf(metadata.takenAt.c_str(), "%4d-%2u-%2uT%2d:%2d:%2d", &year, &month, &day, &hour, &minute,
                    &second) != 6 ||
        std::sscanf(metadata.timeZone.c_str(), "%c%2d:%2d", &sign, &zoneHour, &zoneMinute) != 3) {
        return std::nullopt;
    }
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                           std::chrono::day(day)};
    if (!date.ok()) {
        return std::nullopt;
    }
    const std::chrono::minutes zone = std::chrono::hours(zoneHour) + std::chrono::minutes(zoneMinute);
    return std::chrono::sys_days(date) + std::chrono::hours(hour) + std::chrono::minutes(minute) +
           std::chrono::seconds(second) - (sign == '-' ? -zone : zone);
}

} // namespace

TaggedPhoto tagged(const Arrival& arrival, const std::string& surveyId, const std::string& stationName) {
    const photo::PhotoFacts facts = photo::checkPhoto(arrival.jpeg, arrival.source);
    const photo::PhotoMetadata metadata = photo::readMetadata(arrival.jpeg, arrival.source);
    TaggedPhoto result;
    result.file = arrival.isPlaced ? photo::withPositionTag(arrival.jpeg,
                                                            {surveyId, arrival.station, stationName,
                                                             arrival.positionM, arrival.roomFromPhoto},
                                                            arrival.source)
                                   : arrival.jpeg;
    store::NewPhoto& row = result.row;
    row.station = arrival.station;
    row.fileSha256 = sha256Hex(result.file);
    row.cameraFileName = arrival.cameraFileName;
    row.cameraSerial = arrival.cameraSerial;
    row.fileUrl = arrival.fileUrl;
    row.cameraSha256 = facts.sha256;
    row.sizeBytes = result.file.size();
    row.width = facts.width;
    row.height = facts.height;
    row.takenAt = takenAt(metadata);
    row.positionM = arrival.positionM;
    return result;
}

store::NewPhoto put(const store::SurveyStore& store, TaggedPhoto photo) {
    photo.row.fileName = store.freePhotoName(photo.row.cameraFileName, photo.row.fileSha256);
    try {
        writeFile(store.photoFolder() / photo.row.fileName, photo.file);
    } catch (const Error& error) {
        // A folder of this computer that is gone must not look like a photo that the camera does not have.
        throw Error(error.kind() == ErrorKind::NotFound ? ErrorKind::Io : error.kind(), error.sentence(),
                    error.context());
    }
    return std::move(photo.row);
}

store::NewPhoto takeIn(const store::SurveyStore& store, const Arrival& arrival) {
    return put(store, tagged(arrival, store.info().uuid, store.station(arrival.station).name));
}

} // namespace spherewalk::jobs
