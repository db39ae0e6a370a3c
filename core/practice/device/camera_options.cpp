// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/camera_options.h"

#include "photo/camera_time.h"

#include "spherewalk/base/json.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace spherewalk::practice {

namespace {

constexpr std::string_view kSupport = "Support";

std::vector<Json> list(std::initializer_list<Json> values) {
    return values;
}

/// 0: automatic.
const std::vector<Json>& isoSteps() {
    static const std::vector<Json> steps = {0,   64,  80,  100,  125,  160,  200,  250,  320, 400,
                                            500, 640, 800, 1000, 1250, 1600, 2000, 2500, 3200};
    return steps;
}

/// Seconds; 0: automatic.
const std::vector<Json>& shutterSpeeds() {
    static const std::vector<Json> speeds = {
        0,          0.00004, 0.00005, 0.0000625,  0.00008,    0.0001, 0.000125, 0.00015625, 0.0002, 0.00025,
        0.0003125,  0.0004,  0.0005,  0.000625,   0.0008,     0.001,  0.00125,  0.0015625,  0.002,  0.0025,
        0.003125,   0.004,   0.005,   0.00625,    0.008,      0.01,   0.0125,   0.01666666, 0.02,   0.025,
        0.03333333, 0.04,    0.05,    0.06666666, 0.07692307, 0.1,    0.125,    0.16666666, 0.2,    0.25,
        0.33333333, 0.4,     0.5,     0.625,      0.76923076, 1,      1.3,      1.6,        2,      2.5,
        3.2,        4,       5,       6,          8,          10,     13,       15,         20,     25,
        30,         40,      50,      60};
    return speeds;
}

/// Equal as the camera sees it: 1 and 1.0 alike, shutter speeds within a thousandth.
bool same(const Json& a, const Json& b) {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>();
        const double y = b.get<double>();
        return std::abs(x - y) <= 1e-3 * std::abs(y);
    }
    return a == b;
}

} // namespace

