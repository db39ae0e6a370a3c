// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/camera_watch.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"
#include "spherewalk/camera/settings_guard.h"
#include "spherewalk/camera/shot_settler.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {

// The capture workflow. It can be killed at any instant and resumed with the same journal.
//
// 1. Connect. Ask who the camera is (several tries), and refuse a host that is no camera. Nothing on the
//    camera is changed, because it may still be exposing a shot of a run that was killed.
// 2. Settle. Before anything new, every open shot of the journal gets its end. A shot that is Taken is only
//    downloaded. A shot that is Intended or Started is resolved as in step 7.
// 3. Prepare. Check errors, plug-in, battery and storage, and save the camera's own settings. Set still
//    mode, the spherical JPEG, the exposure of the profile and no sleep; read them back; set the clock. This
//    is done again whenever the camera has restarted.
// 4. Intend. Before each shot the serial number is the same, and the camera is idle and well. A camera that
//    is away is waited for. Battery and storage suffice, and the settings are still in force; otherwise they
//    are set again, with a warning. One second has passed since the last setting. Then the newest file and
//    the number of files are noted, and the shot is written to the journal, durably.
// 5. Trigger. takePicture is sent exactly once, on a connection of its own. A refusal that proves that
//    nothing was done ends the shot as NotTaken; after a momentary refusal a new shot is tried. The id of a
//    running command is written to the journal. Any other answer is "unknown" and leads to step 7.
// 6. Follow. Ask for the command's end until the deadline (30 s, self-timer, twice the exposure, filters). A
//    command that is done and names a file makes the shot Taken. Any other end leads to step 7.
// 7. Resolve by files. Reconnect; another serial number makes the shot Unclear. When the camera is idle, look
//    at the newest files.
//    - Exactly one new file above the old newest one belongs to this shot, at once. After a restart of the
//      program, the camera may have been moved and its button pressed. The file's time must then be the one
//      that the journal foresees; otherwise the shot is Unclear, and a person is asked.
//    - Two new files or any other change make the shot Unclear, if two looks a confirmation time apart agree.
//      A person then decides.
//    - Without a new file the shot is NotTaken, if the deadline has passed, two looks a confirmation time
//      apart agree, and the camera says neither that the command runs nor that it is done.
//    The deadline counts from the trigger. After a restart of the program it counts from the intention by the
//    clock of day, because the command may have left just before the kill. If the clock was set back, the
//    wait is no longer than the whole allowance; if it was set forward, the two looks still protect the shot.
//    Only NotTaken permits a second exposure. A photo is Unclear if the camera has lost the profile's
//    exposure, such as by a restart, because the photo may be exposed differently.
// 8. Fetch. Download the file, verify it, and hand it to the journal. After a failure the photo stays Taken,
//    on the camera and in the journal, and the failure is reported. A photo that the survey has already, at
//    another station or from another shot, makes the shot Unclear.
// 9. Disconnect. Put all settings but the clock back, sleep and power-off times first.

/// A sentence about an earlier shot that left no photo, with the identity of its station.
struct EarlierShot {
    std::int64_t station = 0;
    std::string sentence;
};

/// What the operator should read beside a result.
struct CaptureNotes {
    std::vector<EarlierShot> earlier;  ///< Shots that were still open and had to be settled first.
    std::vector<std::string> warnings; ///< Sentences about the camera.
};

/// How one shot ended. Its step is Downloaded, Taken (not yet downloaded), NotTaken or Unclear.
struct ShotOutcome : CaptureNotes {
    survey::Shot shot;
    std::optional<DownloadedPhoto> photo; ///< The photo, once it is downloaded.
    std::string sentence;                 ///< What the operator should know and do; "" if all is well.
    std::optional<ErrorKind> problem;     ///< The kind of what the sentence tells; nothing if all is well.
    Clock::Duration exposing{};           ///< Time from the trigger to the known file.
    Clock::Duration fetching{};           ///< Time of the download and the checks.
};

/// What a prepared camera is good for.
struct CameraReadiness : CaptureNotes {
    std::optional<std::int64_t> remainingPhotos; ///< Photos that still fit into the storage, if it is known.
    std::optional<double> batteryFraction;       ///< Charge of the battery, from 0 to 1, if it is known.
};

