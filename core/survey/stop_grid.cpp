// SPDX-License-Identifier: GPL-3.0-or-later
#include "rails.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kMostTrials = 400'000; ///< points tried to find the best shift
constexpr int kFinestShift = 16;        ///< shifts per step and axis

bool canHoldStop(const Floor& floor, const Vector2d& point, double clearanceM) {
    // A stop exactly on a wall may count as inside or outside by the last bit; the clearance decides.
    return floor.has(point) && floor.keepsClear(point, point, clearanceM);
}

/// How many points of one axis fit, and where the first lies so that they are centred.
struct Span {
    int count = 0;
    double first = 0;
};

Span centredSpan(double size, const PlanOptions& options) {
    const double length = size - 2 * options.clearanceM;
    if (length < -kEqualM) {
        return {};
    }
    const int steps = static_cast<int>(std::floor(length / options.stepM + kEqualM));
    const int count = std::max(steps, 0) + 1;
    return {count, (size - (count - 1) * options.stepM) / 2};
}

int distanceToCentred(int shift, int shifts) {
    return std::min(shift, shifts - shift);
}

/// The shift, in parts of a step, at which most points are free.
Vector2d bestShift(const Floor& floor, const PlanOptions& options, const Span& x, const Span& y) {
    const double points = double(x.count + 1) * double(y.count + 1);
    const int shifts = std::clamp(static_cast<int>(std::sqrt(kMostTrials / points)), 1, kFinestShift);
    Vector2d best = Vector2d::Zero();
    int mostFree = -1;
    int leastDistance = 0;
    for (int shiftY = 0; shiftY < shifts; ++shiftY) {
        for (int shiftX = 0; shiftX < shifts; ++shiftX) {
            const Vector2d shift(double(shiftX) / shifts, double(shiftY) / shifts);
            int free = 0;
            for (int row = -1; row < y.count; ++row) {
                for (int column = -1; column < x.count; ++column) {
                    const Vector2d point =
                        Vector2d(x.first, y.first) + options.stepM * (shift + Vector2d(column, row));
                    free += canHoldStop(floor, point, options.clearanceM) ? 1 : 0;
                }
            }
            const int distance = distanceToCentred(shiftX, shifts) + distanceToCentred(shiftY, shifts);
            if (free > mostFree || (free == mostFree && distance < leastDistance)) {
                mostFree = free;
                leastDistance = distance;
                best = shift;
            }
        }
    }
    return best;
}

} // namespace

int StopGrid::freeCount() const {
    return static_cast<int>(std::count(free.begin(), free.end(), 1));
}

StopGrid bestStopGrid(const Floor& floor, const PlanOptions& options) {
    const Span x = centredSpan(floor.size().x(), options);
    const Span y = centredSpan(floor.size().y(), options);
    StopGrid grid;
    grid.stepM = options.stepM;
    if (x.count == 0 || y.count == 0) {
        return grid;
    }
    const Vector2d shift = bestShift(floor, options, x, y);
    // One more point below the centred ones, where a shift may make room for it.
    grid.origin = Vector2d(x.first, y.first) + options.stepM * (shift - Vector2d::Ones());
    grid.columns = x.count + 1;
    grid.rows = y.count + 1;
    const FloorRaster raster(floor, options.stepM);
    const std::vector<bool> enclosed = enclosedCells(floor, raster, options.stepM);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d point = grid.at(column, row);
            const bool free = canHoldStop(floor, point, options.clearanceM) &&
                              (enclosed.empty() || !enclosed[static_cast<std::size_t>(raster.cellAt(point))]);
            grid.free.push_back(free ? 1 : 0);
        }
    }
    return grid;
}

void StopGrid::leaveOut(std::span<const RailPlacement> rails, const Vector2d& anchor) {
    const double nearM = 0.5 * stepM - kEqualM;
    for (const RailPlacement& rail : rails) {
        for (int k = 0; k < rail.stops; ++k) {
            const Vector2d stop = rail.stop(k) - anchor;
            const Vector2d nearest = ((stop - origin) / stepM).array().round();
            // Only the nearest point of a grid can be so near.
            const bool isInGrid =
                nearest.x() >= 0 && nearest.x() < columns && nearest.y() >= 0 && nearest.y() < rows;
            if (isInGrid && (origin + stepM * nearest - stop).norm() < nearM) {
                free[static_cast<std::size_t>(nearest.y()) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(nearest.x())] = 0;
            }
        }
    }
}

std::vector<Rail> railsAlong(bool alongX, const StopGrid& grid, const Floor& floor,
                             const PlanOptions& options) {
    std::vector<Rail> rails;
    const int lines = alongX ? grid.rows : grid.columns;
    const int length = alongX ? grid.columns : grid.rows;
    const auto point = [&](int line, int k) { return alongX ? grid.at(k, line) : grid.at(line, k); };
    const auto isFree = [&](int line, int k) { return alongX ? grid.isFree(k, line) : grid.isFree(line, k); };
    const auto addRun = [&](int line, int begin, int end) {
        const int pieces = (end - begin + options.railStops - 1) / options.railStops;
        for (int piece = 0; piece < pieces; ++piece) {
            const int from = begin + (end - begin) * piece / pieces;
            const int to = begin + (end - begin) * (piece + 1) / pieces;
            rails.push_back({alongX ? from : line, alongX ? line : from, to - from, alongX});
        }
    };
    for (int line = 0; line < lines; ++line) {
        for (int begin = 0; begin < length;) {
            if (!isFree(line, begin)) {
                ++begin;
                continue;
            }
            int end = begin + 1;
            while (end < length && isFree(line, end) &&
                   floor.keepsClear(point(line, end - 1), point(line, end), options.clearanceM)) {
                ++end;
            }
            addRun(line, begin, end);
            begin = end;
        }
    }
    return rails;
}

} // namespace spherewalk::survey
