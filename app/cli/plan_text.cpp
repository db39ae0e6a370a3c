// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_text.h"

#include "spherewalk/base/text.h"

namespace spherewalk::cli {

namespace {

/// The uncovered areas that have one reason, in a line; "" if there are none.
std::string reasonLine(const survey::PlanReport& report, survey::UncoveredReason reason,
                       const survey::PlanOptions& options) {
    double areaM2 = 0;
    int count = 0;
    const survey::UncoveredArea* largest = nullptr;
    for (const survey::UncoveredArea& area : report.uncovered) { // largest first
        if (area.reason == reason) {
            largest = largest == nullptr ? &area : largest;
            areaM2 += area.areaM2;
            ++count;
        }
    }
    if (largest == nullptr) {
        return {};
    }
    const std::string where =
        text(count == 1 ? "around (" : text("in ", count, " areas, the largest around ("),
             fixed(largest->point.x(), 2), ", ", fixed(largest->point.y(), 2), ")");
    return text("\n  ", fixed(areaM2, 2), " m2 ", where, ": ", survey::reasonText(reason, options));
}

} // namespace

std::string planText(const survey::PlanReport& report, const survey::PlanOptions& options) {
    const double share = report.floorM2 > 0 ? 100 * report.uncoveredM2 / report.floorM2 : 0;
    std::string result =
        text(report.stations, " stations on ", report.placements, " rail placements, ",
             fixed(report.metresWalked, 0), " m to walk, about ",
             humanDuration(std::chrono::duration<double>(60 * report.minutes)), " at ",
             fixed(options.secondsPerPhoto, 0), " s a photo and ", fixed(options.secondsPerPlacement, 0),
             " s a placement.\n", "Floor ", fixed(report.floorM2, 2), " m2, not covered ",
             fixed(report.uncoveredM2, 2), " m2 (", fixed(share, 0), " %)");
    for (const auto reason : {survey::UncoveredReason::Clearance, survey::UncoveredReason::Enclosed,
                              survey::UncoveredReason::BetweenStops}) {
        result += reasonLine(report, reason, options);
    }
    return result;
}

Json planJson(const survey::PlanReport& report, const survey::PlanOptions& options) {
    Json uncovered = Json::array();
    for (const survey::UncoveredArea& area : report.uncovered) {
        uncovered.push_back({{"area_m2", area.areaM2},
                             {"point_m", {area.point.x(), area.point.y()}},
                             {"reason", survey::reasonText(area.reason, options)}});
    }
    return {{"stations", report.stations},
            {"placements", report.placements},
            {"metres_walked", report.metresWalked},
            {"minutes", report.minutes},
            {"floor_m2", report.floorM2},
            {"uncovered_m2", report.uncoveredM2},
            {"uncovered", uncovered}};
}

} // namespace spherewalk::cli
