// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"

#include "spherewalk/base/text.h"

#include <array>

namespace spherewalk::store {

namespace {

/// Positions are in the room frame in metres, times ISO 8601 in UTC, hashes SHA-256 in lower-case
/// hexadecimal.
constexpr const char* kVersion1 = R"sql(
CREATE TABLE survey (
    id INTEGER PRIMARY KEY CHECK (id = 1),
    uuid TEXT NOT NULL,
    name TEXT NOT NULL,
    created_utc TEXT NOT NULL,
    ceiling_m REAL NOT NULL,
    step_m REAL NOT NULL,
    rail_stops INTEGER NOT NULL,
    clearance_m REAL NOT NULL,
    seconds_per_photo REAL NOT NULL,
    seconds_per_placement REAL NOT NULL
) STRICT;

CREATE TABLE lens_height (
    rank INTEGER PRIMARY KEY,
    height_m REAL NOT NULL UNIQUE
) STRICT;

-- Polygon 0 is the outline, the others are obstacles.
CREATE TABLE corner (
    polygon INTEGER NOT NULL CHECK (polygon >= 0),
    corner INTEGER NOT NULL CHECK (corner >= 0),
    x_m REAL NOT NULL,
    y_m REAL NOT NULL,
    PRIMARY KEY (polygon, corner)
) STRICT, WITHOUT ROWID;

-- Ids follow the walking order.
CREATE TABLE placement (
    id INTEGER PRIMARY KEY,
    x_m REAL NOT NULL,
    y_m REAL NOT NULL,
    heading_rad REAL NOT NULL,
    stops INTEGER NOT NULL CHECK (stops > 0),
    step_m REAL NOT NULL CHECK (step_m > 0)
) STRICT;

-- Ids follow the walking order; without a placement: outside the plan.
CREATE TABLE station (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    placement INTEGER REFERENCES placement (id),
    stop INTEGER NOT NULL CHECK (stop >= 0),
    x_m REAL NOT NULL,
    y_m REAL NOT NULL,
    z_m REAL NOT NULL,
    name TEXT NOT NULL,
    UNIQUE (placement, stop, z_m)
) STRICT;

CREATE TABLE photo (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    station INTEGER NOT NULL REFERENCES station (id),
    file_name TEXT NOT NULL COLLATE NOCASE UNIQUE,
    camera_file_name TEXT NOT NULL,
    camera_serial TEXT NOT NULL,
    file_url TEXT NOT NULL,
    camera_sha256 TEXT NOT NULL UNIQUE CHECK (length(camera_sha256) = 64),
    file_sha256 TEXT NOT NULL CHECK (length(file_sha256) = 64),
    size_bytes INTEGER NOT NULL CHECK (size_bytes > 0),
    width INTEGER NOT NULL CHECK (width > 0),
    height INTEGER NOT NULL CHECK (height > 0),
    taken_utc TEXT,
    added_utc TEXT NOT NULL,
    x_m REAL NOT NULL,
    y_m REAL NOT NULL,
    z_m REAL NOT NULL,
    is_chosen INTEGER NOT NULL CHECK (is_chosen IN (0, 1)),
    note TEXT NOT NULL
) STRICT;
CREATE INDEX photo_station ON photo (station);
CREATE UNIQUE INDEX photo_chosen ON photo (station) WHERE is_chosen = 1;

CREATE TABLE shot (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    station INTEGER NOT NULL REFERENCES station (id),
    step TEXT NOT NULL CHECK (step IN ('intended', 'started', 'taken', 'downloaded', 'not_taken', 'unclear')),
    intended_utc TEXT NOT NULL,
    changed_utc TEXT NOT NULL,
    camera_serial TEXT NOT NULL,
    latest_file_url TEXT NOT NULL,
    total_entries INTEGER NOT NULL,
    command_id TEXT NOT NULL DEFAULT '',
    file_url TEXT NOT NULL DEFAULT '',
    note TEXT NOT NULL DEFAULT '',
    photo INTEGER UNIQUE REFERENCES photo (id),
    CHECK ((step = 'downloaded') = (photo IS NOT NULL))
) STRICT;
CREATE INDEX shot_step ON shot (step);

CREATE TABLE solution (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    source TEXT NOT NULL,
    created_utc TEXT NOT NULL,
    model TEXT NOT NULL,
    report TEXT NOT NULL,
    is_active INTEGER NOT NULL CHECK (is_active IN (0, 1))
) STRICT;
CREATE UNIQUE INDEX solution_active ON solution (is_active) WHERE is_active = 1;

CREATE TABLE solution_photo (
    solution INTEGER NOT NULL REFERENCES solution (id) ON DELETE CASCADE,
    photo INTEGER NOT NULL REFERENCES photo (id),
    qw REAL NOT NULL,
    qx REAL NOT NULL,
    qy REAL NOT NULL,
    qz REAL NOT NULL,
    x_m REAL NOT NULL,
    y_m REAL NOT NULL,
    z_m REAL NOT NULL,
    sigma_yaw_rad REAL,
    sigma_pitch_rad REAL,
    sigma_roll_rad REAL,
    sigma_position_m REAL,
    status TEXT NOT NULL,
    flags TEXT NOT NULL,
    PRIMARY KEY (solution, photo)
) STRICT, WITHOUT ROWID;
)sql";

/// What people decided; a photo without a row is open.
constexpr const char* kVersion2 = R"sql(
CREATE TABLE review (
    photo INTEGER PRIMARY KEY REFERENCES photo (id),
    decision TEXT NOT NULL CHECK (decision IN ('open', 'accepted', 'rejected')),
    note TEXT NOT NULL,
    changed_utc TEXT NOT NULL
) STRICT;
)sql";

