// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"

#include <QIcon>
#include <QList>
#include <QString>
#include <QWidget>

class QUndoStack;

namespace spherewalk::ui {

class SurveySession;

/// One page of the window, which serves one kind of work.
class Mode : public QWidget {
    Q_OBJECT

  public:
    /// name: object name of the page, and the name of its icon. title, hint: translated words for the bar, as
    /// "Plan" and "Draw the room".
    Mode(const QString& name, QString title, QString hint, QWidget* parent);

    QString title() const { return m_title; }

    QString hint() const { return m_hint; }

    QIcon icon() const;

    /// Takes the open survey; null: no survey is open. Owner: the window, which sets null before it deletes
    /// the session.
    virtual void setSession(SurveySession* session) = 0;

    /// The window calls it each time that it shows the page.
    virtual void activated() {}

    /// Returns the page's own undo stack; null: the page uses the stack of the survey.
    virtual QUndoStack* undoStack() { return nullptr; }

    /// Whether the page is useful while no survey is open.
    virtual bool worksWithoutSurvey() const { return false; }

    /// Whether the window shows the plan of the survey beside the page.
    virtual bool wantsPlan() const { return false; }

    /// Whether the page takes the whole screen in full screen, without menus and bars.
    virtual bool takesWholeScreen() const { return false; }

    /// Tells that the page has the whole screen, or has it no more.
    virtual void setWholeScreen(bool /*isWhole*/) {}

    /// A key of the page that is no shortcut of an action, and what it does.
    struct Key {
        QString name;
        QString what;
    };

    /// Returns these keys for the list of all keys.
    virtual QList<Key> keys() const { return {}; }

    /// What a page shows in place of the open survey, for the title and the status line.
    struct Subject {
        QString name;
        QString note; ///< "101 photos", for example.
    };

    /// Returns the page's subject; the name is empty where that is the survey.
    virtual Subject subject() const { return {}; }

    /// Shows a part of the page, such as a filter that another page has asked for.
    virtual void showPart(const QString& /*part*/) {}

  signals:
    /// The page has become visible or hidden.
    void shownChanged(bool isShown);
    /// subject() returns another one.
    void subjectChanged();
    /// Carries a sentence for the status line.
    void message(const Told& sentence);
    /// Asks the window to open the survey in this folder.
    void openRequested(const QString& folder);
    /// Asks the window to begin a new survey.
    void newRequested();
    /// Asks the window to show the page of this name, and there what showPart() knows by `part`.
    void pageRequested(const QString& page, const QString& part = {});

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QString m_title;
    QString m_hint;
};

} // namespace spherewalk::ui
