// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/capture.h"

#include "shot_settler.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace spherewalk::camera {

namespace {

/// What makes a shot take longer.
const std::vector<std::string> kTimingOptions{"exposureDelay", "shutterSpeed", "_filter"};

void requireLevel2(const CameraInfo& info, const CameraState& state) {
    // One that speaks both must say that it is in level 2, as it falls back to 1 when it loses the link.
    if (info.hasApiLevel(2) && state.apiVersion.value_or(info.hasApiLevel(1) ? 1 : 2) >= 2) {
        return;
    }
    throw Error(ErrorKind::Unsupported, text("The camera ", printable(info.model),
                                             " speaks API level 1, which cannot be used yet; update "
                                             "its firmware, or use a Theta V or newer."));
}

void requireStorage(std::optional<std::int64_t> remainingPhotos) {
    if (remainingPhotos && *remainingPhotos <= 0) {
        throw Error(ErrorKind::Full, "The camera's storage is full; back its photos up, free some space, and "
                                     "resume.");
    }
}

bool isResolved(const Shot& shot) {
    return shot.step != ShotStep::Intended && shot.step != ShotStep::Started;
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

/// What a killed run left of this shot's download.
void removeLeftovers(const std::filesystem::path& target) {
    // A leftover that cannot be removed costs space, nothing else.
    std::error_code listing;
    std::filesystem::directory_iterator entry(target.parent_path(), listing);
    for (; !listing && entry != std::filesystem::directory_iterator(); entry.increment(listing)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(target.filename().string() + ".") && name.ends_with(".part")) {
            std::error_code removing;
            std::filesystem::remove(entry->path(), removing);
        }
    }
}

} // namespace

struct Capture::Parts {
    Parts(OscClient& client, Clock& clock, const CaptureOptions& options)
        : guard(client, options.profile), settler(client, clock, options) {}

    SettingsGuard guard;
    ShotSettler settler;
};

Capture::Capture(OscClient& client, CaptureJournal& journal, Clock& clock, CaptureOptions options)
    : m_client(client), m_journal(journal), m_clock(clock), m_options(std::move(options)) {
    m_options.validate();
    m_parts = std::make_unique<Parts>(client, clock, m_options);
}

Capture::~Capture() = default;

CameraInfo Capture::connect(const std::stop_token& stop) {
    CameraInfo info = m_client.info(stop);
    requireLevel2(info, m_client.state(stop));
    m_camera = info;
    m_isPrepared = false;
    return info;
}

std::vector<ShotOutcome> Capture::settle(const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    std::vector<ShotOutcome> outcomes = settleExposures(stop);
    std::erase_if(outcomes, [](const ShotOutcome& outcome) { return outcome.shot.step == ShotStep::Taken; });
    for (const Shot& shot : m_journal.openShots()) {
        if (shot.step == ShotStep::Taken) {
            outcomes.push_back(fetch(shot, stop));
        }
    }
    m_hasSettled = true;
    return outcomes;
}

std::vector<ShotOutcome> Capture::settleExposures(const std::stop_token& stop) {
    std::vector<ShotOutcome> outcomes;
    for (const Shot& shot : m_journal.openShots()) {
        if (!isResolved(shot)) {
            outcomes.push_back(resolve(shot, deadlineAfterRestart(shot, stop), stop));
        }
    }
    return outcomes;
}

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

void Capture::checkHealth(CameraReadiness& readiness, const std::stop_token& stop) {
    const CameraState state = m_client.state(stop);
    for (const std::string& code : state.errors) {
        CameraTrouble trouble = describeCameraError(code);
        if (trouble.blocks) {
            throw Error(code == "NO_MEMORY" ? ErrorKind::Full : ErrorKind::Busy, trouble.sentence, code);
        }
        readiness.warnings.push_back(std::move(trouble.sentence));
    }
    if (state.isPluginRunning) {
        throw Error(ErrorKind::Busy,
                    "A plug-in runs on the camera; end it by the camera's mode button, then resume.");
    }
    readiness.batteryFraction = state.batteryFraction;
    const double battery = state.batteryFraction.value_or(1);
    const bool isCharging = state.batteryState == "charging" || state.batteryState == "charged";
    const std::string percent = text(fixed(100 * battery, 0), " %");
    if (battery <= m_options.batteryMinimum && !isCharging) {
        throw Error(ErrorKind::Busy,
                    text("The camera's battery is at ", percent, "; charge it before going on."));
    }
    if (battery <= m_options.batteryWarning) {
        readiness.warnings.push_back(text("The camera's battery is at ", percent, "; charge it soon."));
    }
}

