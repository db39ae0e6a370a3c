// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <cmath>
#include <set>

namespace spherewalk::store {

namespace {

constexpr const char* kSelectSolution =
    "SELECT id, source, model, report, created_utc, is_active FROM solution ";
constexpr std::size_t kMostJsonBytes = 16 << 20;

void checkJson(std::string_view what, const std::string& json) {
    try {
        parseJson(json, what, {.maxBytes = kMostJsonBytes, .maxDepth = 64});
    } catch (const Error& error) {
        throw Error(ErrorKind::InvalidInput, error.sentence(), error.context());
    }
}

void checkSigma(const std::optional<double>& sigma) {
    if (sigma && !(std::isfinite(*sigma) && *sigma >= 0)) {
        throw Error(ErrorKind::InvalidInput,
                    "The solution cannot be recorded: a standard deviation is not a number from 0 up.");
    }
}

void checkSolved(const SolvedPhoto& solved) {
    const Eigen::Quaterniond& q = solved.roomFromPhoto;
    checkedQuaternion(q.w(), q.x(), q.y(), q.z(), text("photo ", static_cast<long long>(solved.photo)));
    if (!solved.positionM.allFinite()) {
        throw Error(ErrorKind::InvalidInput, text("The solution cannot be recorded: the position of photo ",
                                                  static_cast<long long>(solved.photo), " is not a number."));
    }
    for (const auto& sigma :
         {solved.sigmaYawRad, solved.sigmaPitchRad, solved.sigmaRollRad, solved.sigmaPositionM}) {
        checkSigma(sigma);
    }
    checkJson("the flags of a solved photo", solved.flags);
}

void checkSolution(const NewSolution& solution) {
    checkText("source of the solution", solution.source);
    checkText("model of the solution", solution.model);
    checkJson("the report of the solution", solution.report);
    std::set<std::int64_t> photos;
    for (const SolvedPhoto& solved : solution.photos) {
        checkSolved(solved);
        if (!photos.insert(solved.photo).second) {
            throw Error(ErrorKind::InvalidInput, text("The solution cannot be recorded: it has photo ",
                                                      static_cast<long long>(solved.photo), " twice."));
        }
    }
}

void insertSolved(Database& database, std::int64_t solution, const SolvedPhoto& solved) {
    const Eigen::Quaterniond& q = solved.roomFromPhoto;
    database.run("INSERT INTO solution_photo VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", solution,
                 solved.photo, q.w(), q.x(), q.y(), q.z(), solved.positionM.x(), solved.positionM.y(),
                 solved.positionM.z(), solved.sigmaYawRad, solved.sigmaPitchRad, solved.sigmaRollRad,
                 solved.sigmaPositionM, name(solved.quality), solved.flags);
}

void activate(Database& database, std::int64_t solution) {
    database.run("UPDATE solution SET is_active = 0 WHERE is_active = 1");
    database.run("UPDATE solution SET is_active = 1 WHERE id = ?", solution);
}

SolvedPhoto solvedOf(const Database& database, const Statement& row) {
    SolvedPhoto solved;
    solved.photo = row.integer(0);
    try {
        solved.roomFromPhoto =
            checkedQuaternion(row.real(1), row.real(2), row.real(3), row.real(4), "a solved photo");
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
        database.failCorrupt("a solved rotation is none");
    }
    try {
        solved.quality = survey::qualityNamed(row.text(12));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
        database.failCorrupt("the verdict on a solved photo is none");
    }
    solved.positionM = {row.real(5), row.real(6), row.real(7)};
    solved.sigmaYawRad = row.optionalReal(8);
    solved.sigmaPitchRad = row.optionalReal(9);
    solved.sigmaRollRad = row.optionalReal(10);
    solved.sigmaPositionM = row.optionalReal(11);
    solved.flags = row.text(13);
    return solved;
}

} // namespace

std::int64_t SurveyStore::addSolution(const NewSolution& solution, bool isActive) {
    checkSolution(solution);
    Database& database = m_parts->writable();
    Transaction transaction(database);
    const bool isFirst = !database.query("SELECT 1 FROM solution").step();
    database.run(
        "INSERT INTO solution (source, created_utc, model, report, is_active) VALUES (?, ?, ?, ?, 0)",
        solution.source, nowUtc(), solution.model, solution.report);
    const std::int64_t id = database.lastInsertId();
    for (const SolvedPhoto& solved : solution.photos) {
        photo(solved.photo);
        insertSolved(database, id, solved);
    }
    if (isActive || isFirst) {
        activate(database, id);
    }
    transaction.commit();
    return id;
}

std::vector<SolutionRecord> SurveyStore::solutions() const {
    std::vector<SolutionRecord> result;
    Statement rows = m_parts->db().query(text(kSelectSolution, "ORDER BY id DESC"));
    while (rows.step()) {
        result.push_back({rows.integer(0), rows.text(1), rows.text(2), rows.text(3), m_parts->moment(rows, 4),
                          rows.boolean(5)});
    }
    return result;
}

std::optional<SolutionRecord> SurveyStore::activeSolution() const {
    for (SolutionRecord& solution : solutions()) {
        if (solution.isActive) {
            return std::move(solution);
        }
    }
    return std::nullopt;
}

std::vector<SolvedPhoto> SurveyStore::solvedPhotos(std::int64_t solution) const {
    const Database& database = m_parts->db();
    if (!database.query("SELECT 1 FROM solution WHERE id = ?", solution).step()) {
        m_parts->failNotFound("solution", solution);
    }
    Statement rows =
        database.query("SELECT photo, qw, qx, qy, qz, x_m, y_m, z_m, sigma_yaw_rad, sigma_pitch_rad, "
                       "sigma_roll_rad, sigma_position_m, status, flags FROM solution_photo "
                       "WHERE solution = ? ORDER BY photo",
                       solution);
    std::vector<SolvedPhoto> result;
    while (rows.step()) {
        result.push_back(solvedOf(database, rows));
    }
    return result;
}

} // namespace spherewalk::store
