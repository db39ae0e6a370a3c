// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::camera {

// What a camera says is read tolerantly, because firmwares differ: unknown members and unusable optional
// members are ignored. Errors of all parse functions: Corrupt for a required member that is missing or
// unusable.

/// Who the camera is, from GET /osc/info.
struct CameraInfo {
    std::string manufacturer;
    std::string model;        ///< Required.
    std::string serialNumber; ///< Required.
    std::string firmwareVersion;
    std::vector<int> apiLevels{1};       ///< A camera that names no level speaks level 1.
    std::optional<std::int64_t> uptimeS; ///< Time since the camera was switched on.
    int httpPort = 0;                    ///< 0 if the camera names none.

    bool hasApiLevel(int level) const;
};

/// How the camera is, from POST /osc/state.
struct CameraState {
    std::string fingerprint;
    std::optional<double> batteryFraction; ///< Charge in [0, 1]; percent are converted.
    std::string batteryState;              ///< "charging", "charged", "disconnect" or "".
    std::string captureStatus;             ///< "idle", "shooting" and so on, or "".
    std::string latestFileUrl;             ///< "" if there is none.
    std::string storageUri;
    std::optional<int> apiVersion;
    std::string sessionId; ///< Of level 1: the session of whoever uses the camera; "" if nobody does.
    bool isPluginRunning = false;
    std::vector<std::string> errors; ///< Codes as _cameraError spells them.

    /// True unless the camera says that it is busy.
    bool isIdle() const;
};

/// What a camera answers to a command or to a question about one.
struct CommandReply {
    enum class State { Done, InProgress, Error };

    State state = State::Done;
    std::string id;                   ///< Name of the command; required while InProgress.
    std::optional<double> completion; ///< How far the command is, from 0 to 1.
    Json results = Json::object();
    OscErrorCode error = OscErrorCode::None;
    std::string errorMessage; ///< The camera's own words.
    bool isFromCamera = true; ///< False if only the HTTP status told of the error.
    int sent = 1;             ///< How often the request was sent until this answer came.

    /// The member fileUrl of the results, or fileUri of API level 1; "" without either.
    std::string fileUrl() const;
};

/// A file in a list of the camera.
struct FileEntry {
    std::string name;
    std::string fileUrl; ///< Required.
    std::optional<std::uint64_t> sizeBytes;
    std::string dateTime; ///< Time by the camera's clock.
    int width = 0;        ///< Pixels; 0 if the camera does not say it.
    int height = 0;
};

/// A page of a list of files, newest first.
struct FileList {
    std::vector<FileEntry> entries;
    std::int64_t totalEntries = 0; ///< Number of files on the camera; required.
};

CameraInfo parseCameraInfo(const Json& json);
CameraState parseCameraState(const Json& json);
CommandReply parseCommandReply(const Json& json);
FileList parseFileList(const Json& results);
/// Reads the results of camera.listImages of API level 1.
FileList parseImageList(const Json& results);
/// The path for a file's name of API level 1, which has neither host nor leading slash. Any other text is
/// returned as it is.
std::string urlOfName(std::string name);

/// A whole number that may be spelled as an integer or as a float without a fraction.
std::optional<std::int64_t> wholeNumber(const Json& json, std::string_view key);
/// A finite number.
std::optional<double> finiteNumber(const Json& json, std::string_view key);
/// A text of at most 2048 characters without control characters.
std::optional<std::string> shortText(const Json& json, std::string_view key);

/// An error of the camera in words.
struct CameraTrouble {
    std::string sentence; ///< What is wrong, and what to do.
    bool blocks = false;  ///< Whether the camera can take no pictures.
};

/// Puts a code of _cameraError into words.
CameraTrouble describeCameraError(std::string_view code);

} // namespace spherewalk::camera
