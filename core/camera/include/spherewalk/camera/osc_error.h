// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"

#include <string>
#include <string_view>

namespace spherewalk::camera {

/// Why a camera refuses a command. Source: Open Spherical Camera API and Ricoh's extensions.
enum class OscErrorCode {
    None,
    UnknownCommand,
    DisabledCommand,
    MissingParameter,
    InvalidParameterName,
    InvalidParameterValue,
    TooManyParameters,
    CorruptedFile,
    PowerOff,
    InvalidFileFormat,
    ServiceUnavailable,
    DeviceBusy,
    Unexpected,
    Canceled,
    NotFound,
    InvalidSession,
    ExclusiveUse,
    StorageFull,
    Unauthorized,
    Other, ///< Any code that is not listed here.
};

/// The meaning of a code as the camera spells it; Other for an unknown one.
OscErrorCode oscErrorCode(std::string_view spelled);
/// The meaning of the HTTP status of an answer without JSON; None below 400.
OscErrorCode oscErrorCodeOfStatus(int httpStatus);

/// The kind of error that a refusal becomes.
ErrorKind kindOf(OscErrorCode code);
/// What the operator should do, as a sentence without a full stop.
std::string_view advice(OscErrorCode code);
/// How often to send a repeatable command again after such a refusal.
int worthwhileRepeats(OscErrorCode code);
/// Whether such a refusal of takePicture proves that the camera has taken no picture.
bool provesNothingDone(OscErrorCode code);

/// Whether the code answers a command of another API level, or of a session that has ended.
bool isOfOtherLevel(OscErrorCode code);
/// Whether an error of this kind comes from the camera or the network, not from this computer or a stop.
bool isCameraTrouble(ErrorKind kind);

/// The error for a refused command, with the advice. detail: the camera's own words, or empty.
Error refusal(std::string_view tried, OscErrorCode code, std::string_view detail);
/// The error for a host that answers, but not as a spherical camera does. what: "it sent a web page".
Error notACamera(std::string_view address, std::string_view what);

} // namespace spherewalk::camera
