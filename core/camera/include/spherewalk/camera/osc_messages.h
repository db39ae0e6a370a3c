// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// What a camera says, read tolerantly: unknown members and unusable optional ones are ignored, as firmwares
/// differ. Errors of all parse functions: Corrupt, for a required member that is missing or unusable.

/// Who the camera is, from GET /osc/info.
struct CameraInfo {
    std::string manufacturer;
    std::string model;        ///< required
    std::string serialNumber; ///< required
    std::string firmwareVersion;
    std::vector<int> apiLevels{1}; ///< 1 is what a camera that names none speaks
    std::optional<std::int64_t> uptimeS;
    int httpPort = 0; ///< 0 if not named

    bool hasApiLevel(int level) const;
};

/// How the camera is, from POST /osc/state.
struct CameraState {
    std::string fingerprint;
    std::optional<double> batteryFraction; ///< in [0, 1]; cameras that say percent are converted
    std::string batteryState;              ///< "charging", "charged", "disconnect", or ""
    std::string captureStatus;             ///< "idle", "shooting", ..., or ""
    std::string latestFileUrl;             ///< "" if there is none
    std::string storageUri;
    std::optional<int> apiVersion;
    bool isPluginRunning = false;
    std::vector<std::string> errors; ///< as spelled in _cameraError

    /// True unless the camera says that it is busy.
    bool isIdle() const;
};

/// What a camera answers to a command or to a question about one.
struct CommandReply {
    enum class State { Done, InProgress, Error };

    State state = State::Done;
    std::string id; ///< required while InProgress; opaque
    std::optional<double> completion;
    Json results = Json::object();
    OscErrorCode error = OscErrorCode::None;
    std::string errorMessage; ///< the camera's own words
    bool isFromCamera = true; ///< false if only an HTTP status told of the error

    /// results.fileUrl, or fileUri of API level 1, or "".
    std::string fileUrl() const;
};

struct FileEntry {
    std::string name;
    std::string fileUrl; ///< required
    std::optional<std::uint64_t> sizeBytes;
    std::string dateTime; ///< as the camera's clock had it
    int width = 0;        ///< 0 if not said
    int height = 0;
};

struct FileList {
    std::vector<FileEntry> entries;
    std::int64_t totalEntries = 0; ///< on the camera; required
};

CameraInfo parseCameraInfo(const Json& json);
CameraState parseCameraState(const Json& json);
CommandReply parseCommandReply(const Json& json);
FileList parseFileList(const Json& results);
/// The same of camera.listImages of API level 1.
FileList parseImageList(const Json& results);
/// The path that stands for a file's name of API level 1, which has neither host nor leading slash; anything
/// else as it is.
std::string urlOfName(std::string name);

/// A whole number that may be spelled as an integer or as a float without a fraction.
std::optional<std::int64_t> wholeNumber(const Json& json, std::string_view key);
/// A finite number.
std::optional<double> finiteNumber(const Json& json, std::string_view key);
/// A text of at most 2048 characters without control characters.
std::optional<std::string> shortText(const Json& json, std::string_view key);

/// Tells a camera's error in words: "its storage is full". blocks: whether it can still take pictures.
struct CameraTrouble {
    std::string sentence;
    bool blocks = false;
};

CameraTrouble describeCameraError(std::string_view code);

} // namespace spherewalk::camera