CameraOptions::CameraOptions(int width, bool levelled) {
    const std::vector<Json> highLimits(isoSteps().begin() + 6, isoSteps().end());
    define("captureMode", "image", list({"image", "video"}));
    define("fileFormat", Json{{"type", "jpeg"}, {"width", width}, {"height", width / 2}},
           std::vector<Json>{Json{{"type", "jpeg"}, {"width", width}, {"height", width / 2}}});
    define("exposureProgram", 2, list({1, 2, 4, 9}));
    define("iso", 0, isoSteps());
    define("isoAutoHighLimit", 3200, highLimits);
    define("shutterSpeed", 0, shutterSpeeds());
    define("exposureCompensation", 0.0,
           list({-2.0, -1.7, -1.3, -1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0, 1.3, 1.7, 2.0}));
    define("whiteBalance", "auto",
           list({"auto", "daylight", "shade", "cloudy-daylight", "incandescent", "_warmWhiteFluorescent",
                 "_dayLightFluorescent", "_dayWhiteFluorescent", "fluorescent", "_bulbFluorescent",
                 "_colorTemperature", "_underwater"}));
    define("_colorTemperature", 5000, Range{2500, 10000, 100, "minTemperature", "maxTemperature"});
    define("_filter", "off", list({"off", "DR Comp", "Noise Reduction", "hdr", "Hh hdr"}));
    define("exposureDelay", 0, list({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    define("captureInterval", 8, Range{4, 3600, 1, "minInterval", "maxInterval"});
    define("captureNumber", 0, Range{0, 9999, 1, "minNumber", "maxNumber"});
    define("sleepDelay", 180, Range{60, 65535, 1, "minSleepDelay", "maxSleepDelay"});
    define("offDelay", 64800, list({600, 1200, 1800, 64800, 65535, 0}));
    define("_shutterVolume", 50, Range{0, 100, 1, "minShutterVolume", "maxShutterVolume"});
    define("gpsInfo",
           Json{{"lat", 65535}, {"lng", 65535}, {"_altitude", 0}, {"_dateTimeZone", ""}, {"_datum", ""}}, {});
    define("dateTimeZone", "", {});
    define("clientVersion", 2, list({2}));
    define("_topBottomCorrection", levelled ? "Apply" : "Disapply",
           list({"Apply", "ApplyAuto", "ApplySave", "ApplyLoad", "Disapply"}));
    define("_imageStitching", "auto", list({"auto", "static", "dynamicAuto", "dynamicSave", "dynamicLoad"}));
    define("previewFormat", Json{{"width", 1024}, {"height", 512}, {"framerate", 8}},
           list({Json{{"width", 1920}, {"height", 960}, {"framerate", 8}},
                 Json{{"width", 1024}, {"height", 512}, {"framerate", 30}},
                 Json{{"width", 1024}, {"height", 512}, {"framerate", 8}},
                 Json{{"width", 640}, {"height", 320}, {"framerate", 30}},
                 Json{{"width", 640}, {"height", 320}, {"framerate", 8}}}));
    define("_wlanFrequency", 2.4, list({2.4, 5}));
    define("_language", "en-GB", list({"en-GB", "en-US", "de", "fr", "it", "ja", "ko", "zh-CN", "zh-TW"}));
}

void CameraOptions::define(const std::string& name, Json initial, Legal legal) {
    m_legal[name] = std::move(legal);
    m_defaults[name] = initial;
    m_values[name] = std::move(initial);
}

Json CameraOptions::get(const Json& names, const std::map<std::string, Json>& readOnly) const {
    Json options = Json::object();
    for (const Json& entry : names) {
        if (!entry.is_string()) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        const std::string name = entry.get<std::string>();
        const bool isSupport = name.ends_with(kSupport);
        const std::string base = isSupport ? name.substr(0, name.size() - kSupport.size()) : name;
        const bool isKnown = m_values.contains(base);
        const auto* values = isKnown ? std::get_if<std::vector<Json>>(&m_legal.at(base)) : nullptr;
        const auto* range = isKnown ? std::get_if<Range>(&m_legal.at(base)) : nullptr;
        if (const auto known = readOnly.find(name); known != readOnly.end()) {
            options[name] = known->second;
        } else if (isKnown && !isSupport) {
            options[name] = m_values.at(base);
        } else if (values != nullptr) {
            options[name] = *values;
        } else if (range != nullptr) {
            options[name] = {{range->leastName, range->least}, {range->mostName, range->most}};
            if (range->step != 1) {
                options[name]["stepSize"] = range->step;
            }
        } else {
            throw OscError(OscCode::InvalidParameterName);
        }
    }
    return options;
}

void CameraOptions::check(const std::string& name, const Json& value) const {
    const auto legal = m_legal.find(name);
    if (legal == m_legal.end()) {
        throw OscError(OscCode::InvalidParameterName);
    }
    bool isGood = true;
    if (name == "dateTimeZone") {
        isGood = value.is_string() && parseDateTimeZone(value.get<std::string>());
    } else if (name == "gpsInfo") {
        isGood = value.is_object() && value.contains("lat") && value.contains("lng") &&
                 value["lat"].is_number() && value["lng"].is_number();
    } else if (name == "offDelay") {
        const double seconds = value.is_number() ? value.get<double>() : -1;
        isGood = seconds == 0 || seconds == 65535 ||
                 (seconds >= 600 && seconds <= 604800 && std::fmod(seconds, 60) == 0);
    } else if (const auto* values = std::get_if<std::vector<Json>>(&legal->second)) {
        isGood =
            std::any_of(values->begin(), values->end(), [&](const Json& one) { return same(value, one); });
    } else if (const auto* range = std::get_if<Range>(&legal->second)) {
        const double number = value.is_number() ? value.get<double>() : range->least - 1;
        isGood = number >= range->least && number <= range->most && std::fmod(number, range->step) == 0;
    }
    if (!isGood) {
        throw OscError(OscCode::InvalidParameterValue);
    }
}

void CameraOptions::checkTogether(std::map<std::string, Json>& values, const Json& changed) {
    if (changed.contains("_filter") && !same(values["_filter"], "off")) {
        if (same(values["captureMode"], "video")) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        values["exposureProgram"] = 2; // any filter forces automatic exposure
    }
    const int program = values["exposureProgram"].get<int>();
    // A value of zero leaves the choice to the camera; others need the program that has them.
    const auto depend = [&](const char* name, bool applies) {
        if (applies || same(values[name], 0)) {
            return;
        }
        if (changed.contains(name)) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        values[name] = 0;
    };
    depend("iso", program == 1 || program == 9);
    depend("shutterSpeed", program == 1 || program == 4);
    depend("exposureCompensation", program != 1);
}

void CameraOptions::set(const Json& values) {
    if (values.contains("dateTimeZone") && values.size() > 1) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    std::map<std::string, Json> changed = m_values;
    for (const auto& [name, value] : values.items()) {
        check(name, value);
        changed[name] = value;
    }
    checkTogether(changed, values);
    m_values = std::move(changed);
}

void CameraOptions::forgetExposure() {
    for (const char* name :
         {"captureMode", "fileFormat", "exposureProgram", "iso", "isoAutoHighLimit", "shutterSpeed",
          "exposureCompensation", "whiteBalance", "_colorTemperature", "_filter", "exposureDelay", "gpsInfo",
          "_topBottomCorrection", "_imageStitching", "previewFormat"}) {
        m_values[name] = m_defaults[name];
    }
}

Json CameraOptions::exposure() const {
    Json values = Json::object();
    for (const char* name : {"exposureProgram", "iso", "shutterSpeed", "exposureCompensation", "whiteBalance",
                             "_colorTemperature", "_filter"}) {
        values[name] = m_values.at(name);
    }
    return values;
}

void CameraOptions::reset() {
    const Json clock = m_values["dateTimeZone"];
    m_values = m_defaults;
    m_values["dateTimeZone"] = clock;
}

} // namespace spherewalk::practice
