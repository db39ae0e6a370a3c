// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/modes.h"

#include "ui/plan/plan_mode.h"
#include "ui/tasks/task_list.h"

namespace spherewalk::ui {

QList<Mode*> makeModes(TaskList& tasks, QWidget* parent) {
    return {
        new PlanMode(tasks, parent),
    };
}

} // namespace spherewalk::ui
