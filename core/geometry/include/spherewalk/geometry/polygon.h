// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace spherewalk {

/// A closed polygon on the floor, in metres; its last vertex is joined to the first. It may be concave.
using Polygon = std::vector<Eigen::Vector2d>;

/// The area in square metres, positive for a counter-clockwise polygon and negative for a clockwise one.
double signedArea(const Polygon& polygon);

/// The reason why the polygon cannot be used, as the end of a sentence; nothing if it can be used. Reasons
/// are fewer than three vertices, values that are not finite, edges that touch or cross, and no area.
std::optional<std::string> defect(const Polygon& polygon);

/// True for a point inside the polygon or on its edge.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

/// The distance in metres from a point, inside or outside, to the nearest edge.
double distanceToEdge(const Polygon& polygon, const Eigen::Vector2d& point);

/// The smallest distance in metres between a segment and the polygon's edges; 0 if they cross.
double distanceToEdge(const Polygon& polygon, const Eigen::Vector2d& begin, const Eigen::Vector2d& end);

/// A rectangle along the axes, in metres.
struct Bounds2 {
    Eigen::Vector2d least;
    Eigen::Vector2d greatest;
};

/// The smallest rectangle around the polygon. Range: at least one vertex.
Bounds2 bounds(const Polygon& polygon);

} // namespace spherewalk
