// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo_fetcher.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"

#include <utility>

namespace spherewalk::jobs {

namespace {

/// What the link or the camera may get over, unlike this computer's disk.
bool isWorthAnotherTry(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::Network:
    case ErrorKind::Timeout:
    case ErrorKind::Corrupt:
    case ErrorKind::Unsupported:
    case ErrorKind::NotFound:
    case ErrorKind::Busy:
        return true;
    default:
        return false;
    }
}

} // namespace

PhotoFetcher::PhotoFetcher(SharedStore& store, camera::OscClient& client, Clock& clock,
                           camera::CaptureOptions options, Events events)
    : m_store(store),
      m_clock(clock),
      m_events(std::move(events)),
      m_journal(store, StoreJournal::View::Fetching),
      m_capture(client, m_journal, clock, options),
      m_judge(store),
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

double PhotoFetcher::secondsJudging() const {
    const std::scoped_lock lock(m_mutex);
    return m_secondsJudging;
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
    const auto next = [&]() -> std::optional<camera::Shot> { // anew each time: more may have been taken
        for (const camera::Shot& shot : m_journal.openShots()) {
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
            tell(outcome, stop);
            if (outcome.problem == ErrorKind::Network || outcome.problem == ErrorKind::Timeout) {
                unreached = outcome; // the others would only wait for the same
            }
        } else if (isLast) {
            unreached->shot = *shot;
            tell(*unreached, stop);
        }
    }
}

camera::ShotOutcome PhotoFetcher::fetch(const camera::Shot& shot, const std::stop_token& stop) {
    try {
        m_capture.connect(stop); // it may be another camera by now
        return m_capture.fetch(shot, stop);
    } catch (const Error& error) {
        if (!isWorthAnotherTry(error.kind())) {
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
void PhotoFetcher::tell(const camera::ShotOutcome& outcome, const std::stop_token& stop) {
    const std::int64_t shot = outcome.shot.id;
    if (outcome.shot.step != camera::ShotStep::Downloaded) {
        if (m_failed.insert(shot).second) {
            m_events.ended(outcome, std::nullopt);
        }
        return;
    }
    m_failed.erase(shot);
    const Clock::TimePoint start = m_clock.now();
    const auto photo = m_store.use([&](const store::SurveyStore& store) { return store.shot(shot).photo; });
    const photo::Verdict verdict = m_judge.judge(photo.value(), stop);
    {
        const std::scoped_lock lock(m_mutex);
        m_secondsJudging += std::chrono::duration<double>(m_clock.now() - start).count();
    }
    m_events.ended(outcome, verdict);
}

} // namespace spherewalk::jobs
