// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/plan.h"

#include "floor.h"
#include "rails.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/survey/laid_rails.h"
#include "spherewalk/survey/room_parts.h"
#include "spherewalk/survey/walking_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

/// Rails in walking order.
struct Layout {
    std::vector<RailPlacement> rails;
    double carriedM = 0;
};

RailPlacement placementOf(const Rail& rail, const StopGrid& grid, const Floor& floor) {
    return {floor.anchor() + grid.at(rail.column, rail.row), Radians(rail.alongX ? 0 : std::numbers::pi / 2),
            rail.stops, grid.stepM};
}

/// Locked rails are lines of their own, after those of the grid.
Layout layout(const std::vector<Rail>& rails, std::span<const RailPlacement> locked, const StopGrid& grid,
              const Floor& floor, const WalkingDistance& walking) {
    std::vector<RailPlacement> all;
    std::vector<RailEnds> ends;
    const auto add = [&](const RailPlacement& rail, int line, int begin) {
        all.push_back(rail);
        ends.push_back({rail.origin, rail.stop(rail.stops - 1), line, begin, begin + rail.stops});
    };
    for (const Rail& rail : rails) {
        add(placementOf(rail, grid, floor), rail.alongX ? rail.row : rail.column,
            rail.alongX ? rail.column : rail.row);
    }
    int line = std::max(grid.rows, grid.columns);
    for (const RailPlacement& rail : locked) {
        add(rail, line += 2, 0); // no neighbours
    }
    const std::vector<Leg> route = shortRoute(ends, walking);
    Layout result{{}, carryingDistance(ends, route, walking)};
    for (const Leg& leg : route) {
        const RailPlacement& rail = all[static_cast<std::size_t>(leg.rail)];
        result.rails.push_back(leg.backwards ? reversed(rail) : rail);
    }
    return result;
}

Layout bestLayout(const StopGrid& grid, std::span<const RailPlacement> locked, const Floor& floor,
                  const WalkingDistance& walking, const PlanOptions& options) {
    const std::vector<Rail> alongX = railsAlong(true, grid, floor, options);
    const std::vector<Rail> alongY = railsAlong(false, grid, floor, options);
    if (alongX.size() != alongY.size()) {
        return layout(alongX.size() < alongY.size() ? alongX : alongY, locked, grid, floor, walking);
    }
    Layout x = layout(alongX, locked, grid, floor, walking);
    Layout y = layout(alongY, locked, grid, floor, walking);
    return y.carriedM < x.carriedM - kEqualM ? std::move(y) : std::move(x);
}

int stopsOf(std::span<const RailPlacement> rails) {
    int stops = 0;
    for (const RailPlacement& rail : rails) {
        stops += rail.stops;
    }
    return stops;
}

std::string metres(double value) {
    return fixed(value == 0 ? 0 : value, 2); // no "-0.00"
}

bool hasSeveralHeights(const Plan& plan) {
    const auto planned = [](const Station& station) { return station.placement >= 0; };
    const auto first = std::find_if(plan.stations.begin(), plan.stations.end(), planned);
    return std::any_of(first, plan.stations.end(), [&](const Station& station) {
        return planned(station) && std::abs(station.positionM.z() - first->positionM.z()) > kEqualM;
    });
}

std::string stationName(const Station& station, bool severalHeights) {
    if (station.placement < 0) {
        return text("unplanned position (", metres(station.positionM.x()), ", ",
                    metres(station.positionM.y()), ")");
    }
    const std::string height = severalHeights ? text(" at ", metres(station.positionM.z()), " m") : "";
    return text("rail ", station.placement + 1, ", stop ", station.stop + 1, height);
}

constexpr double kLeastStepM = 0.01;
constexpr double kGreatestStepM = 100;
constexpr double kGreatestClearanceM = 100;
constexpr double kSlowestPaceS = 86400;
constexpr std::size_t kMostHeights = 50;
constexpr double kLeastHeightDifferenceM = 0.001;
/// Of the grid over the room's bounds, most of which may lie outside the room.
constexpr double kMostGridPoints = 1e6;

