// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

namespace spherewalk::ui {

/// Records decisions and notes of a person on photos. Each call is one step of the session's undo stack.
class PhotoReviewer : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Null: no survey is open.
    void setSession(SurveySession* session) { m_session = session; }

    /// Sets the decision of these photos; their notes stay.
    void decide(const std::vector<std::int64_t>& photos, store::Decision decision);
    /// Sets the note of a photo; its decision stays.
    void setNote(std::int64_t photo, const QString& note);

  signals:
    /// Nothing was recorded; the sentence says why.
    void refused(const QString& sentence);

  private:
    void apply(const QString& what, const std::vector<std::int64_t>& photos,
               const std::function<void(store::Review&)>& change);

    QPointer<SurveySession> m_session;
};

} // namespace spherewalk::ui
