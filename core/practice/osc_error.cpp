// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_error.h"

#include <utility>

namespace spherewalk::practice {

namespace {

struct Spelling {
    int status;
    std::string_view code;
    std::string_view message;
};

Spelling spelling(OscCode code) {
    switch (code) {
    case OscCode::UnknownCommand:
        return {400, "unknownCommand", "Command executed is unknown."};
    case OscCode::DisabledCommand:
        return {403, "disabledCommand", "Command executed is currently disabled."};
    case OscCode::MissingParameter:
        return {400, "missingParameter", "Any required parameter is not specified."};
    case OscCode::InvalidParameterName:
        return {400, "invalidParameterName",
                "Any input parameter or option name is unrecognized or supported."};
    case OscCode::InvalidParameterValue:
        return {400, "invalidParameterValue",
                "Any input parameter or option (name) is recognized, but its value is invalid."};
    case OscCode::TooManyParameters:
        return {403, "tooManyParameters", "Too many parameters are set."};
    case OscCode::ServiceUnavailable:
        return {503, "serviceUnavailable", "Service Unavailable."};
    case OscCode::CanceledShooting:
        return {403, "canceledShooting", "shooting is canceled."};
    case OscCode::Unexpected:
        return {503, "unexpected", "unexpected error occurred."};
    case OscCode::NotFound:
        return {404, "notFound", "Not found."};
    case OscCode::DeviceBusy:
        return {503, "deviceBusy", "Device Busy."};
    }
    return {503, "unexpected", "unexpected error occurred."};
}

} // namespace

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
    const Spelling spelled = spelling(code);
    Json body;
    body["name"] = command;
    body["state"] = "error";
    body["error"] = {{"code", spelled.code}, {"message", spelled.message}};
    return {spelled.status, body};
}

} // namespace spherewalk::practice
