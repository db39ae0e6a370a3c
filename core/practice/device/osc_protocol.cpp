// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/osc_protocol.h"

#include "spherewalk/base/json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spherewalk::practice {

namespace {

struct Spelling {
    OscCode code;
    int status;
    std::string_view spelled;
    std::string_view message;
};

using enum OscCode;

constexpr std::array kSpellings{
    Spelling{UnknownCommand, 400, "unknownCommand", "Command executed is unknown."},
    Spelling{DisabledCommand, 403, "disabledCommand", "Command executed is currently disabled."},
    Spelling{MissingParameter, 400, "missingParameter", "Any required parameter is not specified."},
    Spelling{InvalidParameterName, 400, "invalidParameterName",
             "Any input parameter or option name is unrecognized or supported."},
    Spelling{InvalidParameterValue, 400, "invalidParameterValue",
             "Any input parameter or option (name) is recognized, but its value is invalid."},
    Spelling{TooManyParameters, 403, "tooManyParameters", "Too many parameters are set."},
    Spelling{CorruptedFile, 403, "corruptedFile", "The file is corrupt."},
    Spelling{PowerOffSequenceRunning, 403, "powerOffSequenceRunning", "Power off sequence running."},
    Spelling{InvalidFileFormat, 403, "invalidFileFormat", "File format is invalid."},
    Spelling{ServiceUnavailable, 503, "serviceUnavailable", "Service Unavailable."},
    Spelling{CanceledShooting, 403, "canceledShooting", "shooting is canceled."},
    Spelling{CanceledConversion, 403, "canceledConversion", "conversion is canceled."},
    Spelling{Unexpected, 503, "unexpected", "unexpected error occurred."},
    Spelling{NotFound, 404, "notFound", "Not found."},
    Spelling{InvalidSessionId, 403, "invalidSessionId", "The sessionId is invalid."},
    Spelling{CameraInExclusiveUse, 400, "cameraInExclusiveUse", "The camera is in exclusive use."},
    Spelling{DeviceBusy, 503, "deviceBusy", "Device Busy."},
    Spelling{NoFreeSpace, 403, "noFreeSpace", "Free space unavailable."},
    Spelling{ServerError, 500, "serverError", "Server error."}, // other vendors'
};

const Spelling& spelling(OscCode code) {
    return *std::find_if(kSpellings.begin(), kSpellings.end(),
                         [code](const Spelling& one) { return one.code == code; });
}

} // namespace

std::optional<OscCode> oscCode(std::string_view spelled) {
    const auto* const found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                           [&](const Spelling& one) { return one.spelled == spelled; });
    return found == kSpellings.end() ? std::nullopt : std::optional(found->code);
}

OscReply done(std::string_view command, Json results) {
    Json body;
    body["name"] = command;
    body["state"] = "done";
    if (!results.is_null()) {
        body["results"] = std::move(results);
    }
    return {200, body};
}

OscReply refusal(std::string_view command, OscCode code) {
    const Spelling& spelled = spelling(code);
    Json body;
    body["name"] = command;
    body["state"] = "error";
    body["error"] = {{"code", spelled.spelled}, {"message", spelled.message}};
    return {spelled.status, body};
}

const Json& required(const Json& parameters, const char* name) {
    if (!parameters.contains(name)) {
        throw OscError(OscCode::MissingParameter);
    }
    return parameters[name];
}

std::int64_t wholeNumber(const Json& value, std::int64_t least, std::int64_t most) {
    const bool isWhole = value.is_number_integer() ||
                         (value.is_number() && value.get<double>() == std::floor(value.get<double>()) &&
                          std::abs(value.get<double>()) < 1e15);
    const std::int64_t number = isWhole ? value.get<std::int64_t>() : least - 1;
    if (number < least || number > most) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return number;
}

std::string word(const Json& value, std::initializer_list<std::string_view> known) {
    std::string spelled = value.is_string() ? value.get<std::string>() : std::string();
    if (std::find(known.begin(), known.end(), spelled) == known.end()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return spelled;
}

bool flag(const Json& parameters, const char* name, bool fallback) {
    if (!parameters.contains(name)) {
        return fallback;
    }
    if (!parameters[name].is_boolean()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return parameters[name].get<bool>();
}

bool OscSession::isOver() const {
    const std::chrono::duration<double> unused = m_clock.now() - m_usedAt;
    return !m_id || (m_timeScale > 0 && unused.count() > kTimeoutS * m_timeScale);
}

std::string OscSession::start() {
    if (!isOver()) {
        throw OscError(OscCode::CameraInExclusiveUse);
    }
    std::string digits = std::to_string(++m_count);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    m_id = "SID_" + digits;
    m_usedAt = m_clock.now();
    return *m_id;
}

void OscSession::use(const Json& parameters) {
    const Json& given = required(parameters, "sessionId");
    if (isOver() || given != *m_id) {
        throw OscError(OscCode::InvalidSessionId);
    }
    m_usedAt = m_clock.now();
}

} // namespace spherewalk::practice
