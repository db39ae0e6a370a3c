// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/capture.h"

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

bool isResolved(const survey::Shot& shot) {
    return shot.step != survey::ShotStep::Intended && shot.step != survey::ShotStep::Started;
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

Capture::Capture(OscClient& client, CaptureJournal& journal, Clock& clock, CaptureOptions options)
    : m_client(client),
      m_journal(journal),
      m_clock(clock),
      m_options(std::move(options)),
      m_guard(client, m_options.profile),
      m_settler(client, clock, m_options),
      m_watch(m_options) {
    m_options.validate();
}

CameraInfo Capture::connect(const std::stop_token& stop) {
    CameraInfo info = m_client.info(stop);
    if (!info.hasApiLevel(1) && !info.hasApiLevel(2)) {
        throw Error(ErrorKind::Unsupported, text("The camera ", printable(info.model),
                                                 " speaks neither API level 1 nor 2; use another."));
    }
    m_client.state(stop); // it answers commands too
    m_camera = info;
    m_isPrepared = false;
    return info;
}

std::vector<ShotOutcome> Capture::settle(const std::stop_token& stop) {
    if (!m_camera) {
        connect(stop);
    }
    std::vector<ShotOutcome> outcomes = settleExposures(stop);
    std::erase_if(outcomes,
                  [](const ShotOutcome& outcome) { return outcome.shot.step == survey::ShotStep::Taken; });
    for (const survey::Shot& shot : m_journal.openShots()) {
        if (shot.step == survey::ShotStep::Taken) {
            outcomes.push_back(fetch(shot, stop));
        }
    }
    m_hasSettled = true;
    return outcomes;
}

std::vector<ShotOutcome> Capture::settleExposures(const std::stop_token& stop) {
    std::vector<ShotOutcome> outcomes;
    for (const survey::Shot& shot : m_journal.openShots()) {
        if (!isResolved(shot)) {
            outcomes.push_back(resolve(shot, foreseenAfterRestart(shot, stop), stop));
        }
    }
    return outcomes;
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

ShotOutcome Capture::expose(std::int64_t station, const std::stop_token& stop) {
    CaptureNotes notes;
    for (ShotOutcome& earlier : makeReady(notes, stop)) {
        const survey::ShotStep step = earlier.shot.step;
        if (earlier.shot.station == station &&
            (step == survey::ShotStep::Taken || step == survey::ShotStep::Downloaded)) {
            static_cast<CaptureNotes&>(earlier) = std::move(notes);
            return std::move(earlier); // what was asked for has been done already
        }
    }
    for (int refusals = 0;; ++refusals) {
        const auto [allowance, before] = readyForShot(notes, stop);
        throwIfStopped(stop);
        const survey::Shot shot = m_journal.begin(station, m_camera->serialNumber, before);
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
            outcome.shot.step = survey::ShotStep::NotTaken;
            outcome.sentence = error.sentence();
            outcome.problem = error.kind();
        } else {
            outcome = follow(shot, reply, {triggeredAt + allowance}, stop);
        }
        static_cast<CaptureNotes&>(outcome) = std::move(notes);
        outcome.exposing = m_clock.now() - triggeredAt;
        return outcome;
    }
}

ShotOutcome Capture::follow(survey::Shot shot, const std::optional<CommandReply>& reply,
                            const Foreseen& foreseen, const std::stop_token& stop) {
    if (reply && reply->state == CommandReply::State::InProgress) {
        m_journal.started(shot.id, reply->id);
        shot.step = survey::ShotStep::Started;
        shot.commandId = reply->id;
    }
    return resolve(std::move(shot), foreseen, stop);
}

ShotOutcome Capture::resolve(survey::Shot shot, const Foreseen& foreseen, const std::stop_token& stop) {
    Resolution resolution = m_settler.resolve(shot, foreseen, stop);
    if (resolution.step == survey::ShotStep::Taken) {
        m_watch.notePhoto();
        giveUpOlder(shot, resolution.fileUrl);
        doubtExposure(resolution, stop);
        resolution.fileUrl = marked(std::move(resolution.fileUrl), stop);
    }
    switch (resolution.step) {
    case survey::ShotStep::Taken:
        m_journal.taken(shot.id, resolution.fileUrl);
        shot.fileUrl = resolution.fileUrl;
        break;
    case survey::ShotStep::NotTaken:
        m_journal.notTaken(shot.id);
        break;
    default:
        m_journal.unclear(shot.id, resolution.sentence, resolution.fileUrl);
        shot.note = resolution.sentence;
        shot.fileUrl = resolution.fileUrl;
        break;
    }
    shot.step = resolution.step;
    ShotOutcome outcome;
    outcome.shot = std::move(shot);
    outcome.sentence = std::move(resolution.sentence);
    outcome.problem = resolution.problem;
    return outcome;
}

/// With what tells the file from a later one of the same name, if the camera lists it.
std::string Capture::marked(std::string fileUrl, const std::stop_token& stop) {
    try {
        if (const auto entry = m_client.findFile(fileUrl, stop)) {
            return markedUrl(*entry);
        }
    } catch (const Error& error) {
        if (!isCameraTrouble(error.kind())) {
            throw;
        }
    }
    return fileUrl;
}

/// A camera whose counter began anew gives a name again: what lay under it is gone, and this photo is not it.
void Capture::giveUpOlder(const survey::Shot& shot, const std::string& fileUrl) {
    for (const survey::Shot& older : m_journal.openShots()) {
        if (older.id != shot.id && older.step == survey::ShotStep::Taken &&
            older.cameraSerial == shot.cameraSerial && pathOfUrl(older.fileUrl) == pathOfUrl(fileUrl)) {
            m_journal.unclear(older.id,
                              text("The camera has given the name ", fileNameOfUrl(fileUrl),
                                   " to another photo before this one was downloaded; take it again."),
                              "");
        }
    }
}

ShotOutcome Capture::fetch(const survey::Shot& shot, const std::stop_token& stop) {
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
        outcome.shot = m_journal.downloaded(shot.id, *outcome.photo);
        if (outcome.shot.step == survey::ShotStep::Unclear) {
            outcome.photo.reset();
            outcome.sentence = outcome.shot.note;
            outcome.problem = ErrorKind::Exists;
        }
    }
    outcome.fetching = m_clock.now() - start;
    return outcome;
}

ShotOutcome Capture::shoot(std::int64_t station, const std::stop_token& stop) {
    ShotOutcome exposed = expose(station, stop);
    if (exposed.shot.step != survey::ShotStep::Taken || exposed.problem) {
        return exposed;
    }
    ShotOutcome fetched = fetch(exposed.shot, stop);
    fetched.exposing = exposed.exposing;
    static_cast<CaptureNotes&>(fetched) = std::move(exposed);
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

std::vector<std::string> Capture::disconnect(const std::stop_token& stop) {
    m_isPrepared = false;
    return m_guard.restore(stop);
}

} // namespace spherewalk::camera
