// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/practice/fault.h"
#include "spherewalk/practice/practice_options.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace spherewalk::practice {

/// Counts of the requests to the practice camera.
struct PracticeCameraStats {
    std::map<std::string, int> commands; ///< Arrived execute requests by command, answered or not.
    std::map<std::string, int> requests; ///< All requests by method and path ("GET /osc/info", "GET /files").
    int exposures = 0;                   ///< Photos that reached the storage.
};

/// A Theta V over real HTTP that photographs the practice room, or serves a folder of photos by position.
///
/// It speaks the Open Spherical Camera API: /osc/info, /osc/state, /osc/checkForUpdates,
/// /osc/commands/execute, /osc/commands/status, the files and the live preview. A Theta V has level 2; the
/// other models have level 1 with sessions. The preview shows the next photo from the cart's place, and ends
/// when a picture is taken. An exposure shows the room from the cart's place when takePicture arrived, plus
/// the seeded errors. The truth is on the disk before a client can see the file.
///
/// Four paths are outside the camera's own API:
/// - POST /practice/pose {"x": .., "y": .., "z": ..} moves the cart (metres, room frame); GET tells its
/// place.
/// - POST /practice/walk carries it to the next place of a walk through the room, or of the given photos,
/// and answers {"moved": false} at the end.
/// - GET /practice/stats tells the PracticeCameraStats.
/// - POST /practice/faults {"fault": "drop-before-executing", "on": "camera.takePicture", "skip": 0, "count":
///   1, "byte": 0, "amount": 0, "code": ""} arms a fault (see Fault). An array of such objects arms a script
///   of faults; {"fault": "none"} disarms all.
///
/// Threads: all functions may be called from any. Stop: stop() ends a running exposure without saving it.
class PracticeCamera {
  public:
    /// Errors: those of validate(); Io, Corrupt and NotFound for the storage and photo folders. Owner: clock
    /// must outlive the camera.
    explicit PracticeCamera(PracticeCameraOptions options, Clock& clock = systemClock());
    ~PracticeCamera();
    PracticeCamera(const PracticeCamera&) = delete;
    PracticeCamera& operator=(const PracticeCamera&) = delete;

    /// Listens; requests are answered from here on. Call it at most once. Errors: Busy if the port is taken.
    void start();
    /// Returns when no request, exposure or thread is left, which may take the encoding of one photo.
    void stop();

    /// The port; 0 before start().
    int port() const;
    /// "http://127.0.0.1:<port>".
    std::string url() const;

    /// Moves the cart. Frames: room. Errors: InvalidInput for a position that is not finite.
    void setPosition(const Eigen::Vector3d& positionM);
    /// Adds a fault to those that wait for their calls. Errors: those of Fault::validate().
    void arm(const Fault& fault);
    /// Makes a trouble of the camera itself happen at once. Errors: InvalidInput for troubles of requests.
    void befall(const Fault& fault);
    /// Removes all armed faults, and ends the camera's own troubles. Files and settings stay.
    void disarm();
    PracticeCameraStats stats() const;
    std::filesystem::path truthFile() const;
    std::filesystem::path storageFolder() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::practice
