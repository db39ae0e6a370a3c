// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"
#include "ui/tasks/task.h"

#include "spherewalk/geometry/camera_model.h"

#include <QGroupBox>
#include <QObject>
#include <QPointer>

class QPushButton;

namespace spherewalk::ui {

/// The folder of a dataset that has its report.
inline constexpr const char* kReportFolder = "report";

class CameraBox;
class TaskBar;
class ToldLabel;
class ToleranceBox;

/// Measures error and speed of the views of a dataset, and chooses what suffices for a tolerance. The choice
/// is written into the dataset, and a report into its folder `report`.
class MeasurePresenter : public QObject {
    Q_OBJECT

  public:
    explicit MeasurePresenter(TaskList& tasks, QObject* parent = nullptr);

    QString dataset() const { return m_dataset; }

    /// An empty name: no dataset.
    void setDataset(const QString& folder);

    bool canMeasure() const { return !m_dataset.isEmpty() && task() == nullptr; }

    /// Starts a measurement for a robot's camera. Range: canMeasure().
    void measure(const CameraIntrinsics& camera, double tolerancePx);

    /// Returns the measurement that runs; null without one.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Says the choice and its reason, or why there is no choice; empty before a measurement.
    const Told& told() const { return m_told; }

    /// Whether views of the dataset are made as the measurement has found best.
    bool isStored() const { return m_isStored; }

    /// Returns the file of the report, also of an earlier measurement; empty without one.
    QString page() const;

  signals:
    void changed();

  private:
    void ended(const Task& task);

    TaskList& m_tasks;
    QString m_dataset;
    Told m_told;
    bool m_isStored = false;
    QPointer<Task> m_task;
};

/// Asks for camera and tolerance, starts a measurement, and shows the choice.
class MeasurePanel : public QGroupBox {
    Q_OBJECT

  public:
    explicit MeasurePanel(MeasurePresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// Carries a sentence for the status line.
    void message(const Told& sentence);
    /// The user wants to see the report.
    void openRequested(const QString& file);

  private:
    void makeQuestion();
    void showAll();

    MeasurePresenter& m_presenter;
    CameraBox* m_camera = nullptr;
    ToleranceBox* m_tolerance = nullptr;
    QPushButton* m_measure = nullptr;
    TaskBar* m_progress = nullptr;
    ToldLabel* m_words = nullptr;
    QPushButton* m_open = nullptr;
};

} // namespace spherewalk::ui
