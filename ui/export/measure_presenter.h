// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task_list.h"

#include "spherewalk/geometry/camera_model.h"

#include <QObject>
#include <QPointer>

namespace spherewalk::ui {

/// Measures a dataset: how right and how fast its views are, and what is enough for a tolerance. The choice
/// goes into the dataset, and a report into its folder `report`.
class MeasurePresenter : public QObject {
    Q_OBJECT

  public:
    explicit MeasurePresenter(TaskList& tasks, QObject* parent = nullptr);

    QString dataset() const { return m_dataset; }

    /// Empty: none.
    void setDataset(const QString& folder);

    bool canMeasure() const { return !m_dataset.isEmpty() && task() == nullptr; }

    void measure(const CameraIntrinsics& camera, double tolerancePx);

    /// Null if none runs.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// What was chosen and why, or why nothing was; empty before measuring.
    QString words() const { return m_words; }

    /// The page, of this or an earlier time; empty if there is none.
    QString page() const;

  signals:
    void changed();

  private:
    void ended(const Task& task);

    TaskList& m_tasks;
    QString m_dataset;
    QString m_words;
    QPointer<Task> m_task;
};

} // namespace spherewalk::ui
