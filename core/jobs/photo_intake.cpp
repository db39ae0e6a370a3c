// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo_intake.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
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

store::NewPhoto takeIn(const store::SurveyStore& store, const Arrival& arrival) {
    const photo::PhotoFacts facts = photo::checkPhoto(arrival.jpeg, arrival.source);
    const photo::PhotoMetadata metadata = photo::readMetadata(arrival.jpeg, arrival.source);
    const store::StationRecord station = store.station(arrival.station);
    const Bytes tagged = photo::withPositionTag(
        arrival.jpeg,
        {store.info().uuid, arrival.station, station.name, arrival.positionM, arrival.roomFromPhoto},
        arrival.source);
    store::NewPhoto photo;
    photo.station = arrival.station;
    photo.fileSha256 = sha256Hex(tagged);
    photo.fileName = store.freePhotoName(arrival.cameraFileName, photo.fileSha256);
    photo.cameraFileName = arrival.cameraFileName;
    photo.cameraSerial = arrival.cameraSerial;
    photo.fileUrl = arrival.fileUrl;
    photo.cameraSha256 = facts.sha256;
    photo.sizeBytes = tagged.size();
    photo.width = facts.width;
    photo.height = facts.height;
    photo.takenAt = takenAt(metadata);
    photo.positionM = arrival.positionM;
    writeFile(store.photoFolder() / photo.fileName, tagged);
    return photo;
}

} // namespace spherewalk::jobs
