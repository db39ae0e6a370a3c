// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/modes.h"

#include "ui/align/align_mode.h"
#include "ui/capture/capture_mode.h"
#include "ui/export/export_mode.h"
#include "ui/plan/plan_mode.h"
#include "ui/preview/preview_mode.h"
#include "ui/review/review_mode.h"
#include "ui/tasks/task_list.h"

namespace spherewalk::ui {

QList<Mode*> makeModes(TaskList& tasks, QWidget* parent) {
    return {
        new PlanMode(tasks, parent),  new CaptureMode(tasks, parent), new ReviewMode(tasks, parent),
        new AlignMode(tasks, parent), new PreviewMode(tasks, parent), new ExportMode(tasks, parent),
    };
}

} // namespace spherewalk::ui
