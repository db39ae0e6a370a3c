// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/practice/fault.h"
#include "spherewalk/practice/photo_errors.h"
#include "spherewalk/practice/practice_room.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::practice {

/// A photo that the practice camera serves instead of drawing one.
struct PlacedPhoto {
    std::string file; ///< within the photo folder
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< for the truth file, where known
};

enum class CameraModel {
    ThetaV,   ///< API level 2 only
    ThetaS,   ///< begins with level 1, can be switched to 2, and falls back when it sleeps or restarts
    LevelOne, ///< a Theta S before it learned level 2
};

struct PracticeCameraOptions {
    CameraModel model = CameraModel::ThetaV;
    std::string host = "127.0.0.1";
    int port = 0;         ///< 0: any that is free
    double timeScale = 0; ///< of the camera's waits and transfer times: 1 as a Theta V, 0 none
    int width = 5376;     ///< of the photos; they are half as high
    int jpegQuality = 92;
    std::uint64_t seed = 1; ///< of ids, serial and scatter; the errors have their own
    PhotoErrors errors;
    bool isPlain = false;  ///< photos show stripes instead of the room, which is quicker by far
    bool levelled = false; ///< begin with the zenith correction on: no tilt in the pixels
    Eigen::Vector3d positionM = {2.0, 1.8, 1.2}; ///< where the cart stands at first
    PracticeRoomOptions room;

    std::filesystem::path storageFolder; ///< kept between runs; empty: a temporary one, removed at the end
    std::filesystem::path truthFile;     ///< empty: truth.jsonl in the storage folder

    std::filesystem::path photoFolder; ///< if given, these photos are served instead of the room's
    std::vector<PlacedPhoto> photos;

    /// How a real camera's doubtful points are answered.
    enum class WhenBusy { DisabledCommand, ServiceUnavailable, DeviceBusy };

    WhenBusy whenBusy = WhenBusy::DisabledCommand;
    std::string digestUser; ///< as in client mode: asks for HTTP digest authentication; empty: does not
    std::string digestPassword;
    int nonceRequests = 0; ///< a nonce is good for so many requests; 0: for ever

    int doneAnswers = 1; ///< so often a finished id answers; 0: for ever
    bool urlsOfAccessPoint =
        false;       ///< file URLs say 192.168.1.1 as the real camera's, not the request's host
    int threads = 0; ///< for drawing; 0: all that the machine has
    std::uint64_t storageBytes = 19'200'000'000ULL;

    /// Errors: InvalidInput with the option and its range.
    void validate() const;
};

/// What has been asked of the practice camera.
struct PracticeCameraStats {
    std::map<std::string, int> commands; ///< execute requests that arrived, by command, answered or not
    std::map<std::string, int> requests; ///< all requests, by method and path ("GET /osc/info", "GET /files")
    int exposures = 0;                   ///< photos that got into the storage
};

/// A Theta V over real HTTP that photographs the practice room, or serves a folder of photos by position. It
/// speaks the Open Spherical Camera API, level 2 (other models: 1, with sessions): /osc/info, /osc/state,
/// /osc/checkForUpdates, /osc/commands/execute and /status, the files, and the live preview, which shows the
/// next photo from where the cart stands and ends when a picture is taken. An exposure shows the room from
/// where the cart stood when takePicture arrived, off by the seeded errors; the truth is on the disk before
/// the file can be seen.
///
/// Besides, outside the camera's own API:
/// - POST /practice/pose {"x": .., "y": .., "z": ..} moves the cart (metres, room frame); GET tells.
/// - GET /practice/stats tells what has been asked (PracticeCameraStats).
/// - POST /practice/faults {"fault": "drop-before-executing", "on": "camera.takePicture", "skip": 0, "count":
///   1, "byte": 0, "amount": 0, "code": ""} arms a fault (see Fault), an array of such a script of them;
///   {"fault": "none"} disarms all.
///
/// Threads: all functions may be called from any. Stop: stop() ends a running exposure, unsaved.
class PracticeCamera {
  public:
    /// Errors: those of validate(), and of reading the storage and photo folders. clock must outlive the
    /// camera.
    explicit PracticeCamera(PracticeCameraOptions options, Clock& clock = systemClock());
    ~PracticeCamera();
    PracticeCamera(const PracticeCamera&) = delete;
    PracticeCamera& operator=(const PracticeCamera&) = delete;

    /// Listens; returns when requests are answered. At most once. Errors: Busy if the port is taken.
    void start();
    /// Returns when no request, exposure or thread is left; at once but for the encoding of a drawn photo.
    void stop();

    /// The port listened on, 0 before start().
    int port() const;
    /// "http://127.0.0.1:<port>".
    std::string url() const;

    void setPosition(const Eigen::Vector3d& positionM);
    void arm(const Fault& fault);
    /// What happens to the camera itself happens at once, not at a call.
    void befall(const Fault& fault);
    /// No armed fault is left, and the camera is as it was but for its files and settings.
    void disarm();
    PracticeCameraStats stats() const;
    std::filesystem::path truthFile() const;
    std::filesystem::path storageFolder() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::practice
