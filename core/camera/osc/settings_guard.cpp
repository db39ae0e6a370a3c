// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/settings_guard.h"

#include "osc/camera_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/osc_messages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace spherewalk::camera {

namespace {

constexpr int kNever = 65535; // the value by which sleepDelay and offDelay say "never"
constexpr std::size_t kMaxFormats = 1000;
constexpr const char* kMode = "captureMode";

/// Width of a spherical JPEG format; 0 for any other.
std::int64_t sphericalWidth(const Json& format) {
    const auto width = wholeNumber(format, "width");
    const auto height = wholeNumber(format, "height");
    const bool isSpherical = shortText(format, "type") == "jpeg" && width && height && *height > 0 &&
                             *height <= 1'000'000 && *width == 2 * *height;
    return isSpherical ? *width : 0;
}

/// The spherical JPEG of this width that the camera offers, or its largest; null if it offers none or does
/// not say. Errors: InvalidInput if it offers others.
Json formatOf(const Json& present, std::optional<int> width) {
    Json best;
    std::string widths;
    std::int64_t bestWidth = 0;
    const JsonReader options(present, "The camera's settings");
    if (!options.has("fileFormatSupport") || !present["fileFormatSupport"].is_array()) {
        return best;
    }
    const JsonReader offered = options.member("fileFormatSupport");
    const std::size_t count = offered.arraySize(kMaxFormats);
    for (std::size_t i = 0; i < count; ++i) {
        const JsonReader element = offered.element(i);
        const Json& format = element.value();
        const std::int64_t formatWidth = sphericalWidth(format);
        if (formatWidth > 0) {
            widths += text(widths.empty() ? "" : ", ", formatWidth);
        }
        if (formatWidth > bestWidth && (!width || formatWidth == *width)) {
            bestWidth = formatWidth;
            best = format;
        }
    }
    if (width && best.is_null() && !widths.empty()) {
        throw Error(ErrorKind::InvalidInput, text("The camera takes no photos ", *width, " pixels wide, but ",
                                                  widths, ". Change the survey's capture profile."));
    }
    return best;
}

bool isSame(const Json& wanted, const Json& present) {
    if (!wanted.is_object()) {
        return wanted == present;
    }
    return sphericalWidth(wanted) > 0 && sphericalWidth(wanted) == sphericalWidth(present);
}

void requireStillPhotos(const Json& now) {
    if (const auto mode = shortText(now, "captureMode"); mode && *mode != "image") {
        throw Error(ErrorKind::Unsupported, text("The camera stays in the mode \"", printable(*mode),
                                                 "\"; set it to still pictures by its mode button."));
    }
    if (now.contains("fileFormat") && sphericalWidth(now["fileFormat"]) == 0) {
        throw Error(ErrorKind::Unsupported, "The camera does not take spherical JPEGs twice as wide as high; "
                                            "set it to stitched JPEG photos.");
    }
}

std::vector<std::string> delayNames() {
    return {kDelayNames.begin(), kDelayNames.end()};
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
    m_client.waitUntilApplied(stop);
}

void SettingsGuard::rememberIn(const std::filesystem::path& folder, std::string_view serialNumber) {
    m_memory.emplace(folder, serialNumber);
}

/// mode: the capture mode, which decides what the other settings mean.
void SettingsGuard::keepOriginal(const Json& mode, const Json& present) {
    if (!m_original.is_null()) {
        return;
    }
    Json original = m_memory ? m_memory->read() : Json();
    if (original.is_null()) {
        original = mode;
        for (const std::string& name : changedNames()) {
            if (present.contains(name)) {
                original[name] = present[name];
            }
        }
        if (m_memory && !original.empty()) {
            m_memory->write(original);
        }
    }
    m_original = std::move(original);
}

/// The settings besides the mode that apply() may change.
std::vector<std::string> SettingsGuard::changedNames() const {
    std::vector<std::string> names = delayNames();
    names.emplace_back("fileFormat");
    if (m_profile) {
        names.insert(names.end(), profileOptionNames().begin(), profileOptionNames().end());
    }
    return names;
}

Json SettingsGuard::basics(const Json& present) const {
    Json settings = Json::object();
    const auto width = m_profile ? m_profile->photoWidth : std::nullopt;
    if (Json format = formatOf(present, width); !format.is_null()) {
        settings["fileFormat"] = std::move(format);
    }
    for (const char* delay : kDelayNames) {
        if (present.contains(delay)) {
            settings[delay] = kNever;
        }
    }
    return settings;
}

/// The profile as options. The program is set on the way, as it decides which values the camera offers.
Json SettingsGuard::exposure(std::vector<std::string>& lacks, const std::stop_token& stop) {
    if (!m_profile) {
        return Json::object();
    }
    Json known = read(profileOptionNames(), stop);
    const Json program = exposureProgram(*m_profile);
    const bool isAutomatic = !m_profile->iso && !m_profile->shutterS;
    Json first = Json::object();
    if (known.contains("exposureProgram") && !isSameOption(known["exposureProgram"], program)) {
        first["exposureProgram"] = program;
    }
    if (!isAutomatic && known.value("_filter", Json("off")) != "off") {
        first["_filter"] = "off"; // it would force the automatic program
    }
    if (!first.empty()) {
        m_client.setOptions(first, stop);
    }
    known.update(read(profileSupportNames(), stop));
    lacks = profileLacks(*m_profile, known);
    return profileOptions(*m_profile, known);
}

void SettingsGuard::set(const std::stop_token& stop) {
    for (const Json* settings : {&m_basics, &m_exposure}) {
        if (!settings->empty()) {
            m_client.setOptions(*settings, stop);
        }
    }
}

/// How what the camera says differs from what it was set to.
std::vector<std::string> SettingsGuard::differences(const Json& present) const {
    std::vector<std::string> sentences;
    for (const auto& [name, value] : m_basics.items()) {
        // 0 is the other way to say "never" for the power-off time.
        const bool isNever = name == "offDelay" && present.contains(name) && present[name] == 0;
        if (!isNever && (!present.contains(name) || !isSame(value, present[name]))) {
            sentences.push_back(text("The camera did not keep the setting ", name));
        }
    }
    std::ranges::move(exposureLosses(present), std::back_inserter(sentences));
    return sentences;
}

std::vector<std::string> SettingsGuard::exposureLosses(const Json& present) const {
    std::vector<std::string> sentences;
    for (const auto& [name, value] : m_exposure.items()) {
        if (!present.contains(name) || !isSameOption(value, present[name])) {
            sentences.push_back(optionDifference(name, value, present.value(name, Json())));
        }
    }
    return sentences;
}

/// Whoever has lost the exposure of photo after photo will lose that of all.
void SettingsGuard::requireKept(const Json& present, int mostLosses) const {
    const std::vector<std::string> lost = exposureLosses(present);
    if (!lost.empty() && m_losses >= mostLosses) {
        throw Error(ErrorKind::Unsupported,
                    text(lost.front(),
                         ", again, so that no photo would be used. This camera does not keep that setting: "
                         "capture with a profile without it, or with --profile camera, which leaves the "
                         "exposure as you set it at the camera."));
    }
}

std::vector<std::string> SettingsGuard::apply(const std::stop_token& stop) {
    const Json mode = m_original.is_null() ? read({kMode}, stop) : Json::object();
    applyImageMode(stop); // first: in video mode the other settings mean video
    std::vector<std::string> asked = m_original.is_null() ? changedNames() : delayNames();
    asked.emplace_back("fileFormatSupport");
    const Json present = read(asked, stop);
    keepOriginal(mode, present);
    m_basics = basics(present);
    std::vector<std::string> sentences;
    m_exposure = exposure(sentences, stop);
    set(stop);
    std::set<std::string> names = heldNames();
    names.insert({"captureMode", "fileFormat"});
    const Json now = read({names.begin(), names.end()}, stop);
    requireStillPhotos(now);
    for (const std::string& difference : differences(now)) {
        sentences.push_back(
            text(difference, "; keep an eye on it, it may fall asleep or change its photos."));
    }
    return sentences;
}

std::vector<std::string> SettingsGuard::setClock(std::chrono::system_clock::time_point now,
                                                 const std::stop_token& stop) {
    constexpr std::chrono::seconds kTolerance(30);
    const Json present = read({"dateTimeZone"}, stop);
    if (!present.contains("dateTimeZone")) {
        return {};
    }
    const auto shown = parseCameraTime(shortText(present, "dateTimeZone").value_or(""));
    if (shown && std::chrono::abs(*shown - now) < kTolerance) {
        return {};
    }
    try {
        m_client.setOptions({{"dateTimeZone", cameraTime(now, localZone(now))}},
                            stop); // by itself, as it must
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Unsupported && error.kind() != ErrorKind::InvalidInput) {
            throw;
        }
        return {
            "The camera's clock is wrong and cannot be set from here; its photos will carry a wrong time."};
    }
    return {};
}

