// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan_report.h"

#include <QString>

namespace spherewalk::ui {

/// A room as far as it is drawn, and how it is to be covered.
struct PlanDraft {
    survey::Room room;
    survey::PlanOptions options;
};

/// A rectangular room, to begin with.
PlanDraft firstDraft();

/// Stops of the cart on a rail of this length, and the length of rail that so many stops need.
int railStops(double lengthM, double stepM);
double railLengthM(int stops, double stepM);

/// Another step; the rail keeps its length.
void changeStep(PlanDraft& draft, double stepM);

/// What a draft comes to. If there is a problem, the plan is empty.
struct PlanOutcome {
    survey::Plan plan;
    survey::PlanReport report;
    QString problem; ///< why there is no plan; empty if there is one
};

/// As `spherewalk-cli new` plans. Never throws. Cost: that of survey::plan().
PlanOutcome outcomeOf(const PlanDraft& draft);

} // namespace spherewalk::ui
