// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include <QObject>
#include <QPointer>

namespace spherewalk::ui {

/// What a page does with the open survey. It reads the survey when it has changed; while nobody looks, it
/// only notes that, so that a window with many pages stays quick.
class SurveyPresenter : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Null: none is open.
    virtual void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    /// At first it is as if it were shown.
    void setShown(bool isShown);

  signals:
    /// A sentence for people.
    void message(const QString& sentence);

  protected:
    /// Called, while the page is shown, when there is another session or the survey has changed; and when
    /// there is none any more.
    virtual void read() = 0;

  private:
    void refresh();

    QPointer<SurveySession> m_session;
    bool m_isShown = true;
    bool m_isStale = false;
};

} // namespace spherewalk::ui
