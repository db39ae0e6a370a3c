// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/primary_button.h"

#include <QPushButton>

namespace spherewalk::ui {

void makePrimary(QPushButton* button) {
    button->setStyleSheet("QPushButton { background: palette(highlight); color: palette(highlighted-text);"
                          " border: 2px solid palette(highlight); border-radius: 6px; padding: 5px 14px;"
                          " font-weight: bold; }"
                          "QPushButton:focus { border-color: palette(window-text); }"
                          "QPushButton:pressed { border-color: palette(base); }"
                          "QPushButton:disabled { background: palette(button); color: palette(mid);"
                          " border-color: palette(mid); }");
}

} // namespace spherewalk::ui
