// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc/camera_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/osc_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace spherewalk::camera {

using survey::CaptureProfile;
using survey::WhiteBalance;

namespace {

constexpr double kSameValue = 1e-3; // as cameras list 1/60 s as 0.01666666
constexpr std::size_t kMostOffered = 1000;

/// Options and what people call them.
constexpr std::array kWords{std::pair{"exposureProgram", "exposure program"},
                            std::pair{"iso", "ISO"},
                            std::pair{"shutterSpeed", "shutter time"},
                            std::pair{"exposureCompensation", "exposure compensation"},
                            std::pair{"whiteBalance", "white balance"},
                            std::pair{"_colorTemperature", "colour temperature"},
                            std::pair{"_filter", "filter"}};

std::string wordOf(const std::string& name) {
    for (const auto& [option, word] : kWords) {
        if (name == option) {
            return word;
        }
    }
    return text("setting ", name);
}

/// As people write the option's values.
std::string valueWords(const std::string& name, const Json& value) {
    if (value.is_number()) {
        const auto number = value.get<double>();
        return name == "shutterSpeed" && number > 0 ? survey::shutterText(number) + " s" : text(number);
    }
    return value.is_string() ? printable(value.get<std::string>()) : printable(value.dump());
}

const char* spelled(WhiteBalance balance) {
    switch (balance) {
    case WhiteBalance::Auto:
        return "auto";
    case WhiteBalance::Daylight:
        return "daylight";
    case WhiteBalance::Shade:
        return "shade";
    case WhiteBalance::Cloudy:
        return "cloudy-daylight";
    case WhiteBalance::Incandescent:
        return "incandescent";
    case WhiteBalance::Fluorescent:
        return "fluorescent";
    case WhiteBalance::WarmWhiteFluorescent:
        return "_warmWhiteFluorescent";
    case WhiteBalance::DaylightFluorescent:
        return "_dayLightFluorescent";
    case WhiteBalance::DayWhiteFluorescent:
        return "_dayWhiteFluorescent";
    case WhiteBalance::BulbFluorescent:
        return "_bulbFluorescent";
    }
    return "auto";
}

/// The numbers that the camera offers for the option, in order; empty if it does not list them.
std::vector<double> offeredNumbers(const Json& known, const std::string& name) {
    std::vector<double> numbers;
    const auto list = known.find(name + "Support");
    if (list != known.end() && list->is_array() && list->size() <= kMostOffered) {
        for (const Json& value : *list) {
            if (value.is_number() && std::isfinite(value.get<double>())) {
                numbers.push_back(value.get<double>());
            }
        }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

/// The value as the camera spells it. within: how far off a person's way to write it may be.
double offered(const Json& known, const std::string& name, double wanted, double within) {
    const std::vector<double> numbers = offeredNumbers(known, name);
    if (numbers.empty()) {
        return wanted;
    }
    const auto above = std::lower_bound(numbers.begin(), numbers.end(), wanted);
    const auto below = above == numbers.begin() ? above : above - 1;
    const double high = above == numbers.end() ? *below : *above;
    const double nearest = std::abs(high - wanted) < std::abs(*below - wanted) ? high : *below;
    if (std::abs(nearest - wanted) > within) {
        const std::string other = *below == high ? "" : text(" and ", valueWords(name, high));
        throw Error(ErrorKind::InvalidInput,
                    text("The camera does not offer the ", wordOf(name), " ", valueWords(name, wanted),
                         "; the nearest are ", valueWords(name, *below), other,
                         ". Change the survey's capture profile."));
    }
    return nearest;
}

Json whiteBalance(const Json& known, WhiteBalance balance) {
    Json wanted = spelled(balance);
    const auto list = known.find("whiteBalanceSupport");
    if (list != known.end() && list->is_array() &&
        std::find(list->begin(), list->end(), wanted) == list->end()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The camera does not offer the white balance ", survey::name(balance),
                         ". Change the survey's capture profile."));
    }
    return wanted;
}

} // namespace

const std::vector<std::string>& profileOptionNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        result.reserve(std::size(kWords));
        for (const auto& [option, word] : kWords) {
            result.emplace_back(option);
        }
        return result;
    }();
    return names;
}

std::vector<std::string> profileSupportNames() {
    return {"isoSupport", "shutterSpeedSupport", "exposureCompensationSupport", "whiteBalanceSupport"};
}

int exposureProgram(const CaptureProfile& profile) {
    constexpr int kManual = 1;
    constexpr int kAutomatic = 2;
    constexpr int kShutterPriority = 4;
    constexpr int kIsoPriority = 9;
    return profile.iso ? (profile.shutterS ? kManual : kIsoPriority)
                       : (profile.shutterS ? kShutterPriority : kAutomatic);
}

