// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/new_files.h"
#include "spherewalk/camera/osc_client.h"

#include <optional>
#include <stop_token>
#include <string>

namespace spherewalk::camera {

/// What has become of a shot. step: Taken, NotTaken or Unclear.
struct Resolution {
    ShotStep step = ShotStep::Unclear;
    std::string fileUrl; ///< of Taken
    std::string sentence;
    std::optional<ErrorKind> problem; ///< of the others
};

/// Finds out what has become of a shot that was, or may have been, triggered; changes nothing. The rules
/// stand in capture.h. Errors: Network, Timeout, ... if the camera stays away, Busy if it stays busy,
/// Stopped: the shot is then as open as before.
class ShotSettler {
  public:
    ShotSettler(OscClient& client, Clock& clock, const CaptureOptions& options)
        : m_client(client), m_clock(clock), m_options(options) {}

    /// deadline: when an exposure that was triggered is certainly over.
    Resolution resolve(const Shot& shot, Clock::TimePoint deadline, const std::stop_token& stop);

    /// Waits for the camera to answer. Who does. Errors: of the last try.
    CameraInfo reconnect(const std::stop_token& stop);
    /// The state in which it is idle. Errors: Busy.
    CameraState waitUntilIdle(const std::stop_token& stop);

  private:
    /// What came of the command; nothing, if its end must be read from the files.
    struct Followed {
        std::optional<Resolution> resolution;
        bool isDone = false; ///< the camera says that it took the photo
    };

    Followed follow(const Shot& shot, Clock::TimePoint deadline, const std::stop_token& stop);
    Resolution inspectFiles(const Shot& shot, Clock::TimePoint deadline, const std::stop_token& stop);
    std::optional<NewFiles> look(const Shot& shot, const std::stop_token& stop);
    void requireNotRunning(const Shot& shot, const std::stop_token& stop);
    void pause(Clock::Duration duration, const std::stop_token& stop);

    OscClient& m_client;
    Clock& m_clock;
    const CaptureOptions& m_options;
};

} // namespace spherewalk::camera
