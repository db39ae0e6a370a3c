// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/walking_distance.h"

#include "floor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// How far from a corner a person turns around it; keeps paths from touching the walls that meet there.
constexpr double kTurnM = 0.02;
/// Corners beyond this many are left out, most blunt first: paths then become longer than they need be, not
/// wrong.
constexpr std::size_t kMostTurns = 200;

struct Turn {
    Vector2d point;
    double sharpness = 0;
};

/// Points beside the corners around which a shortest path can bend.
std::vector<Vector2d> turns(const Floor& floor) {
    std::vector<Turn> found;
    for (std::size_t which = 0; which < floor.polygons().size(); ++which) {
        const Polygon& polygon = floor.polygons()[which];
        const double orientation = signedArea(polygon) > 0 ? 1 : -1;
        // The floor lies inside the outline and outside obstacles.
        const double floorSide = which == 0 ? orientation : -orientation;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2d before =
                (polygon[i] - polygon[(i + polygon.size() - 1) % polygon.size()]).normalized();
            const Vector2d after = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
            const double turn = (before.x() * after.y() - before.y() * after.x()) * floorSide;
            const Vector2d away = before - after;
            const Vector2d point = polygon[i] + kTurnM * away.normalized();
            if (turn < 0 && floor.has(point)) {
                found.push_back({point, away.norm()});
            }
        }
    }
    if (found.size() > kMostTurns) {
        std::stable_sort(found.begin(), found.end(),
                         [](const Turn& a, const Turn& b) { return a.sharpness > b.sharpness + kEqualM; });
        found.resize(kMostTurns);
    }
    std::vector<Vector2d> points;
    points.reserve(found.size());
    for (const Turn& turn : found) {
        points.push_back(turn.point);
    }
    return points;
}

} // namespace

struct WalkingDistance::Graph {
    explicit Graph(const Room& room) : floor(room), corners(turns(floor)) {}

    Floor floor;
    std::vector<Vector2d> corners; ///< local
    std::vector<std::vector<double>> between;
};

WalkingDistance::WalkingDistance(const Room& room) : m_graph(std::make_unique<Graph>(room)) {
    const std::vector<Vector2d>& corners = m_graph->corners;
    const std::size_t n = corners.size();
    auto& between = m_graph->between;
    between.assign(n, std::vector<double>(n, kInfinity));
    for (std::size_t i = 0; i < n; ++i) {
        between[i][i] = 0;
        for (std::size_t j = i + 1; j < n; ++j) {
            if (m_graph->floor.sees(corners[i], corners[j])) {
                between[i][j] = between[j][i] = (corners[i] - corners[j]).norm();
            }
        }
    }
    for (std::size_t via = 0; via < n; ++via) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                between[i][j] = std::min(between[i][j], between[i][via] + between[via][j]);
            }
        }
    }
}

WalkingDistance::~WalkingDistance() = default;
WalkingDistance::WalkingDistance(WalkingDistance&&) noexcept = default;
WalkingDistance& WalkingDistance::operator=(WalkingDistance&&) noexcept = default;

WalkingDistance::Place WalkingDistance::place(const Vector2d& point) const {
    const std::vector<Vector2d>& corners = m_graph->corners;
    Place result{point - m_graph->floor.anchor(), std::vector<double>(corners.size(), kInfinity), {}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (m_graph->floor.sees(result.point, corners[i])) {
            result.seenCorners.push_back(static_cast<int>(i));
        }
    }
    for (const int seen : result.seenCorners) {
        const auto via = static_cast<std::size_t>(seen);
        const double toVia = (result.point - corners[via]).norm();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            result.toCorner[i] = std::min(result.toCorner[i], toVia + m_graph->between[via][i]);
        }
    }
    return result;
}

double WalkingDistance::between(const Place& from, const Place& to) const {
    const double straight = (from.point - to.point).norm();
    if (m_graph->floor.sees(from.point, to.point)) {
        return straight;
    }
    double least = kInfinity;
    for (const int seen : to.seenCorners) {
        const auto via = static_cast<std::size_t>(seen);
        least = std::min(least, from.toCorner[via] + (to.point - m_graph->corners[via]).norm());
    }
    return std::isfinite(least) ? least : straight;
}

double WalkingDistance::between(const Vector2d& from, const Vector2d& to) const {
    return between(place(from), place(to));
}

} // namespace spherewalk::survey
