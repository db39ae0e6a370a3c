// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_draft.h"

#include "spherewalk/sheet/marking_sheet.h"

#include <QString>
#include <QStringList>

namespace spherewalk::ui {

/// "48 stations on 8 rails".
QString countsText(const survey::PlanReport& report);
/// "31 m to walk, about 18 min".
QString walkText(const survey::PlanReport& report);
/// "19.6 m² of floor, 1.2 m² not covered (6 %)".
QString floorText(const survey::PlanReport& report);
/// A line for each reason that leaves floor uncovered.
QStringList uncoveredText(const survey::PlanReport& report, const survey::PlanOptions& options);
/// The marking-out sheet's words.
sheet::SheetWords sheetWords();

} // namespace spherewalk::ui
