// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/polygon.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk {

using Eigen::Vector2d;

namespace {

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double distance(const Vector2d& point, const Vector2d& begin, const Vector2d& end) {
    const Vector2d along = end - begin;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((point - begin).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (begin + t * along - point).norm();
}

/// True if the segments have a point in common.
bool meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    const double ac = cross(b - a, c - a);
    const double ad = cross(b - a, d - a);
    const double ca = cross(d - c, a - c);
    const double cb = cross(d - c, b - c);
    if (((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0))) {
        return true;
    }
    return distance(c, a, b) == 0 || distance(d, a, b) == 0 || distance(a, c, d) == 0 ||
           distance(b, c, d) == 0;
}

double distance(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    return meet(a, b, c, d)
               ? 0
               : std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

const Vector2d& after(const Polygon& polygon, std::size_t i) {
    return polygon[(i + 1) % polygon.size()];
}

} // namespace

double signedArea(const Polygon& polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        // Relative to the first vertex: a room at 10^6 m keeps its digits.
        doubled += cross(polygon[i] - polygon[0], after(polygon, i) - polygon[0]);
    }
    return doubled / 2;
}

std::optional<std::string> defect(const Polygon& polygon) {
    if (polygon.size() < 3) {
        return text("it has ", polygon.size(), " corners, and needs at least three");
    }
    if (!std::all_of(polygon.begin(), polygon.end(), [](const Vector2d& v) { return v.allFinite(); })) {
        return "a coordinate is not a number";
    }
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (polygon[i] == after(polygon, i)) {
            return text("corners ", i + 1, " and ", (i + 1) % n + 1, " are the same point");
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d& a = polygon[i];
        const Vector2d& b = after(polygon, i);
        const Vector2d& c = after(polygon, i + 1);
        if (cross(b - a, c - b) == 0 && (b - a).dot(c - b) < 0) {
            return text("at corner ", (i + 1) % n + 1, " it turns back on itself");
        }
        for (std::size_t j = i + 2; j < n; ++j) {
            const bool neighbours = i == 0 && j == n - 1;
            if (!neighbours && meet(a, b, polygon[j], after(polygon, j))) {
                return text("the wall after corner ", i + 1, " crosses the wall after corner ", j + 1);
            }
        }
    }
    return std::nullopt;
}

bool contains(const Polygon& polygon, const Vector2d& point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d a = polygon[i] - point;
        const Vector2d b = after(polygon, i) - point;
        if (distance(Vector2d::Zero(), a, b) == 0) {
            return true;
        }
        if ((a.y() > 0) != (b.y() > 0)) {
            const double turn = cross(a, b);
            inside ^= (b.y() > a.y()) == (turn > 0);
        }
    }
    return inside;
}

double distanceToEdge(const Polygon& polygon, const Vector2d& point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        least = std::min(least, distance(point, polygon[i], after(polygon, i)));
    }
    return least;
}

double distanceToEdge(const Polygon& polygon, const Vector2d& begin, const Vector2d& end) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        least = std::min(least, distance(begin, end, polygon[i], after(polygon, i)));
    }
    return least;
}

Bounds2 bounds(const Polygon& polygon) {
    Bounds2 result{polygon.front(), polygon.front()};
    for (const Vector2d& vertex : polygon) {
        result.least = result.least.cwiseMin(vertex);
        result.greatest = result.greatest.cwiseMax(vertex);
    }
    return result;
}

} // namespace spherewalk
