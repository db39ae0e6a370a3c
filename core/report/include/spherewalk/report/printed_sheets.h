// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/survey/plan.h"

#include <span>
#include <string>

namespace spherewalk::report {

/// The words of the marking sheet, which a window can give in another language. "%1" and so on stand for
/// values.
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

/// A PDF of AprilTags (36h11) at true size, a page each, for hanging on walls: the tag with its white rim,
/// its number, which side is up, and a bar that checks the printer's scale. The paper is the smallest of A4
/// to A0 that holds the tag. title: the survey's name. sizeM: side of the black square. The same input gives
/// the same bytes. Errors: InvalidInput for no numbers, for an unknown number, and for a size outside 2 to 60
/// cm; Internal if the PDF cannot be made.
Bytes tagSheet(const std::string& title, std::span<const int> numbers, double sizeM);

} // namespace spherewalk::report
