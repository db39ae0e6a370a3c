// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/osc_messages.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::camera {

namespace {

constexpr std::size_t kMaxTextLength = 2048;
constexpr std::size_t kMaxListLength = 100'000; // the answer's size bounds it more tightly
constexpr double kExactIntegers = 9'007'199'254'740'992.0;

const Json* find(const Json& json, std::string_view key) {
    if (!json.is_object()) {
        return nullptr;
    }
    const auto found = json.find(std::string(key));
    return found == json.end() ? nullptr : &*found;
}

std::string textOr(const Json& json, std::string_view key, std::string fallback = {}) {
    return shortText(json, key).value_or(std::move(fallback));
}

std::string requiredText(const Json& json, std::string_view key, std::string_view source) {
    std::string value = textOr(json, key);
    if (value.empty()) {
        JsonReader(json, std::string(source)).fail(text("the text \"", key, "\" is missing or unusable"));
    }
    return value;
}

/// Identifiers that some cameras spell as a text and others as a number.
std::string identifier(const Json& json, std::string_view key) {
    if (const auto number = wholeNumber(json, key)) {
        return text(*number);
    }
    return textOr(json, key);
}

int pixels(const Json& json, std::string_view key) {
    const auto number = wholeNumber(json, key);
    return number && *number > 0 && *number <= 1'000'000 ? static_cast<int>(*number) : 0;
}

std::vector<int> parseApiLevels(const Json& json) {
    const Json* list = find(json, "apiLevel");
    std::vector<int> levels;
    if (list != nullptr && list->is_array()) {
        for (const Json& level : *list) {
            if (level.is_number() && level.get<double>() >= 1 && level.get<double>() < 100) {
                levels.push_back(static_cast<int>(level.get<double>()));
            }
        }
    }
    return levels.empty() ? std::vector{1} : levels;
}

std::optional<double> batteryFraction(const Json& state) {
    const auto level = finiteNumber(state, "batteryLevel");
    if (!level || *level < 0 || *level > 100) {
        return std::nullopt;
    }
    return *level > 1 ? *level / 100 : *level;
}

FileEntry parseFileEntry(const Json& json, const char* key) {
    FileEntry entry;
    entry.fileUrl = requiredText(json, key, "The camera's list of files");
    entry.name = textOr(json, "name");
    if (const auto size = wholeNumber(json, "size"); size && *size >= 0) {
        entry.sizeBytes = static_cast<std::uint64_t>(*size);
    }
    entry.dateTime = textOr(json, "dateTimeZone", textOr(json, "dateTime"));
    entry.width = pixels(json, "width");
    entry.height = pixels(json, "height");
    return entry;
}

FileList parseEntries(const Json& results, const char* key) {
    const JsonReader reader(results, "The camera's list of files");
    FileList list;
    const auto total = wholeNumber(results, "totalEntries");
    if (!total || *total < 0) {
        reader.fail("the number \"totalEntries\" is missing or unusable");
    }
    list.totalEntries = *total;
    const JsonReader entries = reader.member("entries");
    const std::size_t count = entries.arraySize(kMaxListLength);
    for (std::size_t i = 0; i < count; ++i) {
        list.entries.push_back(parseFileEntry(entries.element(i).value(), key));
    }
    return list;
}

} // namespace

std::optional<std::int64_t> wholeNumber(const Json& json, std::string_view key) {
    const Json* value = find(json, key);
    if (value == nullptr || !value->is_number()) {
        return std::nullopt;
    }
    if (value->is_number_unsigned()) {
        const auto number = value->get<std::uint64_t>();
        return number <= INT64_MAX ? std::optional(static_cast<std::int64_t>(number)) : std::nullopt;
    }
    if (value->is_number_integer()) {
        return value->get<std::int64_t>();
    }
    const auto number = value->get<double>();
    const bool isWhole = std::abs(number) <= kExactIntegers && std::floor(number) == number;
    return isWhole ? std::optional(static_cast<std::int64_t>(number)) : std::nullopt;
}

std::optional<double> finiteNumber(const Json& json, std::string_view key) {
    const Json* value = find(json, key);
    if (value == nullptr || !value->is_number() || !std::isfinite(value->get<double>())) {
        return std::nullopt;
    }
    return value->get<double>();
}

std::optional<std::string> shortText(const Json& json, std::string_view key) {
    const Json* value = find(json, key);
    if (value == nullptr || !value->is_string()) {
        return std::nullopt;
    }
    std::string content = value->get<std::string>();
    if (content.size() > kMaxTextLength || printable(content, content.size()) != content) {
        return std::nullopt;
    }
    return content;
}

bool CameraInfo::hasApiLevel(int level) const {
    return std::find(apiLevels.begin(), apiLevels.end(), level) != apiLevels.end();
}

bool CameraState::isIdle() const {
    return captureStatus.empty() || captureStatus == "idle";
}

std::string CommandReply::fileUrl() const {
    return textOr(results, "fileUrl", urlOfName(textOr(results, "fileUri")));
}

CameraInfo parseCameraInfo(const Json& json) {
    constexpr std::string_view kSource = "The camera's description of itself";
    CameraInfo info;
    info.model = requiredText(json, "model", kSource);
    info.serialNumber = identifier(json, "serialNumber");
    if (info.serialNumber.empty()) {
        JsonReader(json, std::string(kSource)).fail("the serial number is missing or unusable");
    }
    info.manufacturer = textOr(json, "manufacturer");
    info.firmwareVersion = textOr(json, "firmwareVersion");
    info.apiLevels = parseApiLevels(json);
    info.uptimeS = wholeNumber(json, "uptime");
    if (const Json* endpoints = find(json, "endpoints")) {
        const auto port = wholeNumber(*endpoints, "httpPort");
        info.httpPort = port && *port >= 1 && *port <= 65535 ? static_cast<int>(*port) : 0;
    }
    return info;
}

