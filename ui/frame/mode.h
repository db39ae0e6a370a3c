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
    /// name: the page's, and its icon's. title, hint: translated; "Plan", and what it is for in a few words.
    Mode(const QString& name, QString title, QString hint, QWidget* parent);

    QString title() const { return m_title; }

    QString hint() const { return m_hint; }

    QIcon icon() const;

    /// Null: no survey is open. Owner: the window; the session outlives its use here, as null is set before
    /// it ends.
    virtual void setSession(SurveySession* session) = 0;

    /// Called each time the page comes into sight.
    virtual void activated() {}

    /// What can be undone here; null: what the survey's own stack can undo.
    virtual QUndoStack* undoStack() { return nullptr; }

    /// Whether there is something to do here while no survey is open.
    virtual bool worksWithoutSurvey() const { return false; }

    /// Whether the room's plan beside the page would tell more than the page shows.
    virtual bool wantsPlan() const { return false; }

  signals:
    /// The page has come into sight, or gone out of it.
    void shownChanged(bool isShown);
    /// A sentence for the status line.
    void message(const QString& sentence);
    /// The user made or chose a survey here, which the window is to open.
    void openRequested(const QString& folder);
    /// The user wants to draw another survey.
    void newRequested();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QString m_title;
    QString m_hint;
};

} // namespace spherewalk::ui
