// SPDX-License-Identifier: GPL-3.0-or-later
// What the workflow makes sure of before a shot, and after it.
#include "capture_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <iterator>
#include <set>
#include <utility>

namespace spherewalk::camera {

namespace {

/// What makes a shot take longer.
const std::vector<std::string> kTimingOptions{"exposureDelay", "shutterSpeed", "_filter"};

void addAll(std::vector<std::string>& warnings, std::vector<std::string> more) {
    std::move(more.begin(), more.end(), std::back_inserter(warnings));
}

/// Tells of settled shots that left no photo.
void addWarnings(std::vector<std::string>& warnings, const std::vector<ShotOutcome>& settled) {
    for (const ShotOutcome& outcome : settled) {
        if (!outcome.sentence.empty()) {
            warnings.push_back(
                text("An earlier photo of station ", outcome.shot.station, ": ", outcome.sentence));
        }
    }
}

} // namespace

Clock::TimePoint Capture::deadlineAfterRestart(const Shot& shot, const std::stop_token& stop) {
    const auto allowance = m_options.allowance.of(m_parts->guard.read(kTimingOptions, stop));
    const auto now = m_clock.utc();
    if (shot.intendedAt <= now - allowance) {
        return m_clock.now();
    }
    // Intended in the future: the clock was set back, so that nothing shorter than all of it is safe.
    const auto left = shot.intendedAt >= now
                          ? allowance
                          : std::chrono::ceil<std::chrono::milliseconds>(shot.intendedAt + allowance - now);
    return m_clock.now() + left;
}

CameraReadiness Capture::prepare(const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    CameraReadiness readiness;
    addWarnings(readiness.warnings, settleExposures(stop));
    m_parts->watch.beginAnew();
    const CameraState state = m_client.state(stop);
    addAll(readiness.warnings, m_parts->watch.look(state));
    readiness.batteryFraction = state.batteryFraction;
    m_parts->settler.waitUntilIdle(stop);
    m_parts->guard.rememberIn(m_journal.downloadFolder(), m_camera->serialNumber);
    addAll(readiness.warnings, m_parts->guard.apply(stop));
    addAll(readiness.warnings, m_parts->guard.setClock(m_clock.utc(), stop));
    readiness.remainingPhotos =
        wholeNumber(m_parts->guard.read({"remainingPictures"}, stop), "remainingPictures");
    addAll(readiness.warnings, m_parts->watch.lookAtStorage(readiness.remainingPhotos));
    m_isPrepared = true;
    return readiness;
}

/// Who answers, after a while if need be.
CameraInfo Capture::reach(std::vector<std::string>& warnings, const std::stop_token& stop) {
    const Clock::TimePoint begin = m_clock.now();
    try {
        return m_client.info(stop);
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
    }
    CameraInfo info = m_parts->settler.reconnect(stop);
    const std::chrono::duration<double> away = m_clock.now() - begin;
    warnings.push_back(text("The camera did not answer for ", fixed(away.count(), 0), " s."));
    return info;
}

/// Brings the camera to where the next shot may be intended, whatever has happened since the last one. What
/// had to be settled first.
std::vector<ShotOutcome> Capture::makeReady(std::vector<std::string>& warnings, const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    std::vector<ShotOutcome> settled = m_hasSettled ? settleExposures(stop) : settle(stop);
    addWarnings(warnings, settled);
    const CameraInfo info = reach(warnings, stop);
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
        const CameraReadiness readiness = prepare(stop);
        warnings.insert(warnings.end(), readiness.warnings.begin(), readiness.warnings.end());
    }
    return settled;
}

std::chrono::milliseconds Capture::checkBeforeShot(std::vector<std::string>& warnings,
                                                   const std::stop_token& stop) {
    addAll(warnings, m_parts->watch.look(m_parts->settler.waitUntilIdle(stop)));
    std::set<std::string> names = m_parts->guard.heldNames();
    names.insert(kTimingOptions.begin(), kTimingOptions.end());
    names.insert("remainingPictures");
    Json options = m_parts->guard.read({names.begin(), names.end()}, stop);
    addAll(warnings, m_parts->watch.lookAtStorage(wholeNumber(options, "remainingPictures")));
    if (std::vector<std::string> changed = m_parts->guard.hold(options, stop); !changed.empty()) {
        addAll(warnings, std::move(changed));
        options.update(m_parts->guard.read(kTimingOptions, stop));
    }
    m_client.settle(stop);
    return m_options.allowance.of(options);
}

Baseline Capture::baseline(const std::stop_token& stop) {
    FileQuery query;
    query.entryCount = 1;
    const FileList newest = m_client.listFiles(query, stop);
    // The list, not the state's latest file: what is compared later is the list, and some cameras forget the
    // latest file when they restart.
    Baseline before{{}, newest.totalEntries};
    if (!newest.entries.empty()) {
        before.latestFileUrl = markedUrl(newest.entries.front());
        pathOfUrl(before.latestFileUrl); // refuses now what could not be compared later
    }
    return before;
}

/// All that must be known and so before a trigger; tried again if the camera goes away meanwhile.
Capture::Ready Capture::readyForShot(std::vector<std::string>& warnings, const std::stop_token& stop) {
    constexpr int kAttempts = 3;
    for (int attempt = 1;; ++attempt) {
        try {
            if (attempt > 1) {
                makeReady(warnings, stop);
            }
            const auto allowance = checkBeforeShot(warnings, stop);
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
            return m_parts->guard.exposureDifferences(stop);
        } catch (const Error& error) {
            if (!isCameraTrouble(error.kind())) {
                throw;
            }
            m_parts->settler.reconnect(stop);
            return m_parts->guard.exposureDifferences(stop);
        }
    }();
    if (differences.empty()) {
        return;
    }
    resolution.step = ShotStep::Unclear;
    resolution.problem = ErrorKind::Corrupt;
    resolution.sentence = text(differences.front(), " after the photo ", fileNameOfUrl(resolution.fileUrl),
                               " was taken: it may be exposed differently from the others. It stays on the "
                               "camera; take it again.");
}

std::optional<std::int64_t> Capture::photosLeft() const {
    return m_parts->watch.photosLeft();
}

bool Capture::mayTryAgain(OscErrorCode code, int refusals, const std::stop_token& stop) {
    if (isOfOtherLevel(code) && refusals == 0) {
        return m_client.renewLevel(stop); // the settings are looked at again before the next trigger
    }
    if (code == OscErrorCode::DisabledCommand && refusals == 0) {
        m_parts->guard.applyImageMode(stop); // seen on a camera that had fallen into video mode
        return true;
    }
    if (refusals >= worthwhileRepeats(code)) {
        return false;
    }
    m_clock.sleep(m_options.busyPause * (1 << refusals), stop);
    throwIfStopped(stop);
    return true;
}

} // namespace spherewalk::camera
