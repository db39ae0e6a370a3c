// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace spherewalk::survey {

/// What a person holds the end of a tape to.
struct TapeOrigin {
    enum class Kind {
        Corner,
        FirstStop,
        LastStop,
        Wall, ///< The tape runs square to the wall.
    };

    Kind kind = Kind::Corner;
    /// Of a corner of the outline, of a rail in Plan::placements, or of the corner at which a wall begins.
    int index = 0;

    bool operator==(const TapeOrigin&) const = default;
};

/// A distance that a person lays with a tape.
struct TapeDistance {
    TapeOrigin from;
    double metres = 0;
};

/// By how much a tape may be read wrong. MarkedPoint::errorM says what comes of that.
inline constexpr double kReadingErrorM = 0.005;
/// The error of a place that the tapes are chosen to stay below.
inline constexpr double kMostPlaceErrorM = 0.020;
/// Distances are printed in millimetres. The place that they give is this near to the plan.
inline constexpr double kMostPrintedErrorM = 0.001;

/// A point of the floor and the tapes that find it.
struct MarkedPoint {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    /// Two tapes with a free line to the point; empty where nothing in sight fixes the point.
    std::vector<TapeDistance> tapes;
    /// A third distance, to see whether the point is right; nothing where no third origin is seen.
    std::optional<TapeDistance> check;
    /// How far the point is off at most if every tape is read wrong by up to kReadingErrorM. The tapes of
    /// the rails that the point hangs on count as well.
    std::optional<double> errorM;
};

/// Where the operator lays one rail.
struct RailMark {
    int placement = 0; ///< Index into Plan::placements.
    MarkedPoint first; ///< Stop 0 of the rail.
    MarkedPoint last;  ///< The last stop of the rail; equal to `first` for a single stop.
};

/// The tape distances of every rail placement, in walking order. Tapes run over free floor from two corners,
/// and the pair that fixes the point best is taken. Pairs whose tapes also meet at a second point in the room
/// come last. A point that corners do not fix well enough hangs on rails that are marked, and on walls where
/// rails do not suffice either. Errors: those of Room::validate().
std::vector<RailMark> railMarks(const Room& room, const Plan& plan);

/// The place where a tape to this point begins. Range: the origin is one of the room or of the plan.
Eigen::Vector2d placeOf(const TapeOrigin& origin, const Eigen::Vector2d& point, const Room& room,
                        const Plan& plan);

/// The letters by which people call a wall: "A-B". Range: 0 <= index < corners of the outline.
std::string wallName(const Room& room, int index);

/// The letters by which people call a corner of the outline: "A", "B" ... "Z", "AA". Range: index >= 0.
std::string cornerName(int index);

/// The place of the letter of each corner: on the free floor before its corner, and nearer to it than to any
/// other. At a thin wall the letters of its two sides thus cannot be confused. Letters keep clear of walls,
/// obstacles, rails and each other where there is room. Frames: room. Units: metres.
/// awayM: the wanted distance from the corner. radiusM: half the size of a letter.
/// Errors: those of Room::validate().
std::vector<Eigen::Vector2d> cornerLabels(const Room& room, const Plan& plan, double awayM, double radiusM);

} // namespace spherewalk::survey
