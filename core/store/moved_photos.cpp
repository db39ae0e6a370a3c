// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo_checks.h"
#include "store_parts.h"

#include "spherewalk/base/text.h"

#include <set>

namespace spherewalk::store {

namespace {

std::int64_t stationOf(const Database& database, std::int64_t photo) {
    Statement row = database.query("SELECT station FROM photo WHERE id = ?", photo);
    row.step();
    return row.integer(0);
}

void chooseNewest(const Database& database, std::int64_t station) {
    database.run("UPDATE photo SET is_chosen = 1 WHERE id = (SELECT max(id) FROM photo WHERE station = ?1) "
                 "AND NOT EXISTS (SELECT 1 FROM photo WHERE station = ?1 AND is_chosen = 1)",
                 station);
}

} // namespace

void SurveyStore::Parts::movePhoto(const MovedPhoto& moved) const {
    requireStation(moved.station);
    checkPhotoFile(folder / "photos" / moved.fileName, moved.sizeBytes);
    if (moved.choose) {
        db().run("UPDATE photo SET is_chosen = 0 WHERE station = ?", moved.station);
    }
    db().run("UPDATE photo SET station = ?, x_m = ?, y_m = ?, z_m = ?, file_name = ?, file_sha256 = ?, "
             "size_bytes = ?, is_chosen = ? WHERE id = ?",
             moved.station, moved.positionM.x(), moved.positionM.y(), moved.positionM.z(), moved.fileName,
             moved.fileSha256, static_cast<std::int64_t>(moved.sizeBytes), moved.choose, moved.photo);
}

void SurveyStore::movePhotos(const std::vector<MovedPhoto>& photos) {
    const Database& database = m_parts->writable();
    Transaction transaction(database);
    std::set<std::int64_t> stations;
    for (const MovedPhoto& moved : photos) {
        m_parts->requirePhoto(moved.photo);
        checkPhotoName(moved.fileName, moved.fileSha256, moved.positionM);
        stations.insert({stationOf(database, moved.photo), moved.station});
        // Photos that change places must not stand in each other's way.
        database.run("UPDATE photo SET is_chosen = 0 WHERE id = ?", moved.photo);
    }
    for (const MovedPhoto& moved : photos) {
        m_parts->movePhoto(moved);
    }
    for (const std::int64_t station : stations) {
        chooseNewest(database, station);
    }
    transaction.commit();
}

} // namespace spherewalk::store
