// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo_names.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::cli {

store::PhotoRecord photoNamed(const store::SurveyStore& store, const std::string& name) {
    for (store::PhotoRecord& photo : store.photos()) {
        if (photo.fileName == name || text(static_cast<long long>(photo.id)) == name) {
            return std::move(photo);
        }
    }
    for (store::PhotoRecord& photo : store.chosenPhotos()) {
        if (store.station(photo.station).name == name) {
            return std::move(photo);
        }
    }
    throw Error(ErrorKind::NotFound, text("There is no photo ", printable(name), " in the survey ",
                                          store.folder().string(), "; review lists them."));
}

store::StationRecord stationNamed(const store::SurveyStore& store, const std::string& name) {
    for (store::StationRecord& station : store.stations()) {
        if (station.name == name || text(static_cast<long long>(station.id)) == name) {
            return std::move(station);
        }
    }
    throw Error(ErrorKind::NotFound, text("There is no station ", printable(name), " in the survey ",
                                          store.folder().string(), "; plan --json lists them."));
}

} // namespace spherewalk::cli
