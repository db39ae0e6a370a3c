// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"

namespace spherewalk::store {

namespace {

constexpr EnumNames<RegionOrigin, 3> kOriginNames{
    {{RegionOrigin::Found, "found"}, {RegionOrigin::Marked, "marked"}, {RegionOrigin::Rejected, "rejected"}}};

constexpr const char* kColumns =
    "SELECT id, photo, azimuth_rad, elevation_rad, width_rad, height_rad, origin FROM private_region ";

RegionRecord regionOf(const Database& database, const Statement& row) {
    RegionRecord record{
        row.integer(0),
        row.integer(1),
        {Radians(row.real(2)), Radians(row.real(3)), Radians(row.real(4)), Radians(row.real(5))},
        RegionOrigin::Marked};
    try {
        record.region.validate();
        record.origin = valueOf(kOriginNames, "The origin", row.text(6));
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::InvalidInput) {
            database.failCorrupt("a private region in it is none");
        }
        throw;
    }
    return record;
}

std::vector<RegionRecord> regionsOf(const Database& database, Statement rows) {
    std::vector<RegionRecord> result;
    while (rows.step()) {
        result.push_back(regionOf(database, rows));
    }
    return result;
}

void insertRegion(Database& database, const std::optional<std::int64_t>& id, std::int64_t photo,
                  const survey::PrivateRegion& region, RegionOrigin origin) {
    database.run("INSERT OR REPLACE INTO private_region VALUES (?, ?, ?, ?, ?, ?, ?, ?)", id, photo,
                 region.azimuth.value(), region.elevation.value(), region.width.value(),
                 region.height.value(), name(origin), nowUtc());
}

} // namespace

std::string_view name(RegionOrigin origin) {
    return nameOf(kOriginNames, origin);
}

std::vector<RegionRecord> SurveyStore::regions() const {
    const Database& database = m_parts->db();
    return regionsOf(database, database.query(std::string(kColumns) + "ORDER BY photo, id"));
}

std::vector<RegionRecord> SurveyStore::regions(std::int64_t photo) const {
    const Database& database = m_parts->db();
    m_parts->requirePhoto(photo);
    return regionsOf(database, database.query(std::string(kColumns) + "WHERE photo = ? ORDER BY id", photo));
}

std::int64_t SurveyStore::markRegion(std::int64_t photo, const survey::PrivateRegion& region) {
    region.validate();
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requirePhoto(photo);
    insertRegion(database, std::nullopt, photo, region, RegionOrigin::Marked);
    const std::int64_t id = database.lastInsertId();
    transaction.commit();
    return id;
}

void SurveyStore::removeRegion(std::int64_t region) {
    Database& database = m_parts->writable();
    Transaction transaction(database);
    database.run("DELETE FROM private_region WHERE id = ? AND origin = 'marked'", region);
    if (database.changes() == 0) {
        database.run("UPDATE private_region SET origin = 'rejected', changed_utc = ? WHERE id = ? AND origin "
                     "= 'found'",
                     nowUtc(), region);
    }
    if (database.changes() == 0) {
        m_parts->failNotFound("private region", region);
    }
    transaction.commit();
}

void SurveyStore::restoreRegion(const RegionRecord& region) {
    region.region.validate();
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requirePhoto(region.photo);
    insertRegion(database, region.id, region.photo, region.region, region.origin);
    transaction.commit();
}

std::size_t SurveyStore::setFoundRegions(std::int64_t photo, const std::vector<survey::PrivateRegion>& found,
                                         int method) {
    for (const survey::PrivateRegion& region : found) {
        region.validate();
    }
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requirePhoto(photo);
    database.run("DELETE FROM private_region WHERE photo = ? AND origin = 'found'", photo);
    std::vector<survey::PrivateRegion> known;
    for (const RegionRecord& record : regions(photo)) {
        known.push_back(record.region);
    }
    std::size_t added = 0;
    for (const survey::PrivateRegion& region : found) {
        if (!survey::isAmong(region, known)) {
            insertRegion(database, std::nullopt, photo, region, RegionOrigin::Found);
            ++added;
        }
    }
    database.run("INSERT OR REPLACE INTO face_search VALUES (?, ?, ?)", photo, method, nowUtc());
    transaction.commit();
    return added;
}

std::vector<std::int64_t> SurveyStore::searchedPhotos(int method) const {
    Statement rows =
        m_parts->db().query("SELECT photo FROM face_search WHERE method = ? ORDER BY photo", method);
    std::vector<std::int64_t> photos;
    while (rows.step()) {
        photos.push_back(rows.integer(0));
    }
    return photos;
}

} // namespace spherewalk::store