std::vector<std::string> SettingsGuard::exposureDifferences(const std::stop_token& stop) {
    std::vector<std::string> sentences = m_profile ? exposureNow(stop) : std::vector<std::string>();
    m_losses = sentences.empty() ? 0 : m_losses + 1;
    return sentences;
}

std::vector<std::string> SettingsGuard::exposureNow(const std::stop_token& stop) {
    Json known = read(profileOptionNames(), stop);
    const Json program = exposureProgram(*m_profile);
    if (known.contains("exposureProgram") && !isSameOption(program, known["exposureProgram"])) {
        return {optionDifference("exposureProgram", program, known["exposureProgram"])};
    }
    Json wanted = m_exposure;
    if (wanted.empty()) { // not applied by this program: what it would set
        Json offered = known;
        offered.update(read(profileSupportNames(), stop));
        wanted = profileOptions(*m_profile, offered);
    }
    std::vector<std::string> sentences;
    for (const auto& [name, value] : wanted.items()) {
        if (known.contains(name) && !isSameOption(value, known[name])) {
            sentences.push_back(optionDifference(name, value, known[name]));
        }
    }
    return sentences;
}

std::set<std::string> SettingsGuard::heldNames() const {
    std::set<std::string> names;
    for (const Json* settings : {&m_basics, &m_exposure}) {
        for (const auto& setting : settings->items()) {
            names.insert(setting.key());
        }
    }
    return names;
}

