// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/survey/room.h"

#include <optional>
#include <string>
#include <vector>

namespace spherewalk::survey {

/// What an outline file says of a room. Units: metres.
struct Outline {
    Polygon outline;
    std::vector<Polygon> obstacles;
    std::optional<double> ceilingM; ///< if the file says it
};

/// Reads [[x,y],...], or {"outline":[[x,y],...],"obstacles":[[[x,y],...],...],"ceiling_m":2.6} with the last
/// two optional. source: the file's name, for the sentence. Errors: Corrupt for other shapes and for more
/// corners than kMostRoomCorners; whether the room makes sense is for Room::validate().
Outline parseOutline(const Json& value, const std::string& source);

/// The same document, as parseOutline reads it.
Json outlineJson(const Room& room);

} // namespace spherewalk::survey
