// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QWidget>

namespace spherewalk::ui {

/// An icon by itself, in the colours of the moment.
class IconLabel : public QWidget {
    Q_OBJECT

  public:
    /// Units: sizePx as widgets count them.
    IconLabel(const QString& iconName, int sizePx, QWidget* parent = nullptr);

    /// Empty: nothing is shown.
    void setIcon(const QString& iconName);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_name;
    QIcon m_icon;
};

} // namespace spherewalk::ui
