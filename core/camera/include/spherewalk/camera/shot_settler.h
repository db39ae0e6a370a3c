// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace spherewalk::camera {

/// What the camera's files say about a shot whose answer was lost.
struct NewFiles {
    enum class Count { None, One, Doubtful };

    Count count = Count::None;
    std::string fileUrl;  ///< URL of the one new file, without a mark; "" for another count.
    std::string why;      ///< Why the count is doubtful, as a sentence.
    std::string dateTime; ///< When the one new file was taken, by the camera's clock; "" if it is not told.
};

/// The file's URL with a mark: its size (or time) as a fragment. The mark tells the file from a later one of
/// the same name, because names repeat when a camera's counter begins anew.
std::string markedUrl(const FileEntry& entry);
/// Whether the URL has a mark.
bool isMarked(std::string_view url);
/// Whether the URL belongs to this file: path and mark are the same. Of a URL without a mark only the path
/// counts. Errors: those of pathOfUrl().
bool isFile(std::string_view url, const FileEntry& entry);

/// Compares the newest files (at least two, if there are so many) with what was there before the shot. One:
/// the count grew by one, the newest file is new, and the one below it is the newest of before. None: count
/// and newest file are unchanged, in size (or time) too if the baseline was marked. All else is doubtful,
/// such as two new files, deleted files, a reset counter or a changed storage. A photo must never be
/// attributed to a station by guessing. Errors: those of pathOfUrl().
NewFiles newFilesSince(const survey::Baseline& before, const FileList& newest);

/// How a shot was settled. The step is Taken, NotTaken or Unclear.
struct Resolution {
    survey::ShotStep step = survey::ShotStep::Unclear;
    std::string fileUrl;  ///< URL of the photo, without a mark. Of an Unclear shot: of the picture
                          ///< that may be its own; "" if there is none.
    std::string sentence; ///< For the operator; "" if the photo is Taken.
    std::optional<ErrorKind> problem; ///< Nothing if the photo is Taken; Corrupt if it is Unclear.
};

/// When a shot is over, and when its picture can have been taken.
struct Foreseen {
    /// Moments between which a trigger can have begun a picture.
    struct Window {
        std::chrono::system_clock::time_point begin;
        std::chrono::system_clock::time_point end;
    };

    Clock::TimePoint deadline; ///< The moment at which a triggered exposure is certainly over.
    /// Nothing if this program has waited since the trigger, so that the camera was not moved meanwhile. A
    /// single new picture then is the shot's, whenever it was begun.
    std::optional<Window> window = {};
};

/// Finds out how a shot ended that was, or may have been, triggered. Nothing is changed on the camera or in
/// the journal. The rules stand in capture.h. Errors of all functions: those of OscClient, if the camera
/// stays away or answers nonsense; Stopped. After an error the shot is as open as before. Owner: client,
/// clock and options must outlive the settler.
class ShotSettler {
  public:
    ShotSettler(OscClient& client, Clock& clock, const CaptureOptions& options)
        : m_client(client), m_clock(clock), m_options(options) {}

    /// Errors: also Busy if the camera stays busy, or if its files give no steady answer; Timeout if by the
    /// camera's word the command still runs after the deadline.
    Resolution resolve(const survey::Shot& shot, const Foreseen& foreseen, const std::stop_token& stop);

    /// Waits up to CaptureOptions::reconnectTime until a camera answers, and returns its description. It may
    /// be another camera. Errors: those of the last try.
    CameraInfo reconnect(const std::stop_token& stop);
    /// Waits up to CaptureOptions::idleTime until the camera is idle, and returns its state. Errors: also
    /// Busy.
    CameraState waitUntilIdle(const std::stop_token& stop);

  private:
    /// What the running command told. Without a resolution the files must tell the end.
    struct Followed {
        std::optional<Resolution> resolution;
        bool isDone = false; ///< Whether the camera says that it took the photo.
    };

    Followed follow(const survey::Shot& shot, Clock::TimePoint deadline, const std::stop_token& stop);
    Resolution inspectFiles(const survey::Shot& shot, const Foreseen& foreseen, const std::stop_token& stop);
    Resolution attribute(const survey::Shot& shot, const NewFiles& file, const Foreseen& foreseen,
                         const std::stop_token& stop);
    std::optional<std::chrono::seconds> agoByCamera(const std::string& dateTime, const std::stop_token& stop);
    std::optional<NewFiles> look(const survey::Shot& shot, const std::stop_token& stop);
    void requireNotRunning(const survey::Shot& shot, const std::stop_token& stop);
    void pause(Clock::Duration duration, const std::stop_token& stop);

    OscClient& m_client;
    Clock& m_clock;
    const CaptureOptions& m_options;
};

} // namespace spherewalk::camera
