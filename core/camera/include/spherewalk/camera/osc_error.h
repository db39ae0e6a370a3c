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
    Other, ///< a code that is in no table of ours
};

/// The meaning of a code as the camera spells it; Other for an unknown one.
OscErrorCode oscErrorCode(std::string_view spelled);
/// The meaning of an answer that has no JSON: None below 400.
OscErrorCode oscErrorCodeOfStatus(int httpStatus);

ErrorKind kindOf(OscErrorCode code);
/// What the operator should do, as a sentence without a full stop.
std::string_view advice(OscErrorCode code);
/// How often a repeatable command that was refused so is worth sending again.
int worthwhileRepeats(OscErrorCode code);
/// True if a camera that refuses takePicture so has certainly not taken a picture.
bool provesNothingDone(OscErrorCode code);

/// What a camera answers to a command of another API level, or of a session that has ended.
bool isOfOtherLevel(OscErrorCode code);
/// True for errors that come from the camera or the way to it, not from this computer or a stop.
bool isCameraTrouble(ErrorKind kind);

/// The error for a refused command, with the advice. detail: the camera's own words, or empty.
Error refusal(std::string_view tried, OscErrorCode code, std::string_view detail);
/// The error for a host that answers, but not as a spherical camera does. what: "it sent a web page".
Error notACamera(std::string_view address, std::string_view what);

} // namespace spherewalk::camera
