// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/shot_settler.h"

#include "osc/camera_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"

#include <algorithm>
#include <utility>

namespace spherewalk::camera {

namespace {

Resolution taken(std::string fileUrl) {
    return {survey::ShotStep::Taken, std::move(fileUrl), {}, {}};
}

Resolution notTaken(std::string sentence, ErrorKind problem) {
    return {survey::ShotStep::NotTaken, {}, std::move(sentence), problem};
}

Resolution unclear(std::string sentence, std::string fileUrl = {}) {
    return {survey::ShotStep::Unclear, std::move(fileUrl), std::move(sentence), ErrorKind::Corrupt};
}

Resolution otherCamera(const survey::Shot& shot, const std::string& serial) {
    return unclear(text("Another camera answers now (serial number ", printable(serial),
                        "); whether the camera ", printable(shot.cameraSerial),
                        " has taken this photo must be looked up on it."));
}

bool isOtherFile(const std::string& fileUrl, const survey::Baseline& baseline) {
    return baseline.latestFileUrl.empty() || pathOfUrl(fileUrl) != pathOfUrl(baseline.latestFileUrl);
}

/// The size, which hardly ever repeats; a time is told in the zone that the camera happens to be set to.
std::string markOf(const FileEntry& entry) {
    if (entry.sizeBytes) {
        return text(*entry.sizeBytes);
    }
    std::string mark = entry.dateTime;
    std::replace(mark.begin(), mark.end(), ' ', '_');
    return mark;
}

/// Whether the file at this place of the list is the newest of before.
bool isLatest(const survey::Baseline& before, const FileList& list, std::size_t index) {
    if (index >= list.entries.size() || before.latestFileUrl.empty()) {
        return index >= list.entries.size() && before.latestFileUrl.empty();
    }
    return isFile(before.latestFileUrl, list.entries[index]);
}

NewFiles doubtfulFiles(std::string why) {
    return {NewFiles::Count::Doubtful, {}, std::move(why), {}};
}

} // namespace

void ShotSettler::pause(Clock::Duration duration, const std::stop_token& stop) {
    m_clock.sleep(duration, stop);
    throwIfStopped(stop);
}

CameraInfo ShotSettler::reconnect(const std::stop_token& stop) {
    const Clock::TimePoint giveUp = m_clock.now() + m_options.reconnectTime;
    for (;;) {
        try {
            return m_client.info(stop);
        } catch (const Error& error) {
            if (!isCameraTrouble(error.kind()) || m_clock.now() >= giveUp) {
                throw;
            }
        }
        pause(m_options.reconnectPause, stop);
    }
}

CameraState ShotSettler::waitUntilIdle(const std::stop_token& stop) {
    const Clock::TimePoint giveUp = m_clock.now() + m_options.idleTime;
    for (;;) {
        CameraState state = m_client.state(stop);
        if (state.isIdle()) {
            return state;
        }
        if (m_clock.now() >= giveUp) {
            throw Error(ErrorKind::Busy,
                        text("The camera stays busy (\"", printable(state.captureStatus),
                             "\"); end what it is doing, or switch it off and on, then resume."));
        }
        pause(m_options.pollInterval, stop);
    }
}

Resolution ShotSettler::resolve(const survey::Shot& shot, const Foreseen& foreseen,
                                const std::stop_token& stop) {
    Followed followed;
    if (!shot.commandId.empty()) {
        followed = follow(shot, foreseen.deadline, stop);
    }
    if (followed.resolution) {
        return *std::move(followed.resolution);
    }
    Resolution resolution = inspectFiles(shot, foreseen, stop);
    if (followed.isDone && resolution.step == survey::ShotStep::NotTaken) {
        return unclear(
            "The camera says that it has taken the photo, but has no new file: its files were deleted, or "
            "their names begin anew.");
    }
    return resolution;
}

/// Asks for the running command until it ends or is overdue.
ShotSettler::Followed ShotSettler::follow(const survey::Shot& shot, Clock::TimePoint deadline,
                                          const std::stop_token& stop) {
    for (;;) {
        try {
            const CommandReply reply = m_client.status(shot.commandId, stop);
            if (reply.state == CommandReply::State::Done) {
                const std::string fileUrl = reply.fileUrl();
                const bool isNew = !fileUrl.empty() && isOtherFile(fileUrl, shot.baseline);
                return {isNew ? std::optional(taken(fileUrl)) : std::nullopt, true};
            }
            if (reply.error == OscErrorCode::Canceled) {
                return {notTaken(refusal("take the photo", reply.error, reply.errorMessage).sentence(),
                                 ErrorKind::Busy)};
            }
            // A camera may forget an id once it has told the end: an answer lost on the way looks like this.
            if (reply.state == CommandReply::State::Error && worthwhileRepeats(reply.error) == 0) {
                return {};
            }
        } catch (const Error& error) {
            if (!isCameraTrouble(error.kind())) {
                throw;
            }
            // Another camera may have taken over the address and know the same id.
            if (const std::string serial = reconnect(stop).serialNumber; serial != shot.cameraSerial) {
                return {otherCamera(shot, serial)};
            }
        }
        if (m_clock.now() >= deadline) {
            return {};
        }
        pause(m_options.pollInterval, stop);
    }
}

/// One look at the files; nothing while the camera is busy.
std::optional<NewFiles> ShotSettler::look(const survey::Shot& shot, const std::stop_token& stop) {
    if (!m_client.state(stop).isIdle()) {
        return std::nullopt;
    }
    FileQuery query;
    query.entryCount = 2;
    return newFilesSince(shot.baseline, m_client.listFiles(query, stop));
}

void ShotSettler::requireNotRunning(const survey::Shot& shot, const std::stop_token& stop) {
    if (shot.commandId.empty() ||
        m_client.status(shot.commandId, stop).state != CommandReply::State::InProgress) {
        return;
    }
    throw Error(ErrorKind::Timeout,
                "The camera says that it is still taking the photo long after it must have been done; switch "
                "it off and on, then resume.");
}

/// How long ago the camera was at this moment, by its own clock; nothing if it does not tell.
std::optional<std::chrono::seconds> ShotSettler::agoByCamera(const std::string& dateTime,
                                                             const std::stop_token& stop) {
    const auto options = m_client.findOptions({"dateTimeZone"}, stop);
    const std::string now = options ? shortText(*options, "dateTimeZone").value_or("") : "";
    constexpr std::size_t kWithoutZone = 19;
    // A time without its zone is in the zone of the camera's clock.
    const std::string zone =
        dateTime.size() == kWithoutZone && now.size() > kWithoutZone ? now.substr(kWithoutZone) : "";
    const auto begin = parseCameraTime(dateTime + zone);
    const auto end = parseCameraTime(now);
    if (!begin || !end) {
        return std::nullopt;
    }
    return std::chrono::round<std::chrono::seconds>(*end - *begin);
}

/// Gives the one new file to the shot if nobody can have taken it otherwise.
Resolution ShotSettler::attribute(const survey::Shot& shot, const NewFiles& file, const Foreseen& foreseen,
                                  const std::stop_token& stop) {
    if (!foreseen.window) {
        return taken(file.fileUrl);
    }
    constexpr std::chrono::seconds kSlack(3); // two clocks that tell whole seconds
    const bool isTriggered = shot.step == survey::ShotStep::Started;
    const std::string name = fileNameOfUrl(file.fileUrl);
    const auto ago = agoByCamera(file.dateTime, stop);
    if (!ago) {
        return isTriggered
                   ? taken(file.fileUrl)
                   : unclear(text("Whether the camera was triggered is not known, nor when the picture ",
                                  name, " was taken. Is it of this station?"),
                             file.fileUrl);
    }
    const auto takenAt = m_clock.utc() - *ago;
    const auto& [begin, end] = *foreseen.window;
    if (takenAt >= begin - kSlack && takenAt <= end + kSlack) {
        return taken(file.fileUrl);
    }
    const auto late = std::chrono::round<std::chrono::seconds>(takenAt - begin).count();
    return unclear(text("The picture ", name, " was taken ", std::abs(late), " s ",
                        late < 0 ? "before" : "after",
                        " the shutter was to be pressed, perhaps by the camera's own button. Is it of this "
                        "station?"),
                   file.fileUrl);
}

Resolution ShotSettler::inspectFiles(const survey::Shot& shot, const Foreseen& foreseen,
                                     const std::stop_token& stop) {
    const Clock::TimePoint deadline = foreseen.deadline;
    if (const std::string serial = reconnect(stop).serialNumber; serial != shot.cameraSerial) {
        return otherCamera(shot, serial);
    }
    const Clock::TimePoint giveUp =
        std::max(deadline, m_clock.now()) + m_options.confirmTime + m_options.idleTime;
    std::optional<NewFiles::Count> seen; // what every look since seenAt has shown
    Clock::TimePoint seenAt;
    for (;;) {
        const Clock::TimePoint now = m_clock.now(); // before the look: a file that comes later is not missed
        std::optional<NewFiles> files;
        try {
            files = look(shot, stop);
            if (files && files->count == NewFiles::Count::One) {
                return attribute(shot, *files, foreseen, stop);
            }
        } catch (const Error& error) {
            if (!isCameraTrouble(error.kind())) {
                throw;
            }
            if (const std::string serial = reconnect(stop).serialNumber; serial != shot.cameraSerial) {
                return otherCamera(shot, serial);
            }
        }
        if (files && seen != files->count) {
            seen = files->count;
            seenAt = now;
        }
        const bool isConfirmed = files && now - seenAt >= m_options.confirmTime;
        if (isConfirmed && files->count == NewFiles::Count::Doubtful) {
            return unclear(files->why);
        }
        if (isConfirmed && now >= deadline) {
            requireNotRunning(shot, stop);
            return notTaken("The camera has taken no photo; it can be taken again.", ErrorKind::NotFound);
        }
        if (now >= giveUp) {
            throw Error(ErrorKind::Busy, "The camera stays busy or gives no steady answer about its files; "
                                         "switch it off and on, then resume.");
        }
        pause(m_options.pollInterval, stop);
    }
}

std::string markedUrl(const FileEntry& entry) {
    return text(entry.fileUrl, "#", markOf(entry));
}

bool isMarked(std::string_view url) {
    return url.find('#') != std::string_view::npos;
}

bool isFile(std::string_view url, const FileEntry& entry) {
    const std::size_t mark = url.find('#');
    const bool isSameMark = mark == std::string_view::npos || url.substr(mark + 1) == markOf(entry);
    return isSameMark && pathOfUrl(entry.fileUrl) == pathOfUrl(url);
}

NewFiles newFilesSince(const survey::Baseline& before, const FileList& newest) {
    if (newest.totalEntries == before.totalEntries && isLatest(before, newest, 0)) {
        return {};
    }
    if (newest.totalEntries > before.totalEntries + 1) {
        return doubtfulFiles(
            text("The camera holds ", newest.totalEntries - before.totalEntries,
                 " new photos where one was expected: another program or the camera's own button "
                 "took photos as well."));
    }
    const bool grewByOne = newest.totalEntries == before.totalEntries + 1;
    if (grewByOne && !newest.entries.empty() && !isLatest(before, newest, 0) && isLatest(before, newest, 1)) {
        return {NewFiles::Count::One, newest.entries.front().fileUrl, {}, newest.entries.front().dateTime};
    }
    return doubtfulFiles(
        text("The camera's files have changed in another way than by one photo (", before.totalEntries,
             " before, ", newest.totalEntries,
             " now): some were deleted, its file counter was reset, or its storage changed."));
}

} // namespace spherewalk::camera
