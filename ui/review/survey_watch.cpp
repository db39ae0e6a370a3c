// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/survey_watch.h"

#include "spherewalk/base/error.h"

namespace spherewalk::ui {

SurveyWatch::SurveyWatch(QObject* parent) : QObject(parent) {
    m_timer.setInterval(std::chrono::seconds(1));
    connect(&m_timer, &QTimer::timeout, this, &SurveyWatch::look);
}

void SurveyWatch::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_timer.stop();
    if (session != nullptr) {
        // What the session itself says is known, whoever wrote it.
        connect(session, &SurveySession::changed, this, [this] { m_seen = version().value_or(m_seen); });
        m_seen = version().value_or(0);
        m_timer.start();
    }
}

std::optional<std::int64_t> SurveyWatch::version() const {
    try {
        return m_session->store().dataVersion();
    } catch (const Error&) { // busy for a moment; it looks again
        return std::nullopt;
    }
}

void SurveyWatch::look() {
    if (m_session && version().value_or(m_seen) != m_seen) {
        m_session->noteChanged(SurveySession::Everything);
    }
}

} // namespace spherewalk::ui