CameraReadiness Capture::prepare(const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    CameraReadiness readiness;
    addWarnings(readiness.warnings, settleExposures(stop));
    checkHealth(readiness, stop);
    m_parts->settler.waitUntilIdle(stop);
    for (std::string& warning : m_parts->guard.apply(stop)) {
        readiness.warnings.push_back(std::move(warning));
    }
    readiness.remainingPhotos =
        wholeNumber(m_parts->guard.read({"remainingPictures"}, stop), "remainingPictures");
    requireStorage(readiness.remainingPhotos);
    if (readiness.remainingPhotos && *readiness.remainingPhotos < m_options.remainingWarning) {
        readiness.warnings.push_back(
            text("The camera has room for only ", *readiness.remainingPhotos, " more photos."));
    }
    m_isPrepared = true;
    return readiness;
}

/// Brings the camera to where the next shot may be intended, whatever has happened since the last one. What
/// had to be settled first.
std::vector<ShotOutcome> Capture::makeReady(std::vector<std::string>& warnings, const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    std::vector<ShotOutcome> settled = m_hasSettled ? settleExposures(stop) : settle(stop);
    addWarnings(warnings, settled);
    const CameraInfo info = m_client.info(stop);
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
    m_parts->settler.waitUntilIdle(stop);
    std::set<std::string> names = m_parts->guard.heldNames();
    names.insert(kTimingOptions.begin(), kTimingOptions.end());
    names.insert("remainingPictures");
    Json options = m_parts->guard.read({names.begin(), names.end()}, stop);
    requireStorage(wholeNumber(options, "remainingPictures"));
    if (std::vector<std::string> changed = m_parts->guard.hold(options, stop); !changed.empty()) {
        std::move(changed.begin(), changed.end(), std::back_inserter(warnings));
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
        before.latestFileUrl = newest.entries.front().fileUrl;
        pathOfUrl(before.latestFileUrl); // refuses now what could not be compared later
    }
    return before;
}

/// Nothing if it is unknown what has become of the trigger.
std::optional<CommandReply> Capture::trigger(const std::stop_token& stop) {
    try {
        CommandReply reply = m_client.takePicture(stop);
        const bool isRefusal = reply.isFromCamera && provesNothingDone(reply.error);
        if (reply.state == CommandReply::State::Error && !isRefusal) {
            return std::nullopt;
        }
        return reply;
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
        return std::nullopt; // the picture may have been taken all the same
    }
}

