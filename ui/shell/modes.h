// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QWidget;

namespace spherewalk::ui {

class Mode;
class TaskList;

/// The modes of the program, in the order of the work. Owner: the parent.
QList<Mode*> makeModes(TaskList& tasks, QWidget* parent);

} // namespace spherewalk::ui
