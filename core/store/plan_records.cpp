// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <map>

namespace spherewalk::store {

using survey::CaptureProfile;
using survey::Plan;
using survey::PlanOptions;
using survey::RailPlacement;
using survey::Room;
using survey::Station;

namespace {

constexpr int kMostRailStops = 1'000'000;
constexpr const char* kSelectStation =
    "SELECT id, name, placement, stop, x_m, y_m, z_m, is_place_known FROM station ";

void insertPolygon(Database& database, int index, const Polygon& polygon) {
    Statement insert(database, "INSERT INTO corner VALUES (?, ?, ?, ?)");
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        insert.with(index, static_cast<std::int64_t>(i), polygon[i].x(), polygon[i].y()).step();
        insert.reset();
    }
}

void insertStations(Database& database, const Plan& plan) {
    Statement placement(database, "INSERT INTO placement VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        const RailPlacement& rail = plan.placements[i];
        placement.with(static_cast<std::int64_t>(i + 1), rail.origin.x(), rail.origin.y(),
                       rail.heading.value(), rail.stops, rail.stepM, rail.isLocked ? 1 : 0);
        placement.step();
        placement.reset();
    }
    const std::vector<std::string> names = survey::stationNames(plan);
    Statement insert(database,
                     "INSERT INTO station (placement, stop, x_m, y_m, z_m, name) VALUES (?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < plan.stations.size(); ++i) {
        const Station& station = plan.stations[i];
        const auto rail =
            station.placement < 0 ? std::nullopt : std::optional<std::int64_t>(station.placement + 1);
        insert.with(rail, station.stop, station.positionM.x(), station.positionM.y(), station.positionM.z(),
                    names[i]);
        insert.step();
        insert.reset();
    }
}

StationRecord stationOf(const Statement& row) {
    StationRecord record;
    record.id = row.integer(0);
    record.name = row.text(1);
    record.station.placement =
        row.isNull(2) ? -1 : static_cast<int>(row.integer(2, 1, survey::kMostStations)) - 1;
    record.station.stop = static_cast<int>(row.integer(3, 0, kMostRailStops));
    record.station.positionM = {row.real(4), row.real(5), row.real(6)};
    record.isPlaceKnown = row.boolean(7);
    return record;
}

std::vector<StationRecord> allStations(Statement rows) {
    std::vector<StationRecord> result;
    while (rows.step()) {
        result.push_back(stationOf(rows));
    }
    return result;
}

std::vector<RailPlacement> placements(const Database& database) {
    std::vector<RailPlacement> result;
    Statement rows = database.query(
        "SELECT id, x_m, y_m, heading_rad, stops, step_m, is_locked FROM placement ORDER BY id");
    while (rows.step()) {
        const auto next = static_cast<std::int64_t>(result.size()) + 1;
        if (next > survey::kMostStations) {
            database.failCorrupt("it lists more rail placements than a plan can have");
        }
        rows.integer(0, next, next); // stations refer to them by number
        result.push_back({{rows.real(1), rows.real(2)},
                          Radians(rows.real(3)),
                          static_cast<int>(rows.integer(4, 1, kMostRailStops)),
                          rows.real(5),
                          rows.boolean(6)});
    }
    return result;
}

/// The store's room and options were valid when they were written.
template <class Check>
void checkStored(const Database& database, Check&& check) {
    try {
        check();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
        database.failCorrupt(text("its plan cannot be (", error.sentence(), ")"));
    }
}

constexpr int kMostOfAny = 1'000'000; // what is too much for a camera is said by the profile

std::optional<int> optionalInteger(const Statement& row, int column) {
    return row.isNull(column) ? std::nullopt
                              : std::optional(static_cast<int>(row.integer(column, 0, kMostOfAny)));
}

} // namespace

