// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace spherewalk::ui {

/// Whether the window is dark or light, or as the desktop is.
enum class Theme { System, Light, Dark };

/// Sets the application's style and colours; can be called again at any time.
void applyTheme(Theme theme);

/// Colours that mean something, after Okabe and Ito, so that the colour-blind can tell them apart. They
/// never stand alone: a form or a word goes with them.
QColor goodColour();
QColor doubtfulColour();
QColor failedColour();

} // namespace spherewalk::ui
