// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/capture_desk.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace spherewalk::ui {

/// Which camera, and how it is.
class CameraPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CameraPanel(CaptureDesk& desk, QWidget* parent = nullptr);

  private:
    QWidget* makeStatus();
    void showAll();

    CaptureDesk& m_desk;
    QLineEdit* m_address;
    QPushButton* m_connect;
    QPushButton* m_practice;
    QSpinBox* m_hide;
    QCheckBox* m_automatic;
    QLabel* m_model = nullptr;
    QLabel* m_battery = nullptr;
    QLabel* m_storage = nullptr;
    QLabel* m_heat = nullptr;
};

} // namespace spherewalk::ui
