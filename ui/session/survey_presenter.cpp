// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/survey_presenter.h"

namespace spherewalk::ui {

void SurveyPresenter::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
        m_session->selection()->disconnect(this);
    }
    const bool isFirst = m_session == nullptr;
    m_session = session;
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, &SurveyPresenter::refresh);
    }
    m_isStale = isFirst && session != nullptr && !m_isShown;
    if (!m_isStale) { // nothing of the session before may stay
        read();
    }
}

void SurveyPresenter::setShown(bool isShown) {
    m_isShown = isShown;
    if (isShown && m_isStale) {
        refresh();
    }
}

void SurveyPresenter::refresh() {
    m_isStale = !m_isShown;
    if (m_isShown) {
        read();
    }
}

} // namespace spherewalk::ui
