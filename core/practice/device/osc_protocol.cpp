// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_error.h"

#include <algorithm>
#include <array>
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

} // namespace spherewalk::practice
