// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QString>

class QPainter;

namespace spherewalk::ui {

/// Writes text on a dark plate, readable on any picture, at a side or in the middle of an area. Returns the
/// plate; empty if there is no text, or no place for it.
QRectF paintPlate(QPainter& painter, const QRectF& within, Qt::Alignment alignment, const QString& text);

} // namespace spherewalk::ui
