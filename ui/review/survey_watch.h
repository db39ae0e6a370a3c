// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"
#include "ui/tasks/background_worker.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <cstdint>
#include <memory>

namespace spherewalk::ui {

/// Tells the session when another program has changed its survey, so that a reviewer sees photos come in
/// while they are captured. It looks every second, in the background.
class SurveyWatch : public QObject {
    Q_OBJECT

  public:
    explicit SurveyWatch(QObject* parent = nullptr);

    /// Null: none is open.
    void setSession(SurveySession* session);

  private:
    /// isKnown: what is found is no news.
    void look(bool isKnown);

    QPointer<SurveySession> m_session;
    std::shared_ptr<const store::SurveyStore> m_store; ///< used by the worker only
    int m_told = 0;                                    ///< how often the session has told of a change
    std::int64_t m_seen = 0;
    QTimer m_timer;
    BackgroundWorker m_worker; ///< last: what it delivers uses the rest
};

} // namespace spherewalk::ui
