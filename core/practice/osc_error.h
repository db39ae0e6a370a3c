// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"

#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// The refusals of the Open Spherical Camera API, and those that Ricoh's cameras add.
enum class OscCode {
    UnknownCommand,
    DisabledCommand,
    MissingParameter,
    InvalidParameterName,
    InvalidParameterValue,
    TooManyParameters,
    CorruptedFile,
    PowerOffSequenceRunning,
    InvalidFileFormat,
    ServiceUnavailable,
    CanceledShooting,
    CanceledConversion,
    Unexpected,
    NotFound,
    InvalidSessionId,
    CameraInExclusiveUse,
    DeviceBusy,
    NoFreeSpace,
    ServerError,
};

/// The code that is spelled so ("deviceBusy"); nothing if there is none.
std::optional<OscCode> oscCode(std::string_view spelled);

/// Thrown within the camera, answered as JSON at its edge.
class OscError {
  public:
    explicit OscError(OscCode code) : m_code(code) {}

    OscCode code() const { return m_code; }

  private:
    OscCode m_code;
};

/// An HTTP status and a JSON body.
struct OscReply {
    int status = 200;
    Json body;
};

/// results: null for a command that has none.
OscReply done(std::string_view command, Json results = {});
/// command: its name, "unknown" where there is none.
OscReply refusal(std::string_view command, OscCode code);

} // namespace spherewalk::practice
