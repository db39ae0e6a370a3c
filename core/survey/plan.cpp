// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/plan.h"

#include "floor.h"
#include "lattice.h"
#include "plan_limits.h"
#include "route.h"

#include "spherewalk/base/text.h"
#include "spherewalk/survey/walking_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

/// One axis' rails in walking order.
struct Layout {
    std::vector<Rail> rails;
    std::vector<Leg> route;
    double carriedM = 0;
};

Layout layout(const std::vector<Rail>& rails, const Lattice& lattice, const Floor& floor,
              const WalkingDistance& walking) {
    std::vector<RailEnds> ends;
    for (const Rail& rail : rails) {
        const int begin = rail.alongX ? rail.column : rail.row;
        const int line = rail.alongX ? rail.row : rail.column;
        const int last = begin + rail.stops - 1;
        const Vector2d end = rail.alongX ? lattice.at(last, line) : lattice.at(line, last);
        ends.push_back({floor.anchor() + lattice.at(rail.column, rail.row), floor.anchor() + end, line, begin,
                        begin + rail.stops});
    }
    Layout result{rails, shortRoute(ends, walking), 0};
    result.carriedM = carryingDistance(ends, result.route, walking);
    return result;
}

Layout bestLayout(const Lattice& lattice, const Floor& floor, const WalkingDistance& walking,
                  const PlanOptions& options) {
    const std::vector<Rail> alongX = railsAlong(true, lattice, floor, options);
    const std::vector<Rail> alongY = railsAlong(false, lattice, floor, options);
    if (alongX.size() != alongY.size()) {
        return layout(alongX.size() < alongY.size() ? alongX : alongY, lattice, floor, walking);
    }
    Layout x = layout(alongX, lattice, floor, walking);
    Layout y = layout(alongY, lattice, floor, walking);
    return y.carriedM < x.carriedM - kEqualM ? std::move(y) : std::move(x);
}

RailPlacement placementOf(const Rail& rail, bool backwards, const Lattice& lattice, const Floor& floor) {
    const int far = backwards ? rail.stops - 1 : 0;
    const Vector2d origin =
        lattice.at(rail.column + (rail.alongX ? far : 0), rail.row + (rail.alongX ? 0 : far));
    const double quarter = std::numbers::pi / 2;
    const double heading = rail.alongX ? (backwards ? 2 * quarter : 0) : (backwards ? -quarter : quarter);
    return {floor.anchor() + origin, Radians(heading), rail.stops, lattice.stepM};
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

} // namespace

Vector2d RailPlacement::stop(int k) const {
    return origin + k * stepM * Vector2d(cos(heading), sin(heading));
}

Plan plan(const Room& room, const PlanOptions& options) {
    room.validate();
    options.validate(room);
    const Floor floor(room);
    const Lattice lattice = bestLattice(floor, options);
    refuseTooMany(lattice.freeCount(), options);
    const WalkingDistance walking(room);
    const Layout best = bestLayout(lattice, floor, walking, options);
    Plan result;
    for (const Leg& leg : best.route) {
        const int index = static_cast<int>(result.placements.size());
        result.placements.push_back(
            placementOf(best.rails[static_cast<std::size_t>(leg.rail)], leg.backwards, lattice, floor));
        const RailPlacement& placement = result.placements.back();
        for (int k = 0; k < placement.stops; ++k) {
            const Vector2d at = placement.stop(k);
            for (const double height : options.heightsM) {
                result.stations.push_back({index, k, {at.x(), at.y(), height}});
            }
        }
    }
    return result;
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

} // namespace spherewalk::survey