Json profileOptions(const CaptureProfile& profile, const Json& known) {
    Json options = Json::object();
    const auto set = [&](const char* name, auto&& value) {
        if (known.contains(name)) {
            options[name] = value();
        }
    };
    set("exposureProgram", [&] { return exposureProgram(profile); });
    if (profile.iso) {
        set("iso", [&] { return static_cast<int>(offered(known, "iso", *profile.iso, 0.5)); });
    }
    if (profile.shutterS) {
        constexpr double kRounding = 0.02; // 1/13 s is listed as 0.0769
        set("shutterSpeed",
            [&] { return offered(known, "shutterSpeed", *profile.shutterS, kRounding * *profile.shutterS); });
    }
    if (!profile.iso || !profile.shutterS) {
        constexpr double kThird = 0.05; // 1/3 is listed as 0.3
        set("exposureCompensation",
            [&] { return offered(known, "exposureCompensation", profile.compensationEv, kThird); });
    }
    if (profile.colourTemperatureK) {
        set("whiteBalance", [] { return "_colorTemperature"; });
        set("_colorTemperature", [&] { return *profile.colourTemperatureK; });
    } else {
        set("whiteBalance", [&] { return whiteBalance(known, profile.whiteBalance); });
    }
    return options;
}

std::vector<std::string> profileLacks(const CaptureProfile& profile, const Json& known) {
    std::vector<std::string> sentences;
    const auto require = [&](bool isFixed, const char* name) {
        if (isFixed && !known.contains(name)) {
            sentences.push_back(
                text("The camera does not let its ", wordOf(name), " be set; it chooses it by itself."));
        }
    };
    require(profile.iso.has_value(), "iso");
    require(profile.shutterS.has_value(), "shutterSpeed");
    require(profile.compensationEv != 0, "exposureCompensation");
    require(profile.whiteBalance != WhiteBalance::Auto, "whiteBalance");
    require(profile.colourTemperatureK.has_value(), "_colorTemperature");
    return sentences;
}

bool isSameOption(const Json& a, const Json& b) {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>();
        return std::abs(x - b.get<double>()) <= kSameValue * std::abs(x);
    }
    return a == b;
}

std::string optionDifference(const std::string& name, const Json& wanted, const Json& found) {
    return text("The camera's ", wordOf(name), " is ", valueWords(name, found), " instead of ",
                valueWords(name, wanted));
}

std::string cameraTime(std::chrono::system_clock::time_point time, std::chrono::minutes zone) {
    using namespace std::chrono;
    const auto local = floor<seconds>(time) + zone;
    const auto day = floor<days>(local);
    const year_month_day date(day);
    const hh_mm_ss clock(local - day);
    const int offset = static_cast<int>(zone.count());
    std::array<char, 64> spelled{};
    std::snprintf(spelled.data(), spelled.size(), "%04d:%02u:%02u %02d:%02d:%02d%c%02d:%02d",
                  static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
                  static_cast<int>(clock.minutes().count()), static_cast<int>(clock.seconds().count()),
                  offset < 0 ? '-' : '+', std::abs(offset) / 60, std::abs(offset) % 60);
    return spelled.data();
}

// By places, as a zone behind UTC begins with a dash.
std::optional<std::chrono::system_clock::time_point> parseCameraTime(std::string_view text) {
    using namespace std::chrono;
    constexpr std::string_view kShape = "0000:00:00 00:00:00+00:00";
    if (text.size() != kShape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kShape.size(); ++i) {
        const bool fits = kShape[i] == '0' || text[i] == kShape[i] || (kShape[i] == '+' && text[i] == '-');
        if (!fits) {
            return std::nullopt;
        }
    }
    const year_month_day date{year(digitsAt(text, 0, 4)), month(static_cast<unsigned>(digitsAt(text, 5, 2))),
                              day(static_cast<unsigned>(digitsAt(text, 8, 2)))};
    const std::array<int, 5> parts{digitsAt(text, 11, 2), digitsAt(text, 14, 2), digitsAt(text, 17, 2),
                                   digitsAt(text, 20, 2), digitsAt(text, 23, 2)};
    for (const int part : parts) {
        if (part < 0 || part > 60) {
            return std::nullopt;
        }
    }
    if (!date.ok()) {
        return std::nullopt;
    }
    const minutes zone = hours(parts[3]) + minutes(parts[4]);
    return sys_days(date) + hours(parts[0]) + minutes(parts[1]) + seconds(parts[2]) -
           (text[19] == '-' ? -zone : zone);
}

std::chrono::minutes localZone(std::chrono::system_clock::time_point time) {
    using namespace std::chrono;
    const std::time_t moment = system_clock::to_time_t(time);
    std::tm local{};
    return ::localtime_r(&moment, &local) == nullptr ? minutes(0) : minutes(local.tm_gmtoff / 60);
}

} // namespace spherewalk::camera
