// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QRectF>
#include <QString>

class QPainter;

namespace spherewalk::ui {

/// Colours of the window; System follows the desktop.
enum class Theme { System, Light, Dark };

/// Sets the style and the palette of the application. Later calls change the open windows.
void applyTheme(Theme theme);

/// Colours of good, doubtful and failed results, which colour-blind people can tell apart. A form or a word
/// always goes with the colour. Source: Okabe and Ito, Color Universal Design.
QColor goodColour();
QColor doubtfulColour();
QColor failedColour();

/// Writes text on a dark plate, which makes it readable on any picture. alignment: where the plate lies in
/// the area. Returns the plate's rectangle, which is empty without a text or without room for it.
QRectF paintPlate(QPainter& painter, const QRectF& within, Qt::Alignment alignment, const QString& text);

} // namespace spherewalk::ui
