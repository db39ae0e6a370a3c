// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

class QLabel;
class QPushButton;

namespace spherewalk::ui {

class CameraBox;
class MeasurePresenter;
class TaskBar;
class ToleranceBox;

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
    ToleranceBox* m_tolerance = nullptr;
    QPushButton* m_measure = nullptr;
    TaskBar* m_progress = nullptr;
    QLabel* m_words = nullptr;
    QPushButton* m_open = nullptr;
};

} // namespace spherewalk::ui
