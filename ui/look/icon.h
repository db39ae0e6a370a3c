// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

namespace spherewalk::ui {

/// The icon of this name in resources/icons, drawn at any size in the colours of the moment: text for what
/// can be used, greyed for what cannot, highlight for what is switched on. Empty if there is none.
QIcon icon(const QString& name);

/// The icon as a picture in one colour, for the density of the screen. Units: sizePx as widgets count them.
QPixmap colouredIcon(const QString& name, const QColor& colour, int sizePx);

} // namespace spherewalk::ui
