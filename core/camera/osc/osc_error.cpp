// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/osc_error.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>

namespace spherewalk::camera {

namespace {

struct Meaning {
    OscErrorCode code;
    std::string_view spelled;
    ErrorKind kind;
    int repeats;
    bool provesNothingDone;
    std::string_view advice;
};

using enum OscErrorCode;

constexpr std::string_view kReport = "update the camera's firmware; if it stays so, report it";
constexpr std::string_view kRetry = "wait a moment and try again";

constexpr std::array kMeanings{
    Meaning{UnknownCommand, "unknownCommand", ErrorKind::Unsupported, 0, true,
            "this camera cannot do it; update its firmware or use another camera"},
    Meaning{DisabledCommand, "disabledCommand", ErrorKind::Busy, 0, true,
            "set the camera to still pictures, end its plug-in or preview, close the telephone's "
            "application, and try again"},
    Meaning{MissingParameter, "missingParameter", ErrorKind::Unsupported, 0, true, kReport},
    Meaning{InvalidParameterName, "invalidParameterName", ErrorKind::Unsupported, 0, true, kReport},
    Meaning{InvalidParameterValue, "invalidParameterValue", ErrorKind::InvalidInput, 0, true,
            "the camera does not allow this value in its present mode"},
    Meaning{TooManyParameters, "tooManyParameters", ErrorKind::Unsupported, 0, true, kReport},
    Meaning{CorruptedFile, "corruptedFile", ErrorKind::Corrupt, 0, false,
            "the file is damaged on the camera; take the photo again"},
    Meaning{PowerOff, "powerOffSequenceRunning", ErrorKind::Network, 0, true,
            "the camera is switching off; switch it on and resume"},
    Meaning{InvalidFileFormat, "invalidFileFormat", ErrorKind::Unsupported, 0, true, kReport},
    Meaning{ServiceUnavailable, "serviceUnavailable", ErrorKind::Busy, 3, true, kRetry},
    Meaning{DeviceBusy, "deviceBusy", ErrorKind::Busy, 3, true, kRetry},
    Meaning{Unexpected, "unexpected", ErrorKind::Network, 1, false,
            "switch the camera off and on, then resume"},
    Meaning{Canceled, "canceledShooting", ErrorKind::Busy, 0, true,
            "the shot was cancelled at the camera; take it again"},
    Meaning{NotFound, "notFound", ErrorKind::NotFound, 0, false,
            "check that nobody has deleted the file from the camera"},
    Meaning{InvalidSession, "invalidSessionId", ErrorKind::Unsupported, 0, true,
            "the camera has ended the session; switch it off and on, and close the telephone's application"},
    Meaning{ExclusiveUse, "cameraInExclusiveUse", ErrorKind::Busy, 0, true,
            "close the other program or telephone that uses the camera; if none does, wait three minutes"},
    Meaning{StorageFull, "noFreeSpace", ErrorKind::Full, 0, true,
            "the camera's storage is full; back its photos up and free some space"},
    Meaning{
        Unauthorized, "unauthorized", ErrorKind::Unsupported, 0, true,
        "it asks for a user name and a password (client mode), and was given none or wrong ones; give the "
        "right ones, or use the camera's own WiFi"},
    Meaning{Other, "", ErrorKind::Unsupported, 1, false, kReport},
};

const Meaning& meaning(OscErrorCode code) {
    const auto* found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                     [code](const Meaning& candidate) { return candidate.code == code; });
    return found == kMeanings.end() ? kMeanings.back() : *found;
}

} // namespace

OscErrorCode oscErrorCode(std::string_view spelled) {
    const auto* found = std::find_if(kMeanings.begin(), kMeanings.end(), [spelled](const Meaning& candidate) {
        return candidate.spelled == spelled;
    });
    return found == kMeanings.end() ? Other : found->code;
}

OscErrorCode oscErrorCodeOfStatus(int httpStatus) {
    switch (httpStatus) {
    case 401:
        return Unauthorized;
    case 404:
        return NotFound;
    case 503:
        return ServiceUnavailable;
    default:
        return httpStatus < 400 ? None : Other;
    }
}

ErrorKind kindOf(OscErrorCode code) {
    return meaning(code).kind;
}

std::string_view advice(OscErrorCode code) {
    return meaning(code).advice;
}

int worthwhileRepeats(OscErrorCode code) {
    return code == None ? 0 : meaning(code).repeats;
}

bool provesNothingDone(OscErrorCode code) {
    return code != None && meaning(code).provesNothingDone;
}

bool isOfOtherLevel(OscErrorCode code) {
    return code == OscErrorCode::InvalidSession || code == OscErrorCode::MissingParameter ||
           code == OscErrorCode::UnknownCommand;
}

bool isCameraTrouble(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::Network:
    case ErrorKind::Timeout:
    case ErrorKind::Corrupt:
    case ErrorKind::Unsupported:
    case ErrorKind::NotFound:
    case ErrorKind::Busy:
        return true;
    default:
        return false;
    }
}

Error refusal(std::string_view tried, OscErrorCode code, std::string_view detail) {
    const std::string quoted = detail.empty() ? std::string() : text(" (\"", printable(detail), "\")");
    return {kindOf(code), text("The camera refused to ", tried, quoted, ": ", advice(code), "."),
            std::string(meaning(code).spelled)};
}

Error notACamera(std::string_view address, std::string_view what) {
    return {ErrorKind::Unsupported,
            text("What answers at http://", address, " is not a spherical camera (", what,
                 "); check that this computer is on the camera's WiFi and not also on another network with "
                 "the same addresses, and check the address.")};
}

} // namespace spherewalk::camera
