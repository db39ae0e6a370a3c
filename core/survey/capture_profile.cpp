// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/capture_profile.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <cmath>

namespace spherewalk::survey {

namespace {

constexpr EnumNames<WhiteBalance, 10> kBalances{
    {{WhiteBalance::Auto, "auto"},
     {WhiteBalance::Daylight, "daylight"},
     {WhiteBalance::Shade, "shade"},
     {WhiteBalance::Cloudy, "cloudy"},
     {WhiteBalance::Incandescent, "incandescent"},
     {WhiteBalance::Fluorescent, "fluorescent"},
     {WhiteBalance::WarmWhiteFluorescent, "warm-white-fluorescent"},
     {WhiteBalance::DaylightFluorescent, "daylight-fluorescent"},
     {WhiteBalance::DayWhiteFluorescent, "day-white-fluorescent"},
     {WhiteBalance::BulbFluorescent, "bulb-fluorescent"}}};

constexpr std::array kIsoSteps{64,  80,  100, 125,  160,  200,  250,  320,  400,
                               500, 640, 800, 1000, 1250, 1600, 2000, 2500, 3200};

// Source: Ricoh's Theta V API, the decimals that the camera lists; the longest are no use in a survey.
constexpr std::array kShutterTimes{
    0.00004, 0.00005, 0.0000625,  0.00008,    0.0001, 0.000125, 0.00015625, 0.0002, 0.00025, 0.0003125,
    0.0004,  0.0005,  0.000625,   0.0008,     0.001,  0.00125,  0.0015625,  0.002,  0.0025,  0.003125,
    0.004,   0.005,   0.00625,    0.008,      0.01,   0.0125,   0.01666666, 0.02,   0.025,   0.03333333,
    0.04,    0.05,    0.06666666, 0.07692307, 0.1,    0.125,    0.16666666, 0.2,    0.25,    0.33333333,
    0.4,     0.5,     0.625,      0.76923076, 1.0,    1.3,      1.6,        2.0,    2.5,     3.2,
    4.0,     5.0,     6.0,        8.0,        10.0,   13.0,     15.0};

constexpr std::array kCompensations{-2.0, -1.7, -1.3, -1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0, 1.3, 1.7, 2.0};

[[noreturn]] void refuseProfile(const std::string& why) {
    throw Error(ErrorKind::InvalidInput, text("The capture profile cannot be used: ", why, "."));
}

template <class Number>
void requireRange(const char* what, std::optional<Number> value, double least, double most) {
    if (value && !(*value >= least && *value <= most)) {
        refuseProfile(text(what, " must lie between ", least, " and ", most, ", not ", *value));
    }
}

/// "1/60" and "0.5".
std::optional<double> parseSeconds(std::string_view spelled) {
    if (!spelled.starts_with("1/")) {
        return parseNumber(spelled);
    }
    const auto parts = parseNumber(spelled.substr(2));
    return parts && *parts > 0 ? std::optional(1 / *parts) : std::nullopt;
}

double numberOf(std::string_view key, std::string_view value) {
    const auto number = key == "shutter" ? parseSeconds(value) : parseNumber(value);
    if (!number) {
        refuseProfile(text(key, " is no number: \"", printable(value), "\""));
    }
    return *number;
}

int wholeOf(std::string_view key, std::string_view value) {
    const double number = numberOf(key, value);
    if (std::abs(number) > 1e6 || number != std::floor(number)) {
        refuseProfile(text(key, " must be a whole number, not ", printable(value)));
    }
    return static_cast<int>(number);
}

void set(CaptureProfile& profile, std::string_view key, std::string_view value) {
    if (key == "iso") {
        profile.iso = wholeOf(key, value);
    } else if (key == "shutter") {
        profile.shutterS = numberOf(key, value);
    } else if (key == "ev") {
        profile.compensationEv = numberOf(key, value);
    } else if (key == "width") {
        profile.photoWidth = wholeOf(key, value);
    } else if (key == "white-balance" && value.ends_with('K')) {
        profile.colourTemperatureK = wholeOf(key, value.substr(0, value.size() - 1));
    } else if (key == "white-balance") {
        profile.whiteBalance = whiteBalanceNamed(value);
    } else {
        refuseProfile(
            text("it has no \"", printable(key),
                 "\"; write auto, camera, or iso=, shutter=, ev=, white-balance=, width= with commas "
                 "between"));
    }
}

} // namespace

std::string_view name(WhiteBalance balance) {
    return nameOf(kBalances, balance);
}

WhiteBalance whiteBalanceNamed(std::string_view name) {
    return valueOf(kBalances, "The white balance", name);
}

void CaptureProfile::validate() const {
    requireRange("the ISO", iso, 10, 102'400);
    requireRange("the shutter time", shutterS, 1e-6, 60);
    requireRange("the exposure compensation", std::optional(compensationEv), -5, 5);
    requireRange("the colour temperature", colourTemperatureK, 1000, 20'000);
    requireRange("the photos' width", photoWidth, 512, 32'768);
    if (iso && shutterS && compensationEv != 0) {
        refuseProfile("with ISO and shutter fixed there is nothing left that ev could change");
    }
    if (colourTemperatureK && whiteBalance != WhiteBalance::Auto) {
        refuseProfile("give a white balance or a colour temperature, not both");
    }
}

std::optional<CaptureProfile> parseProfile(std::string_view spelled) {
    if (spelled == "camera") {
        return std::nullopt;
    }
    CaptureProfile profile;
    for (std::string_view rest = spelled == "auto" ? "" : spelled; !rest.empty();) {
        const std::string_view one = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        const std::size_t equals = std::min(one.find('='), one.size());
        set(profile, one.substr(0, equals), one.substr(std::min(one.size(), equals + 1)));
    }
    profile.validate();
    return profile;
}

std::string profileText(const std::optional<CaptureProfile>& profile) {
    if (!profile) {
        return "camera";
    }
    std::string words;
    const auto add = [&](const std::string& word) { words += (words.empty() ? "" : ",") + word; };
    if (profile->iso) {
        add(text("iso=", *profile->iso));
    }
    if (profile->shutterS) {
        add(text("shutter=", shutterText(*profile->shutterS)));
    }
    if (profile->compensationEv != 0) {
        add(text("ev=", profile->compensationEv));
    }
    if (profile->colourTemperatureK) {
        add(text("white-balance=", *profile->colourTemperatureK, "K"));
    } else if (profile->whiteBalance != WhiteBalance::Auto) {
        add(text("white-balance=", name(profile->whiteBalance)));
    }
    if (profile->photoWidth) {
        add(text("width=", *profile->photoWidth));
    }
    return words.empty() ? "auto" : words;
}

std::string shutterText(double seconds) {
    const double parts = seconds > 0 ? std::round(1 / seconds) : 0;
    constexpr double kSame = 1e-3; // as cameras list 1/60 as 0.01666666
    const bool isFraction = parts >= 3 && std::abs(1 / parts - seconds) <= kSame * seconds;
    return isFraction ? text("1/", static_cast<long long>(parts)) : text(seconds);
}

std::span<const int> usualIsoSteps() {
    return kIsoSteps;
}

std::span<const double> usualShutterTimes() {
    return kShutterTimes;
}

std::span<const double> usualCompensations() {
    return kCompensations;
}

} // namespace spherewalk::survey
