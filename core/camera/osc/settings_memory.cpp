// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc/camera_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_messages.h"
#include "spherewalk/camera/settings_guard.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>

namespace spherewalk::camera {

namespace {

/// Whether a file that anybody may have changed may say this of a setting.
bool canBeKept(const std::string& name, const Json& value) {
    constexpr std::int64_t kLongestS = 604'800;
    if (std::ranges::find(kDelayNames, name) != kDelayNames.end()) {
        return value.is_number_integer() && value >= 0 && value <= kLongestS;
    }
    if (name == "fileFormat") {
        return shortText(value, "type").has_value();
    }
    const std::vector<std::string>& names = profileOptionNames();
    return (name == "captureMode" || std::ranges::find(names, name) != names.end()) &&
           (value.is_number() || value.is_string());
}

} // namespace

SettingsMemory::SettingsMemory(const std::filesystem::path& folder, std::string_view serialNumber) {
    std::string name("camera-");
    for (const char c : serialNumber.substr(0, 64)) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    m_file = folder / (name + ".json");
}

Json SettingsMemory::read() const {
    constexpr std::uint64_t kMostBytes = 4096;
    std::error_code failure;
    if (!std::filesystem::exists(m_file, failure)) {
        return nullptr;
    }
    try {
        const Json kept = parseJson(readTextFile(m_file, kMostBytes), m_file.string());
        Json settings = Json::object();
        for (const auto& [name, value] : kept.items()) {
            if (canBeKept(name, value)) {
                settings[name] = value;
            }
        }
        return settings.empty() ? Json() : settings;
    } catch (const Error&) { // damaged: what the camera is set to now is the next best
        return nullptr;
    }
}

void SettingsMemory::write(const Json& settings) const {
    try {
        writeFile(m_file, bytesOf(settings.dump()), DurableFile::Overwrite::Yes);
    } catch (const Error& error) {
        // A folder of this computer that is not there must not look like something that the camera lacks.
        throw Error(error.kind() == ErrorKind::NotFound ? ErrorKind::Io : error.kind(), error.sentence(),
                    error.context());
    }
}

void SettingsMemory::forget() const {
    std::error_code ignored; // what is put back twice does no harm
    std::filesystem::remove(m_file, ignored);
}

} // namespace spherewalk::camera
