// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task_list.h"

#include "spherewalk/camera/discovery.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <vector>

namespace spherewalk::ui {

/// Looks for cameras, as `spherewalk-cli camera --find` does. Threads: the GUI thread; the network is never
/// used on it.
class CameraFinder : public QObject {
    Q_OBJECT

  public:
    explicit CameraFinder(TaskList& tasks, QObject* parent = nullptr) : QObject(parent), m_tasks(tasks) {}

    void setOptions(const camera::FindOptions& options) { m_options = options; }

    /// Nothing happens while it looks already.
    void find();

    bool isLooking() const { return m_task && m_task->isRunning(); }

    const std::vector<camera::FoundCamera>& cameras() const { return m_report.cameras; }

    /// What came of it; empty before.
    const QString& sentence() const { return m_sentence; }

    /// "RICOH THETA V 00123456, 192.168.1.1:80 (its own WiFi)".
    static QString words(const camera::FoundCamera& camera);

  signals:
    void changed();

  private:
    void found(camera::FindReport report);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    camera::FindOptions m_options;
    camera::FindReport m_report;
    QString m_sentence;
};

} // namespace spherewalk::ui