bool Capture::mayTryAgain(OscErrorCode code, int refusals, const std::stop_token& stop) {
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

ShotOutcome Capture::expose(std::int64_t station, const std::stop_token& stop) {
    std::vector<std::string> warnings;
    for (ShotOutcome& earlier : makeReady(warnings, stop)) {
        const ShotStep step = earlier.shot.step;
        if (earlier.shot.station == station && (step == ShotStep::Taken || step == ShotStep::Downloaded)) {
            earlier.warnings = std::move(warnings);
            return std::move(earlier); // what was asked for has been done already
        }
    }
    for (int refusals = 0;; ++refusals) {
        const auto allowance = checkBeforeShot(warnings, stop);
        const Baseline before = baseline(stop);
        throwIfStopped(stop);
        const Shot shot = m_journal.begin(station, m_camera->serialNumber, before);
        const Clock::TimePoint triggeredAt = m_clock.now();
        const std::optional<CommandReply> reply = trigger(stop);
        const bool isRefused = reply && reply->state == CommandReply::State::Error;
        if (isRefused) {
            m_journal.notTaken(shot.id);
            if (mayTryAgain(reply->error, refusals, stop)) {
                continue;
            }
        }
        ShotOutcome outcome;
        if (isRefused) {
            const Error error = refusal("take the photo", reply->error, reply->errorMessage);
            outcome.shot = shot;
            outcome.shot.step = ShotStep::NotTaken;
            outcome.sentence = error.sentence();
            outcome.problem = error.kind();
        } else {
            outcome = follow(shot, reply, triggeredAt + allowance, stop);
        }
        outcome.warnings = std::move(warnings);
        outcome.exposing = m_clock.now() - triggeredAt;
        return outcome;
    }
}

ShotOutcome Capture::follow(Shot shot, const std::optional<CommandReply>& reply, Clock::TimePoint deadline,
                            const std::stop_token& stop) {
    if (reply && reply->state == CommandReply::State::InProgress) {
        m_journal.started(shot.id, reply->id);
        shot.step = ShotStep::Started;
        shot.commandId = reply->id;
    }
    return resolve(std::move(shot), deadline, stop);
}

ShotOutcome Capture::resolve(Shot shot, Clock::TimePoint deadline, const std::stop_token& stop) {
    Resolution resolution = m_parts->settler.resolve(shot, deadline, stop);
    switch (resolution.step) {
    case ShotStep::Taken:
        m_journal.taken(shot.id, resolution.fileUrl);
        shot.fileUrl = resolution.fileUrl;
        break;
    case ShotStep::NotTaken:
        m_journal.notTaken(shot.id);
        break;
    default:
        m_journal.unclear(shot.id, resolution.sentence);
        shot.note = resolution.sentence;
        break;
    }
    shot.step = resolution.step;
    ShotOutcome outcome;
    outcome.shot = std::move(shot);
    outcome.sentence = std::move(resolution.sentence);
    outcome.problem = resolution.problem;
    return outcome;
}

ShotOutcome Capture::fetch(const Shot& shot, const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    ShotOutcome outcome;
    outcome.shot = shot;
    if (shot.cameraSerial != m_camera->serialNumber) {
        outcome.sentence = text("The photo lies on the camera ", printable(shot.cameraSerial),
                                "; connect to that one to download it.");
        outcome.problem = ErrorKind::NotFound;
        return outcome;
    }
    const Clock::TimePoint start = m_clock.now();
    const auto target = m_journal.downloadFolder() / text("shot-", shot.id, ".incoming");
    removeLeftovers(target);
    try {
        outcome.photo = downloadPhoto(m_client, m_clock, shot.fileUrl, target, m_options.download, stop);
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
        outcome.sentence = error.sentence();
        outcome.problem = error.kind();
    }
    if (outcome.photo) {
        m_journal.downloaded(shot.id, *outcome.photo);
        outcome.shot.step = ShotStep::Downloaded;
    }
    outcome.fetching = m_clock.now() - start;
    return outcome;
}

ShotOutcome Capture::shoot(std::int64_t station, const std::stop_token& stop) {
    ShotOutcome exposed = expose(station, stop);
    if (exposed.shot.step != ShotStep::Taken || exposed.problem) {
        return exposed;
    }
    ShotOutcome fetched = fetch(exposed.shot, stop);
    fetched.warnings = std::move(exposed.warnings);
    fetched.exposing = exposed.exposing;
    return fetched;
}

bool Capture::disconnectWithin(std::chrono::milliseconds time) {
    std::stop_source end;
    const std::jthread timer([&](const std::stop_token& isDone) {
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        never.wait_for(lock, isDone, time, [] { return false; });
        end.request_stop();
    });
    try {
        disconnect(end.get_token());
        return true;
    } catch (const Error&) { // there is an error or a stop already, which the caller reports
        return false;
    }
}

void Capture::disconnect(const std::stop_token& stop) {
    m_isPrepared = false;
    m_parts->guard.restore(stop);
}

} // namespace spherewalk::camera
