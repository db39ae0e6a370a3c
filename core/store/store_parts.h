// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.h"
#include "writer_lock.h"

#include "spherewalk/store/survey_store.h"

#include <optional>
#include <string_view>

namespace spherewalk::store {

/// What a store holds, and what its functions share.
struct SurveyStore::Parts {
    std::filesystem::path folder;
    std::optional<WriterLock> lock; ///< outlives the database, which may still write when it is closed
    std::optional<Database> database;

    const Database& db() const { return *database; }

    /// The database for a change. Errors: InvalidInput if the survey is open for reading.
    const Database& writable() const;
    /// Errors: NotFound.
    void requireStation(std::int64_t station) const;
    /// Errors: NotFound.
    void requirePhoto(std::int64_t photo) const;
    [[noreturn]] void failNotFound(std::string_view what, std::int64_t id) const;
    /// The moment that a column spells.
    Moment moment(const Statement& row, int column) const;
    /// Inside the caller's transaction.
    std::int64_t insertPhoto(const NewPhoto& photo) const;
    /// Inside the caller's transaction.
    void movePhoto(const MovedPhoto& moved) const;
};

/// The SQL condition on a row of `photo` that it is chosen and was not rejected.
inline constexpr const char* kIsKept =
    "is_chosen = 1 AND id NOT IN (SELECT photo FROM review WHERE decision = 'rejected')";

/// Now, as the database keeps it.
std::string nowUtc();

/// Room, options, stations and placements into an empty database, inside the caller's transaction.
void insertPlan(const Database& database, const survey::Room& room, const survey::PlanOptions& options,
                const survey::Plan& plan);

/// In place of what was there, inside the caller's transaction.
void insertProfile(const Database& database, const std::optional<survey::CaptureProfile>& profile);

/// Errors: InvalidInput, for a plan whose stations and placements do not fit each other or the numbers are
/// not finite.
void checkPlan(const survey::Plan& plan);

/// Errors: InvalidInput for text that is no UTF-8, has control characters, or is longer than a sentence of
/// this length.
void checkText(std::string_view what, std::string_view value, std::size_t maxBytes = 1000);

} // namespace spherewalk::store
