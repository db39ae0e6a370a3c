// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {

struct Resolution;

// The capture workflow. It can be killed at any instant and resumed with the same journal.
//
// 1. Connect. Ask who the camera is (several tries) and refuse what is no camera. Nothing on the camera is
//    changed, as it may still be exposing a shot of a run that was killed.
// 2. Settle. Every open shot of the journal is brought to an end before anything new: one that is Taken is
//    only downloaded; one that is Intended or Started is resolved as in step 7.
// 3. Prepare. Check errors, plug-in, battery and storage; save sleep and power-off times; set still mode,
//    the spherical JPEG and the exposure of the profile, never asleep; read back; set the clock. Again
//    whenever the camera has restarted.
// 4. Intend. Before each shot: same serial number (a camera that is away is waited for), camera idle and
//    well, battery and storage left, settings as they were set (else set again, with a warning), one second
//    since the last setting. Note what the camera holds (newest file and count) and write the shot to the
//    journal, durably.
// 5. Trigger. takePicture is sent exactly once, on a connection of its own. A refusal by the camera that
//    proves that nothing was done ends the shot as NotTaken; a momentary one is tried again as a new shot.
//    A running command's id is written to the journal. Anything else is "unknown" and goes to step 7.
// 6. Follow. Ask for the command's end until the deadline (30 s, self-timer, twice the exposure, filters).
//    Done with a file: Taken. Everything that is not a clear end goes to step 7.
// 7. Resolve by files. Reconnect; another serial number makes the shot Unclear. When the camera is idle,
//    look at the newest files. Exactly one new file above the old newest one: it is this shot's, at once.
//    Two or more, or any other change, seen twice a confirmation time apart: Unclear, a person decides. No
//    new file: NotTaken, but only if the deadline has passed, two looks a confirmation time apart agree, and
//    the camera says neither that the command still runs nor that it is done. The deadline counts from the
//    trigger; after a restart of the program from the time of the intention by the clock of day, since the
//    command may have left just before the kill. A clock that was set back makes the wait no longer than the
//    whole allowance; against one that was set forward stand the two looks. NotTaken alone makes a second
//    exposure right.
//    A photo that is Taken while the camera has not the profile's exposure any more, such as after a restart,
//    is Unclear: it may be exposed otherwise.
// 8. Fetch. Download the file, verify it, and hand it to the journal. What fails stays Taken on the camera
//    and in the journal, and is reported.
// 9. Disconnect. Put sleep and power-off times back.

/// How one shot ended.
struct ShotOutcome {
    Shot shot; ///< step: Downloaded, Taken (not yet downloaded), NotTaken or Unclear
    std::optional<DownloadedPhoto> photo;
    std::string sentence;             ///< for the operator, unless all is well
    std::optional<ErrorKind> problem; ///< likewise
    std::vector<std::string> warnings;
    Clock::Duration exposing{}; ///< from the trigger to the known file
    Clock::Duration fetching{}; ///< of download and checks
};

/// What a prepared camera is good for.
struct CameraReadiness {
    std::optional<std::int64_t> remainingPhotos;
    std::optional<double> batteryFraction;
    std::vector<std::string> warnings;
};

/// Takes the photos of a survey as described above.
/// Errors of all: Stopped; what the client throws if the camera stays away (an open shot then stays open);
/// Busy if it stays busy; what the journal throws. Stop: within 200 ms, except in the check of a photo.
/// Threads: one at a time, the client's.
class Capture {
  public:
    /// Owner: all must outlive the object. Errors: InvalidInput.
    Capture(OscClient& client, CaptureJournal& journal, Clock& clock, CaptureOptions options);
    ~Capture();
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

    /// Step 1. Errors: also Unsupported.
    CameraInfo connect(const std::stop_token& stop);
    /// Step 2, one outcome for each shot that was open. Connects if need be.
    std::vector<ShotOutcome> settle(const std::stop_token& stop);
    /// Step 3, after settling Intended and Started shots (told in the warnings). Errors: also Busy, Full,
    /// Unsupported for a camera that cannot take pictures now, with what to do.
    CameraReadiness prepare(const std::stop_token& stop);
    /// Steps 4 to 8, with 1 to 3 if need be. If that settles a shot of the same station which the camera has
    /// taken, the result is that one, fetched or with the reason why not, and nothing is exposed: only the
    /// next call takes the photo anew.
    ShotOutcome shoot(std::int64_t station, const std::stop_token& stop);
    /// Steps 4 to 7, likewise: the cart may move when it returns.
    ShotOutcome expose(std::int64_t station, const std::stop_token& stop);
    /// Step 8, of a shot that is Taken.
    ShotOutcome fetch(const Shot& shot, const std::stop_token& stop);
    /// Step 9. Errors: those of the client; the camera keeps the changed settings then.
    void disconnect(const std::stop_token& stop);
    /// How many more photos the camera's storage and battery allow, as far as it tells.
    std::optional<std::int64_t> photosLeft() const;
    /// The same after a stop or an error, tried for at most this long. False if the camera may keep the
    /// changed settings.
    bool disconnectWithin(std::chrono::milliseconds time);

  private:
    struct Parts;

    std::vector<ShotOutcome> settleExposures(const std::stop_token& stop);

    /// What is known just before a trigger.
    struct Ready {
        std::chrono::milliseconds allowance{};
        Baseline before;
    };

    Ready readyForShot(std::vector<std::string>& warnings, const std::stop_token& stop);
    CameraInfo reach(std::vector<std::string>& warnings, const std::stop_token& stop);
    void doubtExposure(Resolution& resolution, const std::stop_token& stop);
    std::vector<ShotOutcome> makeReady(std::vector<std::string>& warnings, const std::stop_token& stop);
    std::chrono::milliseconds checkBeforeShot(std::vector<std::string>& warnings,
                                              const std::stop_token& stop);
    Baseline baseline(const std::stop_token& stop);
    std::optional<CommandReply> trigger(const std::stop_token& stop);
    bool mayTryAgain(OscErrorCode code, int refusals, const std::stop_token& stop);
    Clock::TimePoint deadlineAfterRestart(const Shot& shot, const std::stop_token& stop);
    ShotOutcome follow(Shot shot, const std::optional<CommandReply>& reply, Clock::TimePoint deadline,
                       const std::stop_token& stop);
    std::string marked(std::string fileUrl, const std::stop_token& stop);
    void giveUpOlder(const Shot& shot, const std::string& fileUrl);
    ShotOutcome resolve(Shot shot, Clock::TimePoint deadline, const std::stop_token& stop);

    OscClient& m_client;
    CaptureJournal& m_journal;
    Clock& m_clock;
    CaptureOptions m_options;
    std::unique_ptr<Parts> m_parts;
    std::optional<CameraInfo> m_camera;
    bool m_isPrepared = false;
    bool m_hasSettled = false; ///< what an earlier run left open
};

} // namespace spherewalk::camera
