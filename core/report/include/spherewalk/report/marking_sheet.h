// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/survey/plan.h"

#include <string>

namespace spherewalk::report {

/// The words of the sheet, which a window can give in another language. "%1" and so on stand for values.
struct SheetWords {
    std::string title = "Marking out: %1";
    std::string summary = "%1 stations on %2 rails; step %3 cm; rail of %4 stops, %5 m";
    std::string scale = "Scale 1:%1. Print at 100 %: this bar is 10 cm long.";
    std::string tableTitle = "Where the rails lie: metres by tape";
    std::string errorMeans =
        "Error: how far a place is off at most if each tape is read wrong by 5 mm. Below: check and laser.";
    std::string rail = "Rail";
    std::string stops = "Stops";
    std::string firstStop = "First stop (ring)";
    std::string lastStop = "Last stop (arrow)";
    std::string error = "Error";
    std::string noTapes = "nothing in sight to measure from";
    std::string check = "check %1";   ///< %1: a third tape.
    std::string place = "x %1, y %2"; ///< Coordinates, for a laser.
    std::string ring = "ring %1";     ///< The first stop of another rail.
    std::string arrow = "arrow %1";   ///< The last stop of another rail.
    std::string page = "Page %1";
};

/// A PDF of A4 pages for marking rails on the floor: the plan to scale, then tables of tape distances. Each
/// table has a small map of its rails, and boxes to be ticked.
/// name: the survey's name. The same input gives the same bytes. Errors: those of Room::validate(); Internal
/// if the PDF cannot be made.
Bytes markingSheet(const std::string& name, const survey::Room& room, const survey::PlanOptions& options,
                   const survey::Plan& plan, const SheetWords& words = {});

} // namespace spherewalk::report
