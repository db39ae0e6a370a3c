// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPushButton;

namespace spherewalk::ui {

/// Makes the button stand out as the one to press next. Its icon is left to the caller.
void makePrimary(QPushButton* button);

} // namespace spherewalk::ui
