// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace spherewalk {

/// A closed polygon, last vertex joined to the first; metres on the floor. May be concave, must be simple.
using Polygon = std::vector<Eigen::Vector2d>;

/// Positive for counter-clockwise polygons.
double signedArea(const Polygon& polygon);

/// Why the polygon cannot be used (fewer than three vertices, not finite, edges that touch or cross, no
/// area), as the end of a sentence; nothing if it can.
std::optional<std::string> defect(const Polygon& polygon);

/// True inside and on the edge.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

/// Distance to the nearest edge, whether the point is inside or outside.
double distanceToEdge(const Polygon& polygon, const Eigen::Vector2d& point);

/// Smallest distance between a segment and the polygon's edges; 0 if they cross.
double distanceToEdge(const Polygon& polygon, const Eigen::Vector2d& begin, const Eigen::Vector2d& end);

struct Bounds2 {
    Eigen::Vector2d least;
    Eigen::Vector2d greatest;
};

/// Range: at least one vertex.
Bounds2 bounds(const Polygon& polygon);

} // namespace spherewalk
