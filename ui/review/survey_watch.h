// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <cstdint>
#include <optional>

namespace spherewalk::ui {

/// Tells the session when another program has changed its survey, so that a reviewer sees photos come in
/// while they are captured.
class SurveyWatch : public QObject {
    Q_OBJECT

  public:
    explicit SurveyWatch(QObject* parent = nullptr);

    /// Null: none is open.
    void setSession(SurveySession* session);

    /// Looks now; besides, it looks every second.
    void look();

  private:
    std::optional<std::int64_t> version() const;

    QPointer<SurveySession> m_session;
    std::int64_t m_seen = 0;
    QTimer m_timer;
};

} // namespace spherewalk::ui