void checkPlan(const Plan& plan) {
    const auto refuse = [](const std::string& why) {
        throw Error(ErrorKind::InvalidInput, text("The plan cannot be recorded: ", why, "."));
    };
    if (plan.stations.size() > survey::kMostStations || plan.placements.size() > survey::kMostStations) {
        refuse(text("it has more than ", survey::kMostStations, " stations"));
    }
    for (const RailPlacement& rail : plan.placements) {
        if (!rail.origin.allFinite() || !std::isfinite(rail.heading.value()) || !(rail.stepM > 0) ||
            !std::isfinite(rail.stepM) || rail.stops < 1 || rail.stops > kMostRailStops) {
            refuse("a rail placement has numbers that no rail can have");
        }
    }
    for (const Station& station : plan.stations) {
        const int count = static_cast<int>(plan.placements.size());
        const bool onRail = station.placement >= 0;
        if (!station.positionM.allFinite() || station.placement < -1 || station.placement >= count ||
            station.stop < 0 ||
            (onRail && station.stop >= plan.placements[static_cast<std::size_t>(station.placement)].stops)) {
            refuse("a station is not on the rail that it names");
        }
    }
}

void insertRoom(Database& database, const Room& room) {
    for (const char* table : {"corner", "room_name"}) {
        database.execute(text("DELETE FROM ", table));
    }
    database.run("UPDATE survey SET ceiling_m = ?", room.ceilingM);
    insertPolygon(database, 0, room.outline);
    for (std::size_t i = 0; i < room.obstacles.size(); ++i) {
        insertPolygon(database, static_cast<int>(i) + 1, room.obstacles[i]);
    }
    for (std::size_t i = 0; i < room.names.size(); ++i) {
        database.run("INSERT INTO room_name VALUES (?, ?, ?, ?)", static_cast<std::int64_t>(i),
                     room.names[i].name, room.names[i].at.x(), room.names[i].at.y());
    }
}

void insertHeights(Database& database, std::span<const double> heightsM, bool areGuessed) {
    database.execute("DELETE FROM lens_height");
    for (std::size_t i = 0; i < heightsM.size(); ++i) {
        database.run("INSERT INTO lens_height VALUES (?, ?)", static_cast<std::int64_t>(i), heightsM[i]);
    }
    database.run("UPDATE survey SET are_heights_guessed = ?", areGuessed ? 1 : 0);
}

void insertPlan(Database& database, const Room& room, const PlanOptions& options, const Plan& plan) {
    for (const char* table : {"station", "placement"}) {
        database.execute(text("DELETE FROM ", table));
    }
    database.run("UPDATE survey SET step_m = ?, rail_stops = ?, clearance_m = ?, seconds_per_photo = ?, "
                 "seconds_per_placement = ?, is_by_hand = ?",
                 options.stepM, options.railStops, options.clearanceM, options.secondsPerPhoto,
                 options.secondsPerPlacement, plan.isByHand ? 1 : 0);
    insertHeights(database, options.heightsM, options.areHeightsGuessed);
    insertRoom(database, room);
    insertStations(database, plan);
}

Room SurveyStore::room() const {
    const Database& database = m_parts->db();
    Room room;
    Statement survey = database.query("SELECT ceiling_m FROM survey");
    room.ceilingM = survey.step() ? survey.real(0) : 0;
    Statement rows = database.query("SELECT polygon, x_m, y_m FROM corner ORDER BY polygon, corner");
    std::size_t corners = 0;
    while (rows.step()) {
        const auto polygon = static_cast<std::size_t>(rows.integer(
            0, 0, static_cast<std::int64_t>(room.obstacles.size()) + (room.outline.empty() ? 0 : 1)));
        if (++corners > survey::kMostRoomCorners) {
            database.failCorrupt("its room has more corners than a room can have");
        }
        if (polygon > room.obstacles.size()) {
            room.obstacles.emplace_back();
        }
        (polygon == 0 ? room.outline : room.obstacles[polygon - 1]).emplace_back(rows.real(1), rows.real(2));
    }
    Statement names = database.query("SELECT name, x_m, y_m FROM room_name ORDER BY rank LIMIT 1000");
    while (names.step()) {
        room.names.push_back({names.text(0), {names.real(1), names.real(2)}});
    }
    checkStored(database, [&] { room.validate(); });
    return room;
}

