// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace spherewalk::ui {

/// A column of controls that scrolls up and down, and is never narrower than they are.
class ColumnScrollArea : public QScrollArea {
  public:
    explicit ColumnScrollArea(QWidget* column, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace spherewalk::ui
