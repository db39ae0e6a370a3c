// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>
#include <QWidget>

namespace spherewalk::ui {

/// Returns the icon of this name in resources/icons, or an empty icon if there is none. It draws itself at
/// any size in the colours of the palette: text, greyed if disabled, highlight if switched on.
QIcon icon(const QString& name);

/// Returns the icon as a picture in one colour, at the density of the screen. Units: sizePx in pixels of
/// widgets.
QPixmap colouredIcon(const QString& name, const QColor& colour, int sizePx);

/// A widget that shows one icon in the colours of the palette.
class IconLabel : public QWidget {
    Q_OBJECT

  public:
    /// Units: sizePx in pixels of widgets.
    IconLabel(const QString& iconName, int sizePx, QWidget* parent = nullptr);

    /// An empty name shows nothing.
    void setIcon(const QString& iconName);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_name;
    QIcon m_icon;
};

} // namespace spherewalk::ui
