// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/capture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace spherewalk::camera {

using namespace std::chrono_literals;

namespace {

/// What makes a shot take longer.
const std::vector<std::string> kTimingOptions{"exposureDelay", "shutterSpeed", "_filter"};

void addAll(std::vector<std::string>& warnings, std::vector<std::string> more) {
    std::move(more.begin(), more.end(), std::back_inserter(warnings));
}

/// Notes settled shots that left no photo.
void noteEarlier(CaptureNotes& notes, const std::vector<ShotOutcome>& settled) {
    for (const ShotOutcome& outcome : settled) {
        if (!outcome.sentence.empty()) {
            notes.earlier.push_back({outcome.shot.station, outcome.sentence});
        }
    }
}

void requireCaptureTime(const char* option, std::chrono::milliseconds value,
                        std::chrono::milliseconds least) {
    if (value < least || value > std::chrono::hours(1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The capture option ", option, " must lie between ", least.count(), " ms and 1 h."));
    }
}

void requireNumber(const char* option, double value, double most) {
    if (!(value >= 0 && value <= most)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The capture option ", option, " must lie between 0 and ", most, "."));
    }
}

} // namespace

Foreseen Capture::foreseenAfterRestart(const survey::Shot& shot, const std::stop_token& stop) {
    const auto allowance = m_options.allowance.of(m_guard.read(kTimingOptions, stop));
    const auto now = m_clock.utc();
    constexpr std::chrono::hours kLongAgo(24 * 365 * 100);
    const auto intended = std::clamp(shot.intendedAt, now - kLongAgo, now + kLongAgo);
    // A trigger that had no answer yet either began the picture soon, or never left.
    const auto begins = shot.step == survey::ShotStep::Started
                            ? allowance
                            : allowance - std::max(0ms, m_options.allowance.base - m_options.triggerTime);
    const Foreseen::Window window{intended, intended + begins};
    if (shot.intendedAt <= now - allowance) {
        return {m_clock.now(), window};
    }
    // Intended in the future: the clock was set back, so that nothing shorter than all of it is safe.
    const auto left = shot.intendedAt >= now
                          ? allowance
                          : std::chrono::ceil<std::chrono::milliseconds>(shot.intendedAt + allowance - now);
    return {m_clock.now() + left, window};
}

CameraReadiness Capture::prepare(const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    CameraReadiness readiness;
    noteEarlier(readiness, settleExposures(stop));
    m_watch.beginAnew();
    const CameraState state = m_client.state(stop);
    addAll(readiness.warnings, m_watch.look(state));
    readiness.batteryFraction = state.batteryFraction;
    m_settler.waitUntilIdle(stop);
    m_guard.rememberIn(m_journal.downloadFolder(), m_camera->serialNumber);
    addAll(readiness.warnings, m_guard.apply(stop));
    addAll(readiness.warnings, m_guard.setClock(m_clock.utc(), stop));
    readiness.remainingPhotos = wholeNumber(m_guard.read({"remainingPictures"}, stop), "remainingPictures");
    addAll(readiness.warnings, m_watch.lookAtStorage(readiness.remainingPhotos));
    m_isPrepared = true;
    return readiness;
}

/// Who answers, after a while if need be.
CameraInfo Capture::reach(CaptureNotes& notes, const std::stop_token& stop) {
    const Clock::TimePoint begin = m_clock.now();
    try {
        return m_client.info(stop);
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
    }
    CameraInfo info = m_settler.reconnect(stop);
    const std::chrono::duration<double> away = m_clock.now() - begin;
    notes.warnings.push_back(text("The camera did not answer for ", fixed(away.count(), 0), " s."));
    return info;
}

/// Brings the camera to where the next shot may be intended, whatever has happened since the last one. What
/// had to be settled first.
std::vector<ShotOutcome> Capture::makeReady(CaptureNotes& notes, const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    std::vector<ShotOutcome> settled = m_hasSettled ? settleExposures(stop) : settle(stop);
    noteEarlier(notes, settled);
    const CameraInfo info = reach(notes, stop);
    if (info.serialNumber != m_camera->serialNumber) {
        throw Error(ErrorKind::NotFound,
                    text("Another camera answers (serial number ", printable(info.serialNumber),
                         " instead of ", printable(m_camera->serialNumber),
                         "); check the WiFi, or connect anew."));
    }
    const bool hasRestarted = info.uptimeS.value_or(0) < m_camera->uptimeS.value_or(0);
    m_camera = info;
    if (!m_isPrepared || hasRestarted) {
        m_isPrepared = false; // the camera may have lost its settings
        CameraReadiness readiness = prepare(stop);
        std::ranges::move(readiness.earlier, std::back_inserter(notes.earlier));
        addAll(notes.warnings, std::move(readiness.warnings));
    }
    return settled;
}

std::chrono::milliseconds Capture::checkBeforeShot(CaptureNotes& notes, const std::stop_token& stop) {
    addAll(notes.warnings, m_watch.look(m_settler.waitUntilIdle(stop)));
    std::set<std::string> names = m_guard.heldNames();
    names.insert(kTimingOptions.begin(), kTimingOptions.end());
    names.insert("remainingPictures");
    Json options = m_guard.read({names.begin(), names.end()}, stop);
    addAll(notes.warnings, m_watch.lookAtStorage(wholeNumber(options, "remainingPictures")));
    if (std::vector<std::string> changed = m_guard.hold(options, stop); !changed.empty()) {
        addAll(notes.warnings, std::move(changed));
        options.update(m_guard.read(kTimingOptions, stop));
    }
    m_client.waitUntilApplied(stop);
    return m_options.allowance.of(options);
}

survey::Baseline Capture::baseline(const std::stop_token& stop) {
    FileQuery query;
    query.entryCount = 1;
    const FileList newest = m_client.listFiles(query, stop);
    // The list, not the state's latest file: what is compared later is the list, and some cameras forget the
    // latest file when they restart.
    survey::Baseline before{{}, newest.totalEntries};
    if (!newest.entries.empty()) {
        before.latestFileUrl = markedUrl(newest.entries.front());
        pathOfUrl(before.latestFileUrl); // refuses now what could not be compared later
    }
    return before;
}

/// All that must be known and so before a trigger; tried again if the camera goes away meanwhile.
Capture::Ready Capture::readyForShot(CaptureNotes& notes, const std::stop_token& stop) {
    constexpr int kAttempts = 3;
    for (int attempt = 1;; ++attempt) {
        try {
            if (attempt > 1) {
                makeReady(notes, stop);
            }
            const auto allowance = checkBeforeShot(notes, stop);
            return {allowance, baseline(stop)};
        } catch (const Error& error) {
            const bool isAway = error.kind() == ErrorKind::Network || error.kind() == ErrorKind::Timeout;
            if (!isAway || attempt == kAttempts) {
                throw;
            }
        }
    }
}

/// A photo of a camera that has lost the profile since the settings were looked at may be exposed otherwise:
/// that is for a person to say, not to be passed over.
void Capture::doubtExposure(Resolution& resolution, const std::stop_token& stop) {
    const auto differences = [&] {
        try {
            return m_guard.exposureDifferences(stop);
        } catch (const Error& error) {
            if (!isCameraTrouble(error.kind())) {
                throw;
            }
            m_settler.reconnect(stop);
            return m_guard.exposureDifferences(stop);
        }
    }();
    if (differences.empty()) {
        return;
    }
    resolution.step = survey::ShotStep::Unclear;
    resolution.problem = ErrorKind::Corrupt;
    resolution.sentence = text(differences.front(), " after the photo ", fileNameOfUrl(resolution.fileUrl),
                               " was taken: it may be exposed differently from the others. It stays on the "
                               "camera; take it again.");
}

std::optional<std::int64_t> Capture::photosLeft() const {
    return m_watch.photosLeft();
}

bool Capture::mayTryAgain(OscErrorCode code, int refusals, const std::stop_token& stop) {
    if (isOfOtherLevel(code) && refusals == 0) {
        return m_client.renewLevel(stop); // the settings are looked at again before the next trigger
    }
    if (code == OscErrorCode::DisabledCommand && refusals == 0) {
        m_guard.applyImageMode(stop); // seen on a camera that had fallen into video mode
        return true;
    }
    if (refusals >= worthwhileRepeats(code)) {
        return false;
    }
    m_clock.sleep(m_options.busyPause * (1 << refusals), stop);
    throwIfStopped(stop);
    return true;
}

void CaptureOptions::validate() const {
    using std::chrono::milliseconds;
    requireCaptureTime("pollInterval", pollInterval, milliseconds(1));
    requireCaptureTime("allowance.base", allowance.base, milliseconds(1));
    requireCaptureTime("allowance.filterExtra", allowance.filterExtra, milliseconds(0));
    requireCaptureTime("triggerTime", triggerTime, milliseconds(1));
    requireCaptureTime("confirmTime", confirmTime, milliseconds(1));
    requireCaptureTime("reconnectTime", reconnectTime, milliseconds(1));
    requireCaptureTime("reconnectPause", reconnectPause, milliseconds(1));
    requireCaptureTime("idleTime", idleTime, milliseconds(1));
    requireCaptureTime("busyPause", busyPause, milliseconds(0));
    requireNumber("allowance.exposureFactor", allowance.exposureFactor, 100);
    requireNumber("allowance.timeScale", allowance.timeScale, 100);
    requireNumber("batteryWarning", batteryWarning, 1);
    requireNumber("batteryMinimum", batteryMinimum, 1);
    download.validate();
    if (profile) {
        profile->validate();
    }
}

CaptureOptions CaptureOptions::scaled(double factor) const {
    if (!(factor > 0 && factor <= 100)) {
        throw Error(ErrorKind::InvalidInput, "The time scale of a camera must lie above 0 and up to 100.");
    }
    CaptureOptions result = *this;
    for (auto* time : {&result.pollInterval, &result.allowance.base, &result.allowance.filterExtra,
                       &result.confirmTime, &result.reconnectTime, &result.reconnectPause, &result.idleTime,
                       &result.busyPause, &result.download.restartPause}) {
        *time = std::chrono::milliseconds(std::max(1LL, std::llround(double(time->count()) * factor)));
    }
    result.allowance.timeScale *= factor;
    return result;
}

} // namespace spherewalk::camera