CameraState parseCameraState(const Json& json) {
    const Json* state = find(json, "state");
    if (state == nullptr || !state->is_object()) {
        JsonReader(json, "The camera's state").fail("the member \"state\" is missing");
    }
    CameraState result;
    result.fingerprint = textOr(json, "fingerprint");
    result.batteryFraction = batteryFraction(*state);
    result.batteryState = textOr(*state, "_batteryState");
    result.captureStatus = textOr(*state, "_captureStatus");
    result.latestFileUrl = textOr(*state, "_latestFileUrl", urlOfName(textOr(*state, "_latestFileUri")));
    result.storageUri = textOr(*state, "storageUri");
    if (const auto version = wholeNumber(*state, "_apiVersion"); version && *version >= 1 && *version < 100) {
        result.apiVersion = static_cast<int>(*version);
    }
    result.sessionId = textOr(*state, "sessionId");
    const Json* plugin = find(*state, "_pluginRunning");
    result.isPluginRunning = plugin != nullptr && plugin->is_boolean() && plugin->get<bool>();
    if (const Json* errors = find(*state, "_cameraError"); errors != nullptr && errors->is_array()) {
        for (const Json& error : *errors) {
            if (error.is_string() && result.errors.size() < 32) {
                result.errors.push_back(printable(error.get<std::string>()));
            }
        }
    }
    return result;
}

CommandReply parseCommandReply(const Json& json) {
    constexpr std::string_view kSource = "The camera's answer to a command";
    CommandReply reply;
    if (const Json* error = find(json, "error"); error != nullptr && error->is_object()) {
        reply.state = CommandReply::State::Error;
        reply.error = oscErrorCode(textOr(*error, "code"));
        reply.errorMessage = textOr(*error, "message", textOr(*error, "code"));
        return reply;
    }
    const std::string state = requiredText(json, "state", kSource);
    reply.id = identifier(json, "id");
    if (state == "done") {
        reply.state = CommandReply::State::Done;
    } else if (state == "inProgress") {
        reply.state = CommandReply::State::InProgress;
        if (reply.id.empty() || reply.id.size() > 256) {
            JsonReader(json, std::string(kSource)).fail("the id of the running command is missing");
        }
    } else if (state == "error") {
        reply.state = CommandReply::State::Error;
        reply.error = OscErrorCode::Other;
    } else {
        JsonReader(json, std::string(kSource)).fail(text("unknown state \"", printable(state), "\""));
    }
    if (const Json* progress = find(json, "progress")) {
        reply.completion = finiteNumber(*progress, "completion");
    }
    if (const Json* results = find(json, "results"); results != nullptr && results->is_object()) {
        reply.results = *results;
    }
    return reply;
}

std::string urlOfName(std::string name) {
    const bool isName = !name.empty() && name.front() != '/' && name.find("://") == std::string::npos;
    return isName ? "/" + std::move(name) : name;
}

FileList parseFileList(const Json& results) {
    return parseEntries(results, "fileUrl");
}

FileList parseImageList(const Json& results) {
    FileList list = parseEntries(results, "uri");
    for (FileEntry& entry : list.entries) {
        entry.fileUrl = urlOfName(std::move(entry.fileUrl));
    }
    return list;
}

CameraTrouble describeCameraError(std::string_view code) {
    struct Known {
        std::string_view code;
        std::string_view sentence;
        bool blocks;
    };

    static constexpr std::array kKnown{
        Known{"NO_MEMORY", "The camera's storage is full; back its photos up and free some space.", true},
        Known{"FILE_NUMBER_OVER", "The camera has used up its file numbers; back its photos up and reset it.",
              true},
        Known{"NO_DATE_SETTING", "The camera's clock is not set; its photos will carry a wrong time.", false},
        Known{"ELECTRONIC_COMPASS_CALIBRATION", "The camera's compass asks to be calibrated.", false},
        Known{"COMPASS_CALIBRATION", "The camera's compass asks to be calibrated.", false},
        Known{"CAPTURE_HW_FAILED", "The camera's sensor has failed; switch it off and on.", true},
        Known{"INTERNAL_MEM_ACCESS_FAIL", "The camera cannot reach its storage; switch it off and on.", true},
        Known{"UNEXPECTED_ERROR", "The camera reports an unexpected error; switch it off and on.", true},
        Known{"BATTERY_CHARGE_FAIL", "The camera cannot charge and will switch off; change the charger.",
              true},
        Known{"HIGH_TEMPERATURE", "The camera is too hot and will switch off; let it cool down.", true},
        Known{"HIGH_TEMPERATURE_WARNING", "The camera is getting hot; leave more time between photos.",
              false},
        Known{"BATTERY_HIGH_TEMPERATURE",
              "The camera's battery is getting hot; leave more time between "
              "photos.",
              false},
    };
    for (const Known& known : kKnown) {
        if (known.code == code) {
            return {std::string(known.sentence), known.blocks};
        }
    }
    return {text("The camera reports \"", printable(code), "\"; look at its display."), false};
}

} // namespace spherewalk::camera
