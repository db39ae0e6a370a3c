// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/desk_operator.h"

#include "ui/capture/capture_desk.h"
#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/camera/capture.h"

#include <utility>

namespace spherewalk::ui {

survey::Quality qualityOf(const camera::ShotOutcome& outcome, const photo::Verdict* found) {
    if (outcome.shot.step == survey::ShotStep::Taken) {
        return survey::Quality::Doubtful;
    }
    if (outcome.shot.step != survey::ShotStep::Downloaded ||
        (found != nullptr && found->quality() == survey::Quality::Failed)) {
        return survey::Quality::Failed;
    }
    const bool isFlawless = found == nullptr || found->findings.empty();
    return outcome.warnings.empty() && isFlawless ? survey::Quality::Good : survey::Quality::Doubtful;
}

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

void ShutterKey::leave() {
    {
        const std::scoped_lock lock(m_mutex);
        m_hasLeft = true;
    }
    m_pressed.notify_all();
}

void ShutterKey::begin() {
    const std::scoped_lock lock(m_mutex);
    m_isPressed = false;
    m_hasLeft = false;
}

bool ShutterKey::hasLeft() {
    const std::scoped_lock lock(m_mutex);
    return m_hasLeft;
}

bool ShutterKey::wait(std::chrono::milliseconds atMost, const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    m_pressed.wait_for(lock, stop, atMost, [this] { return m_isPressed || m_hasLeft; });
    throwIfStopped(stop);
    return std::exchange(m_isPressed, false) || m_hasLeft;
}

DeskOperator::DeskOperator(CaptureDesk& desk, camera::OscClient& client, const DeskOptions& options)
    : m_desk(desk), m_client(client), m_options(options) {
    if (options.practice) {
        m_practice.emplace(*options.practice);
    }
}

/// Applies on the GUI thread what this run tells, unless the run has ended meanwhile. The desk's destructor
/// waits for the threads that post.
void DeskOperator::post(std::function<void(CaptureDesk&)> apply) const {
    const auto applyInTime = [desk = &m_desk, run = m_options.run, apply = std::move(apply)] {
        if (run == desk->m_run) {
            apply(*desk);
        }
    };
    QMetaObject::invokeMethod(&m_desk, applyInTime, Qt::QueuedConnection);
}

void DeskOperator::postStatus() const {
    post([status = m_status](CaptureDesk& desk) { desk.showStatus(status); });
}

void DeskOperator::cameraReady(const camera::CameraInfo& camera, const camera::CameraReadiness& readiness) {
    m_status.model = QString::fromStdString(camera.model);
    m_status.serialNumber = QString::fromStdString(camera.serialNumber);
    m_status.firmware = QString::fromStdString(camera.firmwareVersion);
    m_status.batteryFraction = readiness.batteryFraction;
    m_status.remainingPhotos = readiness.remainingPhotos;
    postStatus();
    if (!readiness.warnings.empty()) {
        std::string sentences;
        for (const std::string& warning : readiness.warnings) {
            sentences += (sentences.empty() ? "" : " ") + warning;
        }
        post([told = coreTold(sentences)](CaptureDesk& desk) { desk.say(told, survey::Quality::Doubtful); });
    }
}

void DeskOperator::waitForKey(const std::stop_token& stop) {
    while (!m_desk.m_key.wait(kStatePause, stop)) {
        try {
            update(m_status, m_client.state(stop));
            postStatus();
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Stopped) {
                throw;
            }
            // If the camera stays silent, the next shot will say more.
            m_status.batteryFraction.reset();
            postStatus();
            post([told = coreTold(error.sentence())](CaptureDesk& desk) { desk.say(told); });
        }
    }
    if (m_desk.m_preview.endAndWait()) {
        m_client.noteDisturbed();
    }
}

void DeskOperator::moveTo(const store::StationRecord& station, const std::stop_token& stop) {
    m_desk.m_key.forget();
    post([station, waitsForKey = !m_options.isAutomatic](CaptureDesk& desk) {
        desk.atStation(station, waitsForKey);
    });
    if (!m_options.isAutomatic) {
        waitForKey(stop);
    }
    if (m_practice) {
        m_practice->moveTo(station, stop);
    }
    post([](CaptureDesk& desk) { desk.shooting(); });
}

bool DeskOperator::walkOn(int photo, const std::stop_token& stop) {
    m_desk.m_key.forget();
    post([photo, waitsForKey = !m_options.isAutomatic](CaptureDesk& desk) {
        desk.m_queue.walkTo(photo);
        desk.setState(waitsForKey ? CaptureDesk::State::AtStation : CaptureDesk::State::Shooting);
    });
    if (!m_options.isAutomatic) {
        waitForKey(stop);
    }
    const bool goesOn = !m_desk.m_key.hasLeft() && (!m_practice || m_practice->walkOn(photo, stop));
    post([](CaptureDesk& desk) { desk.shooting(); });
    return goesOn;
}

void DeskOperator::placesFound(const jobs::PlacesFound& found) {
    post([found](CaptureDesk& desk) {
        desk.showPlaces(found);
        if (!found.trouble.empty()) {
            desk.say(coreTold(QString::fromStdString(found.sentence())), survey::Quality::Doubtful);
        }
    });
}

bool DeskOperator::tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                            int tries, const std::stop_token& stop) {
    if (m_options.isAutomatic && m_practice) {
        return m_practice->tryAgain(station, outcome, tries, stop);
    }
    m_desk.m_key.forget();
    post([station, sentence = QString::fromStdString(outcome.sentence)](CaptureDesk& desk) {
        desk.askAgain(station, sentence);
    });
    waitForKey(stop);
    post([](CaptureDesk& desk) { desk.shooting(); });
    return !m_desk.m_key.hasLeft();
}

void DeskOperator::exposed(const store::StationRecord& /*station*/) {
    if (m_status.remainingPhotos) {
        --*m_status.remainingPhotos;
        postStatus();
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
    const bool isThere = outcome.shot.step == survey::ShotStep::Downloaded;
    post([station, quality = qualityOf(outcome, verdict), isThere, sentence](CaptureDesk& desk) {
        desk.ended(station, quality, isThere, sentence);
    });
}

} // namespace spherewalk::ui
