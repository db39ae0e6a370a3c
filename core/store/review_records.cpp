// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"

namespace spherewalk::store {

namespace {

constexpr EnumNames<Decision, 3> kDecisionNames{
    {{Decision::Open, "open"}, {Decision::Accepted, "accepted"}, {Decision::Rejected, "rejected"}}};

Review reviewOf(const Database& database, const Statement& row) {
    try {
        return {row.integer(0), decisionNamed(row.text(1)), row.text(2)};
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::InvalidInput) {
            database.failCorrupt("a decision in it is none");
        }
        throw;
    }
}

PhotoVerdict verdictOf(const Database& database, const Statement& row) {
    try {
        return {row.integer(0), survey::qualityNamed(row.text(1)), row.text(2)};
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::InvalidInput) {
            database.failCorrupt("a verdict in it is none");
        }
        throw;
    }
}

void checkFindings(const std::string& findings) {
    constexpr JsonLimits kLimits{1 << 20, 8};
    try {
        if (parseJson(findings, "the findings on a photo", kLimits).is_array()) {
            return;
        }
    } catch (const Error& error) {
        throw Error(ErrorKind::InvalidInput, error.sentence(), error.context());
    }
    throw Error(ErrorKind::InvalidInput, "The findings on a photo are not a JSON array.");
}

} // namespace

std::string_view name(Decision decision) {
    return nameOf(kDecisionNames, decision);
}

Decision decisionNamed(std::string_view name) {
    return valueOf(kDecisionNames, "The decision", name);
}

void SurveyStore::setReview(const Review& review) {
    checkText("note on the photo", review.note, 4000);
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requirePhoto(review.photo);
    if (review.decision == Decision::Open && review.note.empty()) {
        database.run("DELETE FROM review WHERE photo = ?", review.photo);
    } else {
        database.run("INSERT OR REPLACE INTO review VALUES (?, ?, ?, ?)", review.photo,
                     std::string(name(review.decision)), review.note, nowUtc());
    }
    transaction.commit();
}

std::vector<Review> SurveyStore::reviews() const {
    const Database& database = m_parts->db();
    Statement rows = database.query("SELECT photo, decision, note FROM review ORDER BY photo");
    std::vector<Review> result;
    while (rows.step()) {
        result.push_back(reviewOf(database, rows));
    }
    return result;
}

Review SurveyStore::review(std::int64_t photo) const {
    const Database& database = m_parts->db();
    m_parts->requirePhoto(photo);
    Statement row = database.query("SELECT photo, decision, note FROM review WHERE photo = ?", photo);
    return row.step() ? reviewOf(database, row) : Review{photo, Decision::Open, {}};
}

void SurveyStore::setVerdict(const PhotoVerdict& verdict) {
    checkFindings(verdict.findings);
    Database& database = m_parts->writable();
    Transaction transaction(database);
    m_parts->requirePhoto(verdict.photo);
    database.run("INSERT OR REPLACE INTO verdict VALUES (?, ?, ?, ?)", verdict.photo, name(verdict.quality),
                 verdict.findings, nowUtc());
    transaction.commit();
}

std::vector<PhotoVerdict> SurveyStore::verdicts() const {
    const Database& database = m_parts->db();
    Statement rows = database.query("SELECT photo, quality, findings FROM verdict ORDER BY photo");
    std::vector<PhotoVerdict> result;
    while (rows.step()) {
        result.push_back(verdictOf(database, rows));
    }
    return result;
}

std::optional<PhotoVerdict> SurveyStore::verdict(std::int64_t photo) const {
    const Database& database = m_parts->db();
    m_parts->requirePhoto(photo);
    Statement row = database.query("SELECT photo, quality, findings FROM verdict WHERE photo = ?", photo);
    return row.step() ? std::optional(verdictOf(database, row)) : std::nullopt;
}

} // namespace spherewalk::store
