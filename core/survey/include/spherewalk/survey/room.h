// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/polygon.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::survey {

inline constexpr double kLargestRoomM = 2000; ///< Longest side that the bounds of a room may have.
inline constexpr double kFarthestCoordinateM =
    1e8; ///< Beyond this coordinate a double no longer holds a micrometre.
inline constexpr std::size_t kMostRoomCorners = 2000; ///< Limit for the outline and all obstacles together.

inline constexpr std::size_t kMostRoomNames = 200;

/// The name that people give to a part of the floor, "kitchen" for example, and where it is written.
struct RoomName {
    std::string name;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();

    bool operator==(const RoomName&) const = default;
};

/// The room's shape. Frames: room. Units: metres.
struct Room {
    Polygon outline; ///< The walls as a polygon on the floor, which may be concave.
    /// Things on the floor that the rail cannot pass. An obstacle may overlap a wall.
    std::vector<Polygon> obstacles;
    double ceilingM = 0; ///< Height of the ceiling above the floor.
    /// The rooms of a flat. A long room may have its name at several places.
    std::vector<RoomName> names = {};

    /// Errors: InvalidInput, naming the polygon and its defect, an obstacle that lies wholly outside the
    /// outline, a room beyond the limits above, a ceiling that is not positive, or a name that is empty, too
    /// long or outside the outline.
    void validate() const;
};

/// Stands for a room of which nothing is known before photos by hand are aligned: 6 x 6 m about the place of
/// the first photo.
Room unknownRoom();

/// What an outline file says of a room. Units: metres.
struct Outline {
    Polygon outline;
    std::vector<Polygon> obstacles;
    std::optional<double> ceilingM; ///< Height of the ceiling, if the file says it.
    std::vector<RoomName> names = {};
};

/// Reads [[x,y],...], or {"outline":[[x,y],...],"obstacles":[[[x,y],...],...],"ceiling_m":2.6,
/// "rooms":[{"name":"kitchen","at":[x,y]},...]} with all but the first member optional. source: the file's
/// name, for the sentence. Errors: Corrupt for other shapes and for more corners than kMostRoomCorners;
/// whether the room makes sense is for Room::validate().
Outline parseOutline(const Json& value, const std::string& source);

/// The room as a document that parseOutline() reads.
Json outlineJson(const Room& room);

} // namespace spherewalk::survey