PlanOptions SurveyStore::planOptions() const {
    const Database& database = m_parts->db();
    Statement row = database.query("SELECT step_m, rail_stops, clearance_m, seconds_per_photo, "
                                   "seconds_per_placement, are_heights_guessed FROM survey");
    if (!row.step()) {
        database.failCorrupt("it does not say how it was planned");
    }
    PlanOptions options{.stepM = row.real(0),
                        .heightsM = {},
                        .railStops = static_cast<int>(row.integer(1, 1, kMostRailStops)),
                        .clearanceM = row.real(2),
                        .secondsPerPhoto = row.real(3),
                        .secondsPerPlacement = row.real(4),
                        .areHeightsGuessed = row.boolean(5)};
    Statement heights = database.query("SELECT height_m FROM lens_height ORDER BY rank LIMIT 1000");
    while (heights.step()) {
        options.heightsM.push_back(heights.real(0));
    }
    const Room inRoom = room();
    checkStored(database, [&] { options.validate(inRoom); });
    return options;
}

Plan SurveyStore::plan() const {
    Plan plan;
    Statement survey = m_parts->db().query("SELECT is_by_hand FROM survey");
    plan.isByHand = survey.step() && survey.boolean(0);
    plan.placements = placements(m_parts->db());
    for (StationRecord& record : stations()) {
        if (record.station.placement >= static_cast<int>(plan.placements.size())) {
            m_parts->db().failCorrupt("a station names a rail placement that is not there");
        }
        plan.stations.push_back(std::move(record.station));
    }
    return plan;
}

void SurveyStore::replacePlan(const Room& room, const PlanOptions& options, const Plan& plan) {
    room.validate();
    options.validate(room);
    checkPlan(plan);
    Database& database = m_parts->writable();
    Transaction transaction(database);
    if (database.query("SELECT 1 FROM photo UNION ALL SELECT 1 FROM shot").step()) {
        throw Error(
            ErrorKind::InvalidInput,
            text("Could not replace the plan of the survey ", folder().string(),
                 ": photos have been taken at its stations; create another survey for the new plan."));
    }
    insertPlan(database, room, options, plan);
    transaction.commit();
}

void SurveyStore::setLensHeight(double heightM) {
    PlanOptions options = planOptions();
    options.heightsM = {heightM};
    options.validate(room());
    Database& database = m_parts->writable();
    Transaction transaction(database);
    if (database.query("SELECT 1 FROM placement").step()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not set the height of the lens in the survey ", folder().string(),
                         ": its rails were planned for the cart's."));
    }
    insertHeights(database, options.heightsM, false);
    transaction.commit();
}

void SurveyStore::replaceRoom(const Room& room, RoomOrigin origin) {
    room.validate();
    Database& database = m_parts->writable();
    Transaction transaction(database);
    if (database.query("SELECT 1 FROM placement").step()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not replace the room of the survey ", folder().string(),
                         ": its rails were planned for the room as it is."));
    }
    insertRoom(database, room);
    database.run("UPDATE survey SET is_room_drawn = ?", origin == RoomOrigin::Drawn ? 1 : 0);
    transaction.commit();
}

Room SurveyStore::knownRoom() const {
    Room stored = room();
    const bool hasRails = m_parts->db().query("SELECT 1 FROM placement").step();
    const bool isKnown =
        hasRails || roomOrigin() == RoomOrigin::Drawn || stored.outline != survey::unknownRoom().outline;
    return isKnown ? std::move(stored) : Room();
}

RoomOrigin SurveyStore::roomOrigin() const {
    Statement survey = m_parts->db().query("SELECT is_room_drawn FROM survey");
    return survey.step() && survey.boolean(0) ? RoomOrigin::Drawn : RoomOrigin::Solved;
}

std::vector<StationRecord> SurveyStore::stations() const {
    return allStations(m_parts->db().query(text(kSelectStation, "ORDER BY id")));
}

StationRecord SurveyStore::station(std::int64_t id) const {
    Statement row = m_parts->db().query(text(kSelectStation, "WHERE id = ?"), id);
    if (!row.step()) {
        m_parts->failNotFound("station", id);
    }
    return stationOf(row);
}

std::vector<StationRecord> SurveyStore::stationsWithoutPhoto() const {
    return allStations(m_parts->db().query(text(kSelectStation, "WHERE ", kIsWanted,
                                                " AND id NOT IN (SELECT station FROM photo WHERE ", kIsKept,
                                                ") ORDER BY id")));
}

