// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include "spherewalk/jobs/export_place.h"

#include <QGroupBox>
#include <QPointer>

#include <string>

class QLabel;
class QPushButton;

namespace spherewalk::ui {

class TaskBar;

/// Writes the open survey as a page for browsers, into a new folder beside the survey.
class PagePresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit PagePresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    /// Whether the survey has a photo that can be shown, and no page is being written.
    bool canExport() const;

    /// Starts the export. Range: canExport().
    void exportNow();

    /// Returns the export that runs; null without one.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Says what was written, or why nothing was; empty before an export.
    QString words() const { return m_words; }

    /// Returns the index.html of the last export; empty without one.
    QString page() const { return m_page; }

  signals:
    void changed();

  private:
    void read() override { emit changed(); }

    void show(const QString& folder, const jobs::WebReport& report);
    void ended(const Task& task);

    TaskList& m_tasks;
    QString m_words;
    QString m_page;
    QPointer<Task> m_task;
};

/// Exports the page, says what it has, and opens it in the browser.
class PagePanel : public QGroupBox {
    Q_OBJECT

  public:
    explicit PagePanel(PagePresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// The user wants to see the page.
    void openRequested(const QString& page);

  private:
    void showAll();

    PagePresenter& m_presenter;
    QPushButton* m_export = nullptr;
    TaskBar* m_progress = nullptr;
    QLabel* m_words = nullptr;
    QPushButton* m_open = nullptr;
};

/// A word of a page for browsers, or what core says of photos, in the window's language. Threads: any.
std::string pageWord(const std::string& english);

} // namespace spherewalk::ui