/// How the camera is set; without a row, as it is. What is NULL is the camera's to choose.
constexpr const char* kVersion3 = R"sql(
CREATE TABLE capture_profile (
    id INTEGER PRIMARY KEY CHECK (id = 1),
    iso INTEGER,
    shutter_s REAL,
    compensation_ev REAL NOT NULL,
    white_balance TEXT NOT NULL,
    colour_temperature_k INTEGER,
    photo_width INTEGER
) STRICT;
)sql";

/// What the checks found, as JSON: an array of {"flaw", "quality", "sentence"}. A photo without a row was not
/// judged.
constexpr const char* kVersion4 = R"sql(
CREATE TABLE verdict (
    photo INTEGER PRIMARY KEY REFERENCES photo (id),
    quality TEXT NOT NULL CHECK (quality IN ('good', 'doubtful', 'failed')),
    findings TEXT NOT NULL,
    judged_utc TEXT NOT NULL
) STRICT;
)sql";

/// The names of a flat's rooms, and where they are written.
constexpr const char* kVersion5 = R"sql(
CREATE TABLE room_name (
    rank INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    x_m REAL NOT NULL,
    y_m REAL NOT NULL
) STRICT;
ALTER TABLE station ADD COLUMN is_place_known INTEGER NOT NULL DEFAULT 1 CHECK (is_place_known IN (0, 1));
)sql";

/// Rails that a person has laid.
constexpr const char* kVersion6 = R"sql(
ALTER TABLE survey ADD COLUMN is_by_hand INTEGER NOT NULL DEFAULT 0 CHECK (is_by_hand IN (0, 1));
ALTER TABLE placement ADD COLUMN is_locked INTEGER NOT NULL DEFAULT 0 CHECK (is_locked IN (0, 1));
)sql";

/// What nobody shall recognise outside of the survey. Regions that a person has rejected stay, so that no
/// later search brings them back. A photo without a row of face_search was never searched.
constexpr const char* kVersion7 = R"sql(
CREATE TABLE private_region (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    photo INTEGER NOT NULL REFERENCES photo (id),
    azimuth_rad REAL NOT NULL,
    elevation_rad REAL NOT NULL,
    width_rad REAL NOT NULL CHECK (width_rad > 0),
    height_rad REAL NOT NULL CHECK (height_rad > 0),
    origin TEXT NOT NULL CHECK (origin IN ('found', 'marked', 'rejected')),
    changed_utc TEXT NOT NULL
) STRICT;
CREATE INDEX private_region_photo ON private_region (photo);

CREATE TABLE face_search (
    photo INTEGER PRIMARY KEY REFERENCES photo (id),
    method INTEGER NOT NULL,
    searched_utc TEXT NOT NULL
) STRICT;
)sql";

/// Whether a person drew the room of a survey without rails. Else it is the one that solved photos show.
constexpr const char* kVersion8 = R"sql(
ALTER TABLE survey ADD COLUMN is_room_drawn INTEGER NOT NULL DEFAULT 0 CHECK (is_room_drawn IN (0, 1));
)sql";

/// Whether nobody has said how high the lens is. Photos by hand of older surveys have what was the default.
constexpr const char* kVersion9 = R"sql(
ALTER TABLE survey ADD COLUMN are_heights_guessed INTEGER NOT NULL DEFAULT 0 CHECK (are_heights_guessed IN (0, 1));
UPDATE survey SET are_heights_guessed = 1 WHERE NOT EXISTS (SELECT 1 FROM placement)
    AND NOT EXISTS (SELECT 1 FROM lens_height WHERE height_m <> 1.2);
)sql";

constexpr std::array kMigrations{Migration{1, kVersion1}, Migration{2, kVersion2}, Migration{3, kVersion3},
                                 Migration{4, kVersion4}, Migration{5, kVersion5}, Migration{6, kVersion6},
                                 Migration{7, kVersion7}, Migration{8, kVersion8}, Migration{9, kVersion9}};

void apply(Database& database, const Migration& migration) {
    Transaction transaction(database);
    database.execute(migration.sql);
    database.execute(text("PRAGMA user_version = ", migration.version));
    if (database.query("SELECT * FROM pragma_foreign_key_check").step()) {
        database.failCorrupt("rows refer to others that are not there");
    }
    transaction.commit();
}

} // namespace

std::span<const Migration> migrations() {
    return kMigrations;
}

int newestVersion(std::span<const Migration> all) {
    return all.back().version;
}

Identity identity(const Database& database) {
    return {database.integer("PRAGMA application_id"), database.integer("PRAGMA user_version")};
}

void makeSchema(Database& database, std::span<const Migration> all) {
    database.execute("PRAGMA journal_mode = WAL");
    database.execute(text("PRAGMA application_id = ", kApplicationId));
    for (const Migration& migration : all) {
        apply(database, migration);
    }
}

void migrate(Database& database, std::span<const Migration> all) {
    const std::int64_t from = identity(database).version;
    if (from >= newestVersion(all)) {
        return;
    }
    std::filesystem::path copy = database.file();
    copy += text(".before-v", newestVersion(all));
    database.copyTo(copy);
    for (const Migration& migration : all) {
        if (migration.version > from) {
            apply(database, migration);
        }
    }
}

} // namespace spherewalk::store
