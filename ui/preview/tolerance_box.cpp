// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/tolerance_box.h"

namespace spherewalk::ui {

ToleranceBox::ToleranceBox(const QString& name, QWidget* parent) : QDoubleSpinBox(parent) {
    setObjectName(name);
    setRange(0.1, 1000);
    setDecimals(1);
    setValue(2);
    setSuffix(tr(" px"));
    setAccessibleName(tr("Tolerance"));
    setToolTip(tr("Pixels of the robot's camera that 95 of 100 places of a view may be displaced by"));
}

} // namespace spherewalk::ui
