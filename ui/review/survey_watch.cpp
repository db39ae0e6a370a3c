// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/survey_watch.h"

#include "spherewalk/base/error.h"

#include <utility>

namespace spherewalk::ui {

SurveyWatch::SurveyWatch(QObject* parent) : QObject(parent) {
    m_timer.setInterval(std::chrono::seconds(1));
    connect(&m_timer, &QTimer::timeout, this, [this] { look(false); });
}

void SurveyWatch::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_timer.stop();
    m_store.reset();
    if (session != nullptr) {
        m_store = std::make_shared<const store::SurveyStore>(
            store::SurveyStore::open(session->path(), store::Access::Read));
        m_seen = m_store->dataVersion();
        // What the session itself says is known, whoever wrote it.
        connect(session, &SurveySession::changed, this, [this] {
            ++m_told;
            look(true);
        });
        m_timer.start();
    }
}

void SurveyWatch::look(bool isKnown) {
    m_worker.post(isKnown ? "known" : "look",
                  [this, store = m_store, isKnown, told = m_told]() -> BackgroundWorker::Deliver {
                      try {
                          return [this, store, isKnown, told, version = store->dataVersion()] {
                              if (store != m_store) {
                                  return; // another survey is open meanwhile
                              }
                              const bool isNews = version != std::exchange(m_seen, version);
                              if (isNews && !isKnown && told == m_told && m_session) {
                                  m_session->noteChangedSoon(SurveySession::Everything);
                              }
                          };
                      } catch (const Error&) { // busy for a moment; it looks again
                          return {};
                      }
                  });
}

} // namespace spherewalk::ui
