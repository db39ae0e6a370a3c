// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/desk_operator.h"

#include "spherewalk/base/error.h"

#include <utility>

namespace spherewalk::ui {

void ShutterKey::press() {
    {
        const std::scoped_lock lock(m_mutex);
        m_isPressed = true;
    }
    m_pressed.notify_all();
}

void ShutterKey::forget() {
    const std::scoped_lock lock(m_mutex);
    m_isPressed = false;
}

bool ShutterKey::wait(std::chrono::milliseconds atMost, const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    m_pressed.wait_for(lock, stop, atMost, [this] { return m_isPressed; });
    throwIfStopped(stop);
    return std::exchange(m_isPressed, false);
}

DeskOperator::DeskOperator(camera::OscClient& client, ShutterKey& key, DeskEvents events,
                           const std::optional<camera::Endpoint>& practice, bool isAutomatic)
    : m_client(client), m_key(key), m_events(std::move(events)), m_isAutomatic(isAutomatic) {
    if (practice) {
        m_practice.emplace(*practice);
    }
}

void DeskOperator::cameraReady(const camera::CameraInfo& camera, const camera::CameraReadiness& readiness) {
    m_status.model = QString::fromStdString(camera.model);
    m_status.serialNumber = QString::fromStdString(camera.serialNumber);
    m_status.firmware = QString::fromStdString(camera.firmwareVersion);
    m_status.batteryFraction = readiness.batteryFraction;
    m_status.remainingPhotos = readiness.remainingPhotos;
    m_events.status(m_status);
}

void DeskOperator::waitForKey(const std::stop_token& stop) {
    while (!m_key.wait(kStatePause, stop)) {
        try {
            update(m_status, m_client.state(stop));
            m_events.status(m_status);
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Stopped) {
                throw;
            }
            m_events.noAnswer(
                QString::fromStdString(error.sentence())); // the next shot will say more, if it lasts
        }
    }
    if (m_events.quiet()) {
        m_client.noteDisturbed();
    }
}

void DeskOperator::moveTo(const store::StationRecord& station, const std::stop_token& stop) {
    m_key.forget();
    m_events.atStation(station);
    if (!m_isAutomatic) {
        waitForKey(stop);
    }
    if (m_practice) {
        m_practice->moveTo(station, stop);
    }
    m_events.shooting();
}

bool DeskOperator::tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                            int tries, const std::stop_token& stop) {
    if (m_isAutomatic && m_practice) {
        return m_practice->tryAgain(station, outcome, tries, stop);
    }
    m_key.forget();
    m_events.askAgain(station, QString::fromStdString(outcome.sentence));
    waitForKey(stop);
    m_events.shooting();
    return true;
}

void DeskOperator::exposed(const store::StationRecord& /*station*/) {
    if (m_status.remainingPhotos) {
        --*m_status.remainingPhotos;
        m_events.status(m_status);
    }
}

void DeskOperator::shotEnded(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                             const photo::Verdict* verdict) {
    QString sentence = QString::fromStdString(outcome.sentence);
    const auto add = [&](const std::string& more) {
        sentence += (sentence.isEmpty() || more.empty() ? "" : " ") + QString::fromStdString(more);
    };
    if (verdict != nullptr) {
        add(verdict->sentence());
    }
    for (const std::string& warning : outcome.warnings) {
        add(warning);
    }
    m_events.ended(station, verdictOf(outcome, verdict), outcome.shot.step == camera::ShotStep::Downloaded,
                   sentence);
}

} // namespace spherewalk::ui
