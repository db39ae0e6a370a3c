// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/named_photo.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <utility>

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

} // namespace spherewalk::cli
