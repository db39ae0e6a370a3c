// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include "spherewalk/jobs/export_place.h"

#include <QGroupBox>
#include <QObject>
#include <QPointer>

#include <set>
#include <utility>
#include <vector>

class QCheckBox;
class QPushButton;

namespace spherewalk::ui {

class TaskBar;
class ToldLabel;

/// Writes what the depths of a dataset show of the place, as files for other programs, into a new folder
/// beside the dataset.
class PlacePresenter : public QObject {
    Q_OBJECT

  public:
    explicit PlacePresenter(TaskList& tasks, QObject* parent = nullptr);

    /// An empty name: no dataset.
    void setDataset(const QString& folder);

    /// Whether there is a dataset of which two photos or more have depths.
    bool hasDepths() const { return m_hasDepths; }

    bool canExport() const { return m_hasDepths && task() == nullptr; }

    /// Starts the export. Range: canExport(), and a format at least.
    void exportNow(const std::set<jobs::PlaceFormat>& formats);

    /// Returns the export that runs; null without one.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Says what was written, or why nothing was; empty before an export.
    QString words() const { return m_words; }

    /// Returns the folder of the last export; empty without one.
    QString exported() const { return m_exported; }

  signals:
    void changed();

  private:
    void show(const QString& folder, const jobs::PlaceReport& report);
    void ended(const Task& task);

    TaskList& m_tasks;
    QString m_dataset;
    bool m_hasDepths = false;
    QString m_words;
    QString m_exported;
    QPointer<Task> m_task;
};

/// Asks for the formats, exports, and says what was seen of the place.
class PlacePanel : public QGroupBox {
    Q_OBJECT

  public:
    explicit PlacePanel(PlacePresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// The user wants to see the folder.
    void openRequested(const QString& folder);

  private:
    void addFormat(jobs::PlaceFormat format, const QString& text, const QString& hint);
    std::set<jobs::PlaceFormat> chosen() const;
    void showAll();

    PlacePresenter& m_presenter;
    std::vector<std::pair<jobs::PlaceFormat, QCheckBox*>> m_formats;
    QPushButton* m_export = nullptr;
    TaskBar* m_progress = nullptr;
    ToldLabel* m_words = nullptr;
    QPushButton* m_open = nullptr;
};

} // namespace spherewalk::ui