/// Takes the photos of a survey by the workflow above. Errors of all functions: Stopped; those of the client
/// if the camera stays away, and an open shot then stays open; Busy if the camera stays busy; those of the
/// journal. Stop: within 200 ms, except in the check of a photo. Threads: one at a time, the client's.
class Capture {
  public:
    /// Owner: all must outlive the object. Errors: InvalidInput.
    Capture(OscClient& client, CaptureJournal& journal, Clock& clock, CaptureOptions options);
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

    /// Step 1. Errors: also Unsupported.
    CameraInfo connect(const std::stop_token& stop);
    /// Step 2. Returns one outcome for each shot that was open. Connects first if necessary.
    std::vector<ShotOutcome> settle(const std::stop_token& stop);
    /// Step 3, after settling Intended and Started shots, which the notes tell of. Errors: also Busy, Full
    /// and Unsupported for a camera that cannot take pictures now; the sentence says what to do.
    CameraReadiness prepare(const std::stop_token& stop);
    /// Steps 4 to 8, after steps 1 to 3 if necessary. If settling finds that the camera has already taken a
    /// photo of this station, nothing is exposed. The outcome is then that photo, fetched or with the reason
    /// why not; only the next call takes the photo anew.
    ShotOutcome shoot(std::int64_t station, const std::stop_token& stop);
    /// Steps 4 to 7, in the same way. The cart may move when the function returns.
    ShotOutcome expose(std::int64_t station, const std::stop_token& stop);
    /// Step 8 for a shot that is Taken.
    ShotOutcome fetch(const survey::Shot& shot, const std::stop_token& stop);
    /// Step 9. Returns sentences about settings that the camera does not take back. Errors: those of the
    /// client; the camera then keeps the changed settings.
    std::vector<std::string> disconnect(const std::stop_token& stop);
    /// Step 9 after a stop or an error, for at most this time. Returns false if the camera may have kept the
    /// changed settings.
    bool disconnectWithin(std::chrono::milliseconds time);
    /// How many more photos the camera's storage and battery allow; nothing if the camera does not tell.
    std::optional<std::int64_t> photosLeft() const;

  private:
    std::vector<ShotOutcome> settleExposures(const std::stop_token& stop);

    /// What is known just before a trigger.
    struct Ready {
        std::chrono::milliseconds allowance{};
        survey::Baseline before;
    };

    Ready readyForShot(CaptureNotes& notes, const std::stop_token& stop);
    CameraInfo reach(CaptureNotes& notes, const std::stop_token& stop);
    void doubtExposure(Resolution& resolution, const std::stop_token& stop);
    std::vector<ShotOutcome> makeReady(CaptureNotes& notes, const std::stop_token& stop);
    std::chrono::milliseconds checkBeforeShot(CaptureNotes& notes, const std::stop_token& stop);
    survey::Baseline baseline(const std::stop_token& stop);
    std::optional<CommandReply> trigger(const std::stop_token& stop);
    bool mayTryAgain(OscErrorCode code, int refusals, const std::stop_token& stop);
    Foreseen foreseenAfterRestart(const survey::Shot& shot, const std::stop_token& stop);
    ShotOutcome follow(survey::Shot shot, const std::optional<CommandReply>& reply, const Foreseen& foreseen,
                       const std::stop_token& stop);
    std::string marked(std::string fileUrl, const std::stop_token& stop);
    void giveUpOlder(const survey::Shot& shot, const std::string& fileUrl);
    ShotOutcome resolve(survey::Shot shot, const Foreseen& foreseen, const std::stop_token& stop);

    OscClient& m_client;
    CaptureJournal& m_journal;
    Clock& m_clock;
    CaptureOptions m_options;
    SettingsGuard m_guard;
    ShotSettler m_settler;
    CameraWatch m_watch;
    std::optional<CameraInfo> m_camera;
    bool m_isPrepared = false;
    bool m_hasSettled = false; ///< Whether the shots of earlier runs were settled.
};

} // namespace spherewalk::camera
