// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_pulse.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"

namespace spherewalk::ui {

CameraPulse::CameraPulse(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kBeat);
    connect(&m_timer, &QTimer::timeout, this, &CameraPulse::beat);
}

CameraPulse::~CameraPulse() {
    m_stop.request_stop();
}

void CameraPulse::begin(const camera::Endpoint& endpoint, const camera::CredentialsSource& login) {
    end();
    m_endpoint = endpoint;
    m_options.attempts = 1; // the next beat tries again
    m_options.http.credentials = login;
    m_options.http.connectTimeout = kBeat;
    m_options.http.requestTimeout = 2 * kBeat;
    m_timer.start();
}

void CameraPulse::end() {
    ++m_begun;
    m_timer.stop();
    m_stop.request_stop();
    m_stop = std::stop_source();
    m_worker.dropWaiting();
}

void CameraPulse::beat() {
    m_worker.post(QStringLiteral("state"),
                  [this, number = m_begun, endpoint = m_endpoint, options = m_options,
                   stop = m_stop.get_token()]() -> BackgroundWorker::Deliver {
                      try {
                          camera::OscClient client(endpoint, options, systemClock());
                          return [this, number, state = client.state(stop)] {
                              if (number == m_begun) {
                                  emit answered(state);
                              }
                          };
                      } catch (const Error& error) {
                          return [this, number, told = coreTold(error.sentence())] {
                              if (number == m_begun) {
                                  emit silent(told);
                              }
                          };
                      }
                  });
}

} // namespace spherewalk::ui
