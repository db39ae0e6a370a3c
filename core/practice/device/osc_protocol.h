// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol of the Open Spherical Camera API, as far as it is the same for all commands: codes, replies,
// parameters and the session of level 1.
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/base/json.h"

#include <cstdint>
#include <initializer_list>
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

/// The code with this spelling ("deviceBusy"). Returns nothing if there is none.
std::optional<OscCode> oscCode(std::string_view spelled);

/// A refusal within the camera, which its edge answers as JSON.
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

/// The reply to a command that is done. results: null if the command has none.
OscReply done(std::string_view command, Json results = {});
/// The reply to a refused command. command: its name, or "unknown".
OscReply refusal(std::string_view command, OscCode code);

// Parameters of commands. Errors: OscError for a missing or wrong parameter.

/// The parameter of this name.
const Json& required(const Json& parameters, const char* name);
/// The whole number, with or without a fraction of zero. Range: [least, most].
std::int64_t wholeNumber(const Json& value, std::int64_t least, std::int64_t most);
/// One of the known words.
std::string word(const Json& value, std::initializer_list<std::string_view> known);
/// True or false. Returns the fallback if the parameter is missing.
bool flag(const Json& parameters, const char* name, bool fallback);

/// The one session of API level 1, which most commands need. Threads: one at a time.
class OscSession {
  public:
    /// timeScale: factor on the 180 s after which an unused session ends; 0: it never ends.
    OscSession(Clock& clock, double timeScale) : m_clock(clock), m_timeScale(timeScale) {}

    /// Starts a session and returns its name, "SID_0001". Errors: OscError while another is in use.
    std::string start();

    void end() { m_id.reset(); }

    /// Uses the session that the parameters name. Errors: OscError for no session, and for one that ended.
    void use(const Json& parameters);

    std::string id() const { return m_id.value_or(""); }

    static constexpr double kTimeoutS = 180;

  private:
    bool isOver() const;

    Clock& m_clock;
    double m_timeScale;
    int m_count = 0;
    std::optional<std::string> m_id;
    Clock::TimePoint m_usedAt;
};

} // namespace spherewalk::practice
