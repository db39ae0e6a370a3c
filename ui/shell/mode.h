// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <QWidget>

class QUndoStack;

namespace spherewalk::ui {

class SurveySession;

/// One page of the window, for one kind of work.
class Mode : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

    /// Translated and short: "Plan".
    virtual QString title() const = 0;
    virtual QIcon icon() const = 0;

    /// What the mode is for, in a sentence.
    virtual QString hint() const { return {}; }

    /// Null: no survey is open. Owner: the window; the session outlives its use here, as null is set before
    /// it ends.
    virtual void setSession(SurveySession* session) = 0;

    /// Called each time the page comes into sight.
    virtual void activated() {}

    /// What can be undone here; null: what the survey's own stack can undo.
    virtual QUndoStack* undoStack() { return nullptr; }

    /// Whether there is something to do here while no survey is open.
    virtual bool worksWithoutSurvey() const { return false; }

    /// Whether the room's plan beside the page would only repeat what the page shows.
    virtual bool showsPlan() const { return false; }

  signals:
    /// A sentence for the status line.
    void message(const QString& sentence);
    /// The user made or chose a survey here, which the window is to open.
    void openRequested(const QString& folder);
    /// The user wants to draw another survey.
    void newRequested();
};

} // namespace spherewalk::ui