[[noreturn]] void refusePlan(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkRange(const char* what, double value, double least, double greatest, const char* unit) {
    if (!(value >= least && value <= greatest)) { // also refuses NaN
        refusePlan(text("The ", what, " of ", value, " ", unit, " cannot be used: give ", least, " to ",
                        greatest, " ", unit, "."));
    }
}

void checkHeights(const std::vector<double>& heights, double ceilingM) {
    if (heights.empty() || heights.size() > kMostHeights) {
        refusePlan(text("A plan needs from one to ", kMostHeights, " heights of the lens, not ",
                        heights.size(), "."));
    }
    for (const double height : heights) {
        if (!(height > 0 && height < ceilingM)) {
            refusePlan(text("The lens cannot be at ", height,
                            " m: give heights above the floor and below the ceiling, "
                            "which is at ",
                            ceilingM, " m."));
        }
    }
    std::vector<double> sorted = heights;
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::adjacent_find(sorted.begin(), sorted.end(), [](double low, double high) {
        return high - low < kLeastHeightDifferenceM;
    });
    if (same != sorted.end()) {
        refusePlan(text("The height of ", *same, " m is listed twice; list each height once."));
    }
}

double roundedUpToCentimetres(double stepM) {
    return std::ceil(stepM * 100 - 1e-9) / 100;
}

[[noreturn]] void refuseStep(double stepM, double fittingM, const std::string& why) {
    const double suggested = std::max(roundedUpToCentimetres(fittingM), roundedUpToCentimetres(stepM + 1e-6));
    refusePlan(text("A step of ", stepM, " m is too fine for this room: ", why, ". A step of ",
                    fixed(suggested, 2), " m fits."));
}

void checkGridSize(const Room& room, const PlanOptions& options) {
    const Bounds2 extent = bounds(room.outline);
    const Eigen::Array2d free = (extent.greatest - extent.least).array() - 2 * options.clearanceM;
    const auto points = [&](double stepM) { return ((free.max(0.0) / stepM).floor() + 2).prod(); };
    if (points(options.stepM) <= kMostGridPoints) {
        return;
    }
    double fittingM = roundedUpToCentimetres(options.stepM);
    while (points(fittingM) > kMostGridPoints) {
        fittingM = roundedUpToCentimetres(fittingM * 1.02);
    }
    refuseStep(options.stepM, fittingM,
               text("its bounds would hold more than ", static_cast<int>(kMostGridPoints), " stops"));
}

} // namespace

Vector2d RailPlacement::stop(int k) const {
    return origin + k * stepM * Vector2d(cos(heading), sin(heading));
}

RailPlacement reversed(const RailPlacement& rail) {
    RailPlacement result = rail;
    result.origin = rail.stop(rail.stops - 1);
    result.heading = wrapped(rail.heading + Radians(std::numbers::pi));
    return result;
}

void refuseTooMany(int stops, const PlanOptions& options) {
    const double stations = static_cast<double>(stops) * static_cast<double>(options.heightsM.size());
    if (stations > kMostStations) {
        // The floor holds in proportion to the inverse square of the step, up to its edges: hence the
        // reserve.
        refuseStep(options.stepM, options.stepM * std::sqrt(stations / kMostStations) * 1.01,
                   text("it would take ", static_cast<long long>(stations), " stations, more than the ",
                        kMostStations, " of one plan"));
    }
}

Plan withStations(std::vector<RailPlacement> rails, const PlanOptions& options) {
    Plan plan;
    plan.placements = std::move(rails);
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        const RailPlacement& rail = plan.placements[i];
        for (int k = 0; k < rail.stops; ++k) {
            const Vector2d at = rail.stop(k);
            for (const double height : options.heightsM) {
                plan.stations.push_back({static_cast<int>(i), k, {at.x(), at.y(), height}});
            }
        }
    }
    return plan;
}

Plan plan(const Room& room, const PlanOptions& options, std::span<const RailPlacement> locked) {
    room.validate();
    options.validate(room);
    if (!locked.empty()) {
        planOfLaid(room, options, locked);
    }
    const Floor floor(room);
    StopGrid grid = bestStopGrid(floor, options);
    grid.leaveOut(locked, floor.anchor());
    refuseTooMany(grid.freeCount() + stopsOf(locked), options);
    const WalkingDistance walking(room);
    Plan result = withStations(bestLayout(grid, locked, floor, walking, options).rails, options);
    result.isByHand = !locked.empty();
    return roomByRoom(std::move(result), room);
}

std::string stationName(const Plan& plan, std::size_t index) {
    return stationName(plan.stations[index], hasSeveralHeights(plan));
}

std::vector<std::string> stationNames(const Plan& plan) {
    const bool severalHeights = hasSeveralHeights(plan);
    std::vector<std::string> names;
    names.reserve(plan.stations.size());
    for (const Station& station : plan.stations) {
        names.push_back(stationName(station, severalHeights));
    }
    return names;
}

void PlanOptions::validate(const Room& room) const {
    checkRange("step", stepM, kLeastStepM, kGreatestStepM, "m");
    checkRange("clearance", clearanceM, kLeastClearanceM, kGreatestClearanceM, "m");
    checkRange("pace per photo", secondsPerPhoto, 0, kSlowestPaceS, "s");
    checkRange("pace per rail placement", secondsPerPlacement, 0, kSlowestPaceS, "s");
    if (railStops < 1 || railStops > kMostRailStops) {
        refusePlan(text("A rail with ", railStops, " stops cannot be used: give 1 to ", kMostRailStops, "."));
    }
    checkHeights(heightsM, room.ceilingM);
    checkGridSize(room, *this);
}

} // namespace spherewalk::survey
