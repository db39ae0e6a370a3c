// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_limits.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::survey {

namespace {

constexpr double kLeastStepM = 0.01;
constexpr double kGreatestStepM = 100;
constexpr double kLeastClearanceM = 0.01; ///< a stop on a wall would see nothing
constexpr double kGreatestClearanceM = 100;
constexpr double kSlowestPaceS = 86400;
constexpr int kMostRailStops = 1000;
constexpr std::size_t kMostHeights = 50;
constexpr double kLeastHeightDifferenceM = 0.001;
/// Of the lattice over the room's bounds, most of which may lie outside the room.
constexpr double kMostLatticePoints = 1e6;

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkRange(const char* what, double value, double least, double greatest, const char* unit) {
    if (!(value >= least && value <= greatest)) { // also refuses NaN
        refuse(text("The ", what, " of ", value, " ", unit, " cannot be used: give ", least, " to ", greatest,
                    " ", unit, "."));
    }
}

void checkHeights(const std::vector<double>& heights, double ceilingM) {
    if (heights.empty() || heights.size() > kMostHeights) {
        refuse(text("A plan needs from one to ", kMostHeights, " heights of the lens, not ", heights.size(),
                    "."));
    }
    for (const double height : heights) {
        if (!(height > 0 && height < ceilingM)) {
            refuse(text("The lens cannot be at ", height,
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
        refuse(text("The height of ", *same, " m is listed twice; list each height once."));
    }
}

double roundedUpToCentimetres(double stepM) {
    return std::ceil(stepM * 100 - 1e-9) / 100;
}

[[noreturn]] void refuseStep(double stepM, double fittingM, const std::string& why) {
    const double suggested = std::max(roundedUpToCentimetres(fittingM), roundedUpToCentimetres(stepM + 1e-6));
    refuse(text("A step of ", stepM, " m is too fine for this room: ", why, ". A step of ",
                fixed(suggested, 2), " m fits."));
}

void checkLattice(const Room& room, const PlanOptions& options) {
    const Bounds2 extent = bounds(room.outline);
    const Eigen::Array2d free = (extent.greatest - extent.least).array() - 2 * options.clearanceM;
    const auto points = [&](double stepM) { return ((free.max(0.0) / stepM).floor() + 2).prod(); };
    if (points(options.stepM) <= kMostLatticePoints) {
        return;
    }
    double fittingM = roundedUpToCentimetres(options.stepM);
    while (points(fittingM) > kMostLatticePoints) {
        fittingM = roundedUpToCentimetres(fittingM * 1.02);
    }
    refuseStep(options.stepM, fittingM,
               text("its bounds would hold more than ", static_cast<int>(kMostLatticePoints), " stops"));
}

} // namespace

void PlanOptions::validate(const Room& room) const {
    checkRange("step", stepM, kLeastStepM, kGreatestStepM, "m");
    checkRange("clearance", clearanceM, kLeastClearanceM, kGreatestClearanceM, "m");
    checkRange("pace per photo", secondsPerPhoto, 0, kSlowestPaceS, "s");
    checkRange("pace per rail placement", secondsPerPlacement, 0, kSlowestPaceS, "s");
    if (railStops < 1 || railStops > kMostRailStops) {
        refuse(text("A rail with ", railStops, " stops cannot be used: give 1 to ", kMostRailStops, "."));
    }
    checkHeights(heightsM, room.ceilingM);
    checkLattice(room, *this);
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

} // namespace spherewalk::survey
