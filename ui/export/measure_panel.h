// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace spherewalk::ui {

class CameraBox;
class MeasurePresenter;
class TaskBar;

/// Asks for camera and tolerance, measures, and shows what was chosen.
class MeasurePanel : public QGroupBox {
    Q_OBJECT

  public:
    explicit MeasurePanel(MeasurePresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// A sentence for people.
    void message(const QString& sentence);
    /// The report is to be shown.
    void openRequested(const QString& file);

  private:
    void makeQuestion();
    void showAll();

    MeasurePresenter& m_presenter;
    CameraBox* m_camera = nullptr;
    QDoubleSpinBox* m_tolerance = nullptr;
    QPushButton* m_measure = nullptr;
    QPushButton* m_stop = nullptr;
    TaskBar* m_progress = nullptr;
    QLabel* m_words = nullptr;
    QPushButton* m_open = nullptr;
};

} // namespace spherewalk::ui
