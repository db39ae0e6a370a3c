// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.h"

#include "spherewalk/store/survey_store.h"

#include <optional>
#include <string_view>

namespace spherewalk::store {

/// What a store holds, and what its functions share.
struct SurveyStore::Parts {
    std::filesystem::path folder;
    std::optional<WriterLock> lock; ///< Stands first, because the database may still write when it is closed.
    std::optional<Database> database;

    /// The database for queries.
    const Database& db() const { return *database; }

    /// The database for a change. Errors: InvalidInput if the survey is open for reading.
    Database& writable();
    /// Errors: NotFound for an unknown station.
    void requireStation(std::int64_t station) const;
    /// Errors: NotFound for an unknown photo.
    void requirePhoto(std::int64_t photo) const;
    /// Throws NotFound. what: "photo", for example.
    [[noreturn]] void failNotFound(std::string_view what, std::int64_t id) const;
    /// The moment that a column holds. Errors: Corrupt.
    Moment moment(const Statement& row, int column) const;
    /// Records a photo inside the caller's transaction, and returns its identity.
    std::int64_t insertPhoto(const NewPhoto& photo);
    /// Moves a photo inside the caller's transaction. Returns whether it left the active solution.
    bool movePhoto(const MovedPhoto& moved);
};

/// The SQL condition on a row of `photo` that it is chosen and was not rejected.
inline constexpr const char* kIsKept =
    "is_chosen = 1 AND id NOT IN (SELECT photo FROM review WHERE decision = 'rejected')";

/// The SQL condition on a row of `station` that a photo belongs there: it is planned, or has one.
inline constexpr const char* kIsWanted = "(placement IS NOT NULL OR id IN (SELECT station FROM photo))";

/// The present moment as the database spells it.
std::string nowUtc();

/// Writes room, options, stations and placements in place of earlier ones, inside the caller's transaction.
void insertPlan(Database& database, const survey::Room& room, const survey::PlanOptions& options,
                const survey::Plan& plan);

/// Writes the profile in place of an earlier one, inside the caller's transaction.
void insertProfile(Database& database, const std::optional<survey::CaptureProfile>& profile);

/// Errors: InvalidInput for a plan whose stations do not fit its placements, or whose numbers are not finite.
void checkPlan(const survey::Plan& plan);

/// Errors: InvalidInput for text that is no UTF-8, has control characters, or has more than maxBytes. what:
/// the name of the text in the error's sentence.
void checkText(std::string_view what, std::string_view value, std::size_t maxBytes = 1000);

} // namespace spherewalk::store
