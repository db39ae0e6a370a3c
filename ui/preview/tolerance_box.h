// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace spherewalk::ui {

/// How far off a view may be, in pixels of the robot's camera.
class ToleranceBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit ToleranceBox(const QString& name, QWidget* parent = nullptr);
};

} // namespace spherewalk::ui