std::vector<std::string> SettingsGuard::hold(const Json& present, const std::stop_token& stop) {
    std::vector<std::string> sentences = differences(present);
    if (sentences.empty()) {
        return sentences;
    }
    requireKept(present, 2);
    set(stop);
    const std::set<std::string> names = heldNames();
    const Json now = read({names.begin(), names.end()}, stop);
    requireKept(now, 1);
    const std::vector<std::string> left = differences(now);
    const bool isRepaired = left.empty();
    sentences = isRepaired ? sentences : left;
    for (std::string& sentence : sentences) {
        sentence += isRepaired ? "; it was set again before the photo."
                               : "; the camera does not keep it, so that the photo may not fit the others.";
    }
    return sentences;
}

std::vector<std::string> SettingsGuard::restore(const std::stop_token& stop) {
    std::vector<std::string> sentences;
    if (m_original.is_object() && !m_original.empty()) {
        Json delays = Json::object();
        Json mode = Json::object();
        Json others = Json::object();
        for (const auto& [name, value] : m_original.items()) {
            const bool isDelay = std::ranges::find(kDelayNames, name) != kDelayNames.end();
            (isDelay ? delays : name == kMode ? mode : others)[name] = value;
        }
        if (!delays.empty()) {
            m_client.setOptions(delays, stop);
        }
        sentences = putBack(others, stop);
        if (mode.value(kMode, "image") != "image") {
            std::ranges::move(putBack(mode, stop), std::back_inserter(sentences));
        }
        if (m_memory) {
            m_memory->forget();
        }
    }
    m_original = nullptr;
    return sentences;
}

/// All at once, because some depend on each other; one by one if the camera refuses that.
std::vector<std::string> SettingsGuard::putBack(const Json& settings, const std::stop_token& stop) {
    const auto isTaken = [&](const Json& some) {
        try {
            m_client.setOptions(some, stop);
            return true;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Unsupported && error.kind() != ErrorKind::InvalidInput) {
                throw;
            }
            return false;
        }
    };
    std::vector<std::string> sentences;
    if (settings.empty() || isTaken(settings)) {
        return sentences;
    }
    for (const auto& [name, value] : settings.items()) {
        if (!isTaken({{name, value}})) {
            sentences.push_back(text("The camera did not take its setting ", name, " back (",
                                     printable(value.dump()), "); look after it before other pictures."));
        }
    }
    return sentences;
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
