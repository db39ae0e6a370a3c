// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

namespace spherewalk::ui {

/// Records what a person decides on photos, each step on the session's undo stack.
class PhotoReviewer : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Null: none is open.
    void setSession(SurveySession* session) { m_session = session; }

    /// Keeps the notes.
    void decide(const std::vector<std::int64_t>& photos, store::Decision decision);
    /// Keeps the decision.
    void setNote(std::int64_t photo, const QString& note);

  signals:
    /// Nothing was recorded, and why.
    void refused(const QString& sentence);

  private:
    void apply(const QString& what, const std::vector<std::int64_t>& photos,
               const std::function<void(store::Review&)>& change);

    QPointer<SurveySession> m_session;
};

} // namespace spherewalk::ui
