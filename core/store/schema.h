// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.h"

#include <span>

namespace spherewalk::store {

inline constexpr std::int64_t kApplicationId = 0x53706857; ///< "SphW"

/// Takes a database of the version before to this version.
struct Migration {
    int version;
    const char* sql;
};

/// All there are, versions 1, 2, ... in order. The last is what this program reads and writes.
std::span<const Migration> migrations();

int newestVersion(std::span<const Migration> all);

/// What the database says of itself.
struct Identity {
    std::int64_t applicationId = 0;
    std::int64_t version = 0;
};

Identity identity(const Database& database);

/// Makes an empty database a survey of the newest version.
void makeSchema(const Database& database, std::span<const Migration> all);

/// Brings an older survey up to date, version by version, each in one transaction, after a copy was kept as
/// `<file>.before-v<newest>`. Nothing happens to one that is up to date.
void migrate(const Database& database, std::span<const Migration> all);

} // namespace spherewalk::store
