// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/laid_rails.h"

#include "floor.h"
#include "rails.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kOnePlaceM = 0.01;

/// A stop of the rail with this index.
struct LaidStop {
    Vector2d at;
    std::size_t rail;
};

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkOnFloor(const Floor& floor, const RailPlacement& rail, std::size_t number) {
    const Vector2d first = rail.origin - floor.anchor();
    const Vector2d last = rail.stop(rail.stops - 1) - floor.anchor();
    const bool isFinite = first.allFinite() && last.allFinite();
    if (!isFinite || !floor.has(first) || !floor.has(last) ||
        !floor.keepsClear(first, last, kLeastClearanceM)) {
        refuse(text("Rail ", number,
                    " cannot lie there: it leaves the floor, or meets a wall or an obstacle; "
                    "move it, or make it shorter."));
    }
}

/// In order of x, only stops within reach along x are compared.
void checkApart(std::vector<LaidStop> stops) {
    std::ranges::sort(stops, {}, [](const LaidStop& stop) { return stop.at.x(); });
    for (std::size_t i = 0; i < stops.size(); ++i) {
        for (std::size_t k = i + 1; k < stops.size() && stops[k].at.x() - stops[i].at.x() < kOnePlaceM; ++k) {
            if (stops[i].rail != stops[k].rail && (stops[i].at - stops[k].at).norm() < kOnePlaceM) {
                const auto [low, high] = std::minmax(stops[i].rail, stops[k].rail);
                refuse(text("Rails ", low + 1, " and ", high + 1,
                            " have a stop at the same place; move one of them."));
            }
        }
    }
}

Vector2d direction(const RailPlacement& rail) {
    return {cos(rail.heading), sin(rail.heading)};
}

} // namespace

Plan planOfLaid(const Room& room, const PlanOptions& options, std::span<const RailPlacement> rails) {
    room.validate();
    options.validate(room);
    const Floor floor(room);
    std::vector<LaidStop> stops;
    for (std::size_t i = 0; i < rails.size(); ++i) {
        checkOnFloor(floor, rails[i], i + 1);
        for (int k = 0; k < rails[i].stops; ++k) {
            stops.push_back({rails[i].stop(k), i});
        }
    }
    refuseTooMany(static_cast<int>(stops.size()), options);
    checkApart(std::move(stops));
    Plan plan = withStations({rails.begin(), rails.end()}, options);
    plan.isByHand = true;
    return plan;
}

RailPlacement moved(RailPlacement rail, const Vector2d& by) {
    rail.origin += by;
    return rail;
}

RailPlacement turned(RailPlacement rail, Radians by) {
    const double half = 0.5 * (rail.stops - 1) * rail.stepM;
    const Vector2d middle = rail.origin + half * direction(rail);
    rail.heading = wrapped(rail.heading + by);
    rail.origin = middle - half * direction(rail);
    return rail;
}

RailPlacement withStops(RailPlacement rail, int stops) {
    rail.stops = stops;
    return rail;
}

RailPlacement laid(const Vector2d& from, const Vector2d& to, double stepM) {
    const Vector2d along = to - from;
    const double steps = std::min(std::round(along.norm() / stepM), double(kMostRailStops - 1));
    const Radians heading(steps > 0 ? std::atan2(along.y(), along.x()) : 0);
    return {from, heading, 1 + static_cast<int>(steps), stepM};
}

RailPlacement pulled(const RailPlacement& rail, RailEnd end, const Vector2d& to) {
    RailPlacement result =
        laid(end == RailEnd::Last ? rail.origin : rail.stop(rail.stops - 1), to, rail.stepM);
    if (end == RailEnd::First) { // the rail keeps the end at which it begins
        result = reversed(result);
    }
    result.isLocked = rail.isLocked;
    return result;
}

std::vector<RailPlacement> split(const RailPlacement& rail, int stop) {
    RailPlacement second = withStops(rail, rail.stops - stop);
    second.origin = rail.stop(stop);
    return {withStops(rail, stop), second};
}

std::vector<RailPlacement> withoutStop(const RailPlacement& rail, int stop) {
    std::vector<RailPlacement> left;
    if (stop > 0) {
        left.push_back(withStops(rail, stop));
    }
    if (stop + 1 < rail.stops) {
        left.push_back(split(rail, stop + 1).back());
    }
    return left;
}

} // namespace spherewalk::survey
