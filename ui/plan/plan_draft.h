// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/report/printed_sheets.h"
#include "spherewalk/survey/plan_report.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace spherewalk::ui {

/// A room as far as it is drawn, with the options of its plan.
struct PlanDraft {
    survey::Room room;
    survey::PlanOptions options;
    std::vector<survey::RailPlacement> rails = {}; ///< As a person laid them; none: the program lays all.
    bool laysRest = false;                         ///< The program lays more rails around those.
    bool hasRails = true;                          ///< Photos by hand need none.
    std::vector<survey::Station> byHand = {};      ///< Where photos by hand stand.
    bool isRoomKnown = true;                       ///< Else the room is only something to begin with.
};

/// Returns a rectangular room for a new survey.
PlanDraft firstDraft();

/// Return the stops of the cart on a rail of this length, and the length that a rail with these stops needs.
int railStops(double lengthM, double stepM);
double railLengthM(int stops, double stepM);

/// Changes the step; the number of stops follows, so that the rail keeps its length.
void changeStep(PlanDraft& draft, double stepM);

/// Leaves of its rails the locked ones, and has the program lay the rest.
void keepLocked(PlanDraft& draft);

/// Returns the plan of a draft. Errors: those of survey::plan() and survey::planOfLaid().
survey::Plan planOf(const PlanDraft& draft);

/// The plan of a draft and its figures. If there is a problem, the plan is empty.
struct PlanOutcome {
    survey::Plan plan;
    survey::PlanReport report;
    QString problem; ///< Says why there is no plan; empty if there is one.
};

/// Plans a draft as `spherewalk-cli new` does. An error becomes the outcome's problem. Cost: that of
/// survey::plan().
PlanOutcome outcomeOf(const PlanDraft& draft);

/// Returns "48 stations on 8 rails".
QString countsText(const survey::PlanReport& report);
/// Returns "31 m to walk, about 18 min".
QString walkText(const survey::PlanReport& report);
/// Returns "19.6 m² of floor, 1.2 m² not covered (6 %)".
QString floorText(const survey::PlanReport& report);
/// Returns a line for each reason that leaves floor uncovered.
QStringList uncoveredText(const survey::PlanReport& report, const survey::PlanOptions& options);
/// Returns the translated words of the marking-out sheet.
report::SheetWords sheetWords();

} // namespace spherewalk::ui
