// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/error.h"

namespace spherewalk::store {

using survey::CaptureProfile;

namespace {

constexpr int kMostOfAny = 1'000'000; // what is too much for a camera is said by the profile

std::optional<int> optionalInteger(const Statement& row, int column) {
    return row.isNull(column) ? std::nullopt
                              : std::optional(static_cast<int>(row.integer(column, 0, kMostOfAny)));
}

} // namespace

void insertProfile(const Database& database, const std::optional<CaptureProfile>& profile) {
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
    const Database& database = m_parts->writable();
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
