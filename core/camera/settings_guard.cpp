// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/settings_guard.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::camera {

namespace {

constexpr int kNever = 65535; // the value by which sleepDelay and offDelay say "never"
constexpr std::size_t kMaxFormats = 1000;

/// Width of a spherical JPEG format; 0 for any other.
std::int64_t sphericalWidth(const Json& format) {
    const auto width = wholeNumber(format, "width");
    const auto height = wholeNumber(format, "height");
    const bool isSpherical = shortText(format, "type") == "jpeg" && width && height && *height > 0 &&
                             *height <= 1'000'000 && *width == 2 * *height;
    return isSpherical ? *width : 0;
}

/// The largest spherical JPEG that the camera offers; null if it offers none or does not say.
Json largestFormat(const Json& present) {
    Json best;
    std::int64_t bestWidth = 0;
    const JsonReader options(present, "The camera's settings");
    if (!options.has("fileFormatSupport") || !present["fileFormatSupport"].is_array()) {
        return best;
    }
    const JsonReader offered = options.member("fileFormatSupport");
    const std::size_t count = offered.arraySize(kMaxFormats);
    for (std::size_t i = 0; i < count; ++i) {
        const Json& format = offered.element(i).value();
        if (sphericalWidth(format) > bestWidth) {
            bestWidth = sphericalWidth(format);
            best = format;
        }
    }
    return best;
}

bool isSame(const Json& wanted, const Json& present) {
    if (!wanted.is_object()) {
        return wanted == present;
    }
    return sphericalWidth(wanted) > 0 && sphericalWidth(wanted) == sphericalWidth(present);
}

double secondsIn(const Json& options, std::string_view key) {
    const auto seconds = finiteNumber(options, key);
    return seconds ? std::clamp(*seconds, 0.0, 3600.0) : 0.0;
}

} // namespace

Json SettingsGuard::read(const std::vector<std::string>& names, const std::stop_token& stop) {
    std::vector<std::string> known;
    std::copy_if(names.begin(), names.end(), std::back_inserter(known),
                 [this](const std::string& name) { return !m_unknown.contains(name); });
    if (known.empty()) {
        return Json::object();
    }
    if (std::optional<Json> options = m_client.findOptions(known, stop)) {
        return *std::move(options);
    }
    if (known.size() == 1) {
        m_unknown.insert(known.front());
        return Json::object();
    }
    // One unknown name fails the whole call, so each is asked for alone, once for this camera.
    Json options = Json::object();
    for (const std::string& name : known) {
        options.update(read({name}, stop));
    }
    return options;
}

void SettingsGuard::applyImageMode(const std::stop_token& stop) {
    m_client.setOptions({{"captureMode", "image"}}, stop);
    m_client.settle(stop);
}

Json SettingsGuard::wanted(const Json& present) const {
    Json settings = Json::object();
    if (Json format = largestFormat(present); !format.is_null()) {
        settings["fileFormat"] = std::move(format);
    }
    for (const char* delay : {"sleepDelay", "offDelay"}) {
        if (present.contains(delay)) {
            settings[delay] = kNever;
        }
    }
    return settings;
}

std::vector<std::string> SettingsGuard::differences(const Json& wanted, const std::stop_token& stop) {
    const Json now = read({"captureMode", "fileFormat", "sleepDelay", "offDelay"}, stop);
    if (const auto mode = shortText(now, "captureMode"); mode && *mode != "image") {
        throw Error(ErrorKind::Unsupported, text("The camera stays in the mode \"", printable(*mode),
                                                 "\"; set it to still pictures by its mode button."));
    }
    if (now.contains("fileFormat") && sphericalWidth(now["fileFormat"]) == 0) {
        throw Error(ErrorKind::Unsupported, "The camera does not take spherical JPEGs twice as wide as high; "
                                            "set it to stitched JPEG photos.");
    }
    std::vector<std::string> sentences;
    for (const auto& [name, value] : wanted.items()) {
        // 0 is the other way to say "never" for the power-off time.
        const bool isNever = name == "offDelay" && now.contains(name) && now[name] == 0;
        if (!isNever && (!now.contains(name) || !isSame(value, now[name]))) {
            sentences.push_back(text("The camera did not keep the setting ", name,
                                     "; keep an eye on it, it may fall asleep or change its photos."));
        }
    }
    return sentences;
}

std::vector<std::string> SettingsGuard::apply(const std::stop_token& stop) {
    applyImageMode(stop); // first: in video mode the other settings mean video
    const Json present = read({"fileFormatSupport", "sleepDelay", "offDelay"}, stop);
    if (m_original.is_null()) {
        m_original = Json::object();
        for (const char* delay : {"sleepDelay", "offDelay"}) {
            if (present.contains(delay)) {
                m_original[delay] = present[delay];
            }
        }
    }
    const Json settings = wanted(present);
    if (!settings.empty()) {
        m_client.setOptions(settings, stop);
    }
    return differences(settings, stop);
}

void SettingsGuard::restore(const std::stop_token& stop) {
    if (m_original.is_object() && !m_original.empty()) {
        m_client.setOptions(m_original, stop);
    }
    m_original = nullptr;
}

std::chrono::milliseconds ShotAllowance::of(const Json& options) const {
    const double cameraSeconds =
        secondsIn(options, "exposureDelay") + exposureFactor * secondsIn(options, "shutterSpeed");
    auto time = base + std::chrono::milliseconds(std::llround(1000 * timeScale * cameraSeconds));
    const auto filter = shortText(options, "_filter");
    if (filter == "hdr" || filter == "Hh hdr" || filter == "Noise Reduction") {
        time += filterExtra;
    }
    return time;
}

} // namespace spherewalk::camera
