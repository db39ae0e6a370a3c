// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_run.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/camera/osc_error.h"

#include <utility>

namespace spherewalk::jobs {

PhotoFetcher::PhotoFetcher(SharedStore& store, camera::OscClient& client, Clock& clock,
                           camera::CaptureOptions options, Events events)
    : m_events(std::move(events)),
      m_journal(store, StoreJournal::View::Fetching),
      m_capture(client, m_journal, clock, options),
      m_retryPause(options.reconnectPause),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

PhotoFetcher::~PhotoFetcher() {
    m_thread.request_stop();
}

void PhotoFetcher::wake() {
    {
        const std::scoped_lock lock(m_mutex);
        m_isWoken = true;
    }
    m_changed.notify_all();
}

void PhotoFetcher::finish(const std::stop_token& stop) {
    {
        std::unique_lock lock(m_mutex);
        m_isFinishing = true;
        m_changed.notify_all();
        m_changed.wait(lock, stop, [this] { return m_hasEnded; });
    }
    throwIfFailed();
    throwIfStopped(stop);
}

void PhotoFetcher::throwIfFailed() {
    const std::scoped_lock lock(m_mutex);
    if (m_failure) {
        std::rethrow_exception(m_failure);
    }
}

void PhotoFetcher::run(const std::stop_token& stop) {
    std::exception_ptr failure;
    try {
        bool isLast = false;
        while (!isLast) {
            isLast = isRoundDue(stop);
            round(isLast, stop);
        }
    } catch (...) { // rethrown by finish() and throwIfFailed()
        failure = std::current_exception();
    }
    {
        const std::scoped_lock lock(m_mutex);
        m_hasEnded = true;
        m_failure = failure;
    }
    m_changed.notify_all();
    if (failure && !stop.stop_requested()) {
        m_events.failed();
    }
}

/// Waits for something to do; true if it is the last time.
bool PhotoFetcher::isRoundDue(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    const auto isDue = [this] { return m_isWoken || m_isFinishing; };
    if (m_failed.empty()) {
        m_changed.wait(lock, stop, isDue);
    } else {
        m_changed.wait_for(lock, stop, m_retryPause, isDue);
    }
    throwIfStopped(stop);
    m_isWoken = false;
    return m_isFinishing;
}

void PhotoFetcher::round(bool isLast, const std::stop_token& stop) {
    std::set<std::int64_t> tried;
    const auto next = [&]() -> std::optional<survey::Shot> { // anew each time: more may have been taken
        for (const survey::Shot& shot : m_journal.openShots()) {
            if (!tried.contains(shot.id)) {
                return shot;
            }
        }
        return std::nullopt;
    };
    std::optional<camera::ShotOutcome> unreached;
    for (auto shot = next(); shot; shot = next()) {
        tried.insert(shot->id);
        if (!unreached) {
            const camera::ShotOutcome outcome = fetch(*shot, stop);
            tell(outcome);
            if (outcome.problem == ErrorKind::Network || outcome.problem == ErrorKind::Timeout) {
                unreached = outcome; // the others would only wait for the same
            }
        } else if (isLast) {
            unreached->shot = *shot;
            tell(*unreached);
        }
    }
}

camera::ShotOutcome PhotoFetcher::fetch(const survey::Shot& shot, const std::stop_token& stop) {
    try {
        m_capture.connect(stop); // it may be another camera by now
        return m_capture.fetch(shot, stop);
    } catch (const Error& error) {
        if (!camera::isCameraTrouble(error.kind())) {
            throw;
        }
        camera::ShotOutcome outcome;
        outcome.shot = shot;
        outcome.sentence = error.sentence();
        outcome.problem = error.kind();
        return outcome;
    }
}

/// Once for each photo that is there, and once for each that is not.
void PhotoFetcher::tell(const camera::ShotOutcome& outcome) {
    if (outcome.shot.step == survey::ShotStep::Downloaded) {
        m_failed.erase(outcome.shot.id);
        m_events.ended(outcome);
    } else if (m_failed.insert(outcome.shot.id).second) {
        m_events.ended(outcome);
    }
}

} // namespace spherewalk::jobs