std::int64_t SurveyStore::addStation(const Eigen::Vector3d& positionM, const std::string& name,
                                     bool isPlaceKnown) {
    if (!positionM.allFinite()) {
        throw Error(ErrorKind::InvalidInput, "The station cannot be added: its position is not a number.");
    }
    checkText("name of the station", name);
    const Plan single{.placements = {}, .stations = {{-1, 0, positionM}}};
    Database& database = m_parts->writable();
    Transaction transaction(database);
    database.run("INSERT INTO station (placement, stop, x_m, y_m, z_m, name, is_place_known) "
                 "VALUES (NULL, 0, ?, ?, ?, ?, ?)",
                 positionM.x(), positionM.y(), positionM.z(),
                 name.empty() ? survey::stationName(single, 0) : name, isPlaceKnown ? 1 : 0);
    const std::int64_t id = database.lastInsertId();
    transaction.commit();
    return id;
}

void SurveyStore::placeStations(const std::vector<PlacedStation>& places) {
    Database& database = m_parts->writable();
    Transaction transaction(database);
    for (const PlacedStation& place : places) {
        const StationRecord before = station(place.station);
        if (before.station.placement >= 0 || !place.positionM.allFinite()) {
            throw Error(ErrorKind::InvalidInput,
                        text("The station ", printable(before.name), " cannot be moved: ",
                             place.positionM.allFinite() ? "it is part of the plan."
                                                         : "its position is not a number."));
        }
        checkText("name of the station", place.name);
        const Eigen::Vector3d& p = place.positionM;
        database.run(
            "UPDATE station SET x_m = ?, y_m = ?, z_m = ?, name = ?, is_place_known = ? WHERE id = ?", p.x(),
            p.y(), p.z(), place.name.empty() ? before.name : place.name, place.isPlaceKnown ? 1 : 0,
            place.station);
    }
    transaction.commit();
}

void SurveyStore::removeStation(std::int64_t id) {
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requireStation(id);
    if (!database
             .query("SELECT 1 FROM station WHERE id = ?1 AND placement IS NULL AND NOT EXISTS (SELECT 1 FROM "
                    "photo WHERE station = ?1) AND NOT EXISTS (SELECT 1 FROM shot WHERE station = ?1)",
                    id)
             .step()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The station ", printable(station(id).name),
                         " cannot be removed: it is part of the plan, or has a photo or a shot."));
    }
    database.run("DELETE FROM station WHERE id = ?", id);
    transaction.commit();
}

void insertProfile(Database& database, const std::optional<CaptureProfile>& profile) {
    database.run("DELETE FROM capture_profile");
    if (profile) {
        database.run("INSERT INTO capture_profile VALUES (1, ?, ?, ?, ?, ?, ?)", profile->iso,
                     profile->shutterS, profile->compensationEv,
                     std::string(survey::name(profile->whiteBalance)), profile->colourTemperatureK,
                     profile->photoWidth);
    }
}

void SurveyStore::setCaptureProfile(const std::optional<CaptureProfile>& profile) {
    if (profile) {
        profile->validate();
    }
    Database& database = m_parts->writable();
    Transaction transaction(database);
    insertProfile(database, profile);
    transaction.commit();
}

std::optional<CaptureProfile> SurveyStore::captureProfile() const {
    const Database& database = m_parts->db();
    Statement row = database.query("SELECT iso, shutter_s, compensation_ev, white_balance, "
                                   "colour_temperature_k, photo_width FROM capture_profile");
    if (!row.step()) {
        return std::nullopt;
    }
    try {
        const CaptureProfile profile{.iso = optionalInteger(row, 0),
                                     .shutterS = row.optionalReal(1),
                                     .compensationEv = row.real(2),
                                     .whiteBalance = survey::whiteBalanceNamed(row.text(3)),
                                     .colourTemperatureK = optionalInteger(row, 4),
                                     .photoWidth = optionalInteger(row, 5)};
        profile.validate();
        return profile;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::InvalidInput) {
            database.failCorrupt("its capture profile is none");
        }
        throw;
    }
}

} // namespace spherewalk::store
