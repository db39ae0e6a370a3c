// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/plan_report.h"

#include "floor.h"

#include "spherewalk/base/text.h"
#include "spherewalk/survey/walking_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kMicrometre = 1e-6;

/// Stations by where they stand, so that those near a point are found fast. Several heights count once.
class StandingPoints {
  public:
    StandingPoints(const Plan& plan, const Floor& floor, double reachM) : m_reachM(reachM) {
        for (const Station& station : plan.stations) {
            const Vector2d point = station.positionM.head<2>() - floor.anchor();
            auto& bucket = m_buckets[key(point, 0, 0)];
            if (bucket.empty() || (bucket.back() - point).norm() > kMicrometre) {
                bucket.push_back(point);
            }
        }
    }

    bool covers(const Vector2d& point, const Floor& floor) const {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto bucket = m_buckets.find(key(point, dx, dy));
                if (bucket != m_buckets.end() &&
                    std::any_of(bucket->second.begin(), bucket->second.end(), [&](const Vector2d& station) {
                        return (station - point).norm() <= m_reachM && floor.sees(station, point);
                    })) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    using Key = std::pair<std::int64_t, std::int64_t>;

    Key key(const Vector2d& point, int dx, int dy) const {
        return {static_cast<std::int64_t>(std::floor(point.x() / m_reachM)) + dx,
                static_cast<std::int64_t>(std::floor(point.y() / m_reachM)) + dy};
    }

    double m_reachM;
    std::map<Key, std::vector<Vector2d>> m_buckets;
};

constexpr int kNoReason = -1;

/// Per cell the reason why it is not covered, or kNoReason.
std::vector<int> reasons(const Floor& floor, const FloorRaster& raster, const PlanOptions& options,
                         const Plan& plan) {
    const double reachM = coveringReachM(options.stepM) + kMicrometre;
    const StandingPoints stations(plan, floor, reachM);
    const std::vector<bool> enclosed = enclosedCells(floor, raster, options.stepM);
    std::vector<int> result(static_cast<std::size_t>(raster.cells()), kNoReason);
    for (int cell = 0; cell < raster.cells(); ++cell) {
        const auto at = static_cast<std::size_t>(cell);
        const Vector2d centre = raster.centre(cell);
        if (!raster.isFloor(cell) || stations.covers(centre, floor)) {
            continue;
        }
        const UncoveredReason reason = !enclosed.empty() && enclosed[at] ? UncoveredReason::Enclosed
                                       : !floor.keepsClear(centre, centre, options.clearanceM)
                                           ? UncoveredReason::Clearance
                                           : UncoveredReason::BetweenStops;
        result[at] = static_cast<int>(reason);
    }
    return result;
}

/// Slivers between the lattice and the clearance, smaller than one lattice cell, count to the clearance.
void joinSlivers(std::vector<int>& reasonOf, const FloorRaster& raster, double stepM) {
    const CellGroups groups = connectedCells(raster, reasonOf);
    const double sliver = stepM * stepM / raster.cellArea();
    for (std::size_t cell = 0; cell < reasonOf.size(); ++cell) {
        if (reasonOf[cell] == static_cast<int>(UncoveredReason::BetweenStops) &&
            groups.sizes[static_cast<std::size_t>(groups.groupOf[cell])] < sliver) {
            reasonOf[cell] = static_cast<int>(UncoveredReason::Clearance);
        }
    }
}

std::vector<UncoveredArea> uncoveredAreas(const std::vector<int>& reasonOf, const FloorRaster& raster,
                                          const Vector2d& anchor) {
    const CellGroups groups = connectedCells(raster, reasonOf);
    std::vector<UncoveredArea> areas(groups.sizes.size());
    std::vector<Vector2d> centroids(groups.sizes.size(), Vector2d::Zero());
    const auto forEachCell = [&](auto&& visit) {
        for (int cell = 0; cell < raster.cells(); ++cell) {
            if (const int group = groups.groupOf[static_cast<std::size_t>(cell)]; group >= 0) {
                visit(static_cast<std::size_t>(group), cell);
            }
        }
    };
    forEachCell(
        [&](std::size_t group, int cell) { centroids[group] += raster.centre(cell) / groups.sizes[group]; });
    std::vector<double> nearest(areas.size(), INFINITY);
    forEachCell([&](std::size_t group, int cell) {
        const double distance = (raster.centre(cell) - centroids[group]).norm();
        if (distance < nearest[group] - kEqualM) {
            nearest[group] = distance;
            areas[group].point = raster.centre(cell) + anchor;
            areas[group].reason = static_cast<UncoveredReason>(reasonOf[static_cast<std::size_t>(cell)]);
        }
    });
    for (std::size_t group = 0; group < areas.size(); ++group) {
        areas[group].areaM2 = groups.sizes[group] * raster.cellArea();
    }
    std::stable_sort(areas.begin(), areas.end(),
                     [](const UncoveredArea& a, const UncoveredArea& b) { return a.areaM2 > b.areaM2; });
    return areas;
}

double metresWalked(const Room& room, const Plan& plan) {
    const WalkingDistance walking(room);
    double sum = 0;
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        const RailPlacement& rail = plan.placements[i];
        sum += (rail.stops - 1) * rail.stepM;
        if (i > 0) {
            const RailPlacement& before = plan.placements[i - 1];
            sum += walking.between(before.stop(before.stops - 1), rail.origin);
        }
    }
    return sum;
}

} // namespace

PlanReport report(const Room& room, const PlanOptions& options, const Plan& plan) {
    room.validate();
    options.validate(room);
    const Floor floor(room);
    const FloorRaster raster(floor, options.stepM);
    PlanReport result;
    result.placements = static_cast<int>(plan.placements.size());
    result.stations = static_cast<int>(plan.stations.size());
    result.metresWalked = metresWalked(room, plan);
    result.minutes =
        (result.stations * options.secondsPerPhoto + result.placements * options.secondsPerPlacement) / 60;
    result.floorM2 = raster.floorArea();
    std::vector<int> reasonOf = reasons(floor, raster, options, plan);
    joinSlivers(reasonOf, raster, options.stepM);
    result.uncovered = uncoveredAreas(reasonOf, raster, floor.anchor());
    for (const UncoveredArea& area : result.uncovered) {
        result.uncoveredM2 += area.areaM2;
    }
    return result;
}

std::string reasonText(UncoveredReason reason, const PlanOptions& options) {
    switch (reason) {
    case UncoveredReason::Clearance:
        return text("it is closer than ", fixed(options.clearanceM, 2), " m to a wall or an obstacle");
    case UncoveredReason::Enclosed:
        return "obstacles cut it off from the rest of the floor";
    case UncoveredReason::BetweenStops:
        break;
    }
    return "no stop of the grid falls there; try a finer step";
}

} // namespace spherewalk::survey
