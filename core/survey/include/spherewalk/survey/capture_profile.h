// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spherewalk::survey {

/// The white balances that cameras know.
enum class WhiteBalance {
    Auto,
    Daylight,
    Shade,
    Cloudy,
    Incandescent,
    Fluorescent,
    WarmWhiteFluorescent,
    DaylightFluorescent,
    DayWhiteFluorescent,
    BulbFluorescent,
};

/// "auto", "daylight", "warm-white-fluorescent", ..., as options and the survey spell the balance.
std::string_view name(WhiteBalance balance);
/// Errors: InvalidInput for an unknown name; the sentence lists all names.
WhiteBalance whiteBalanceNamed(std::string_view name);

/// How the camera is set for every photo of a survey. The camera chooses each setting that has no value,
/// photo by photo. The exposure program follows: without ISO and shutter time it is automatic, with both
/// manual.
struct CaptureProfile {
    std::optional<int> iso;
    std::optional<double> shutterS;
    double compensationEv =
        0; ///< Exposure compensation; it counts where the camera chooses ISO or shutter time.
    WhiteBalance whiteBalance = WhiteBalance::Auto;
    std::optional<int> colourTemperatureK; ///< Colour temperature in kelvins, which replaces a white balance.
    std::optional<int> photoWidth; ///< Width in pixels; nothing for the largest that the camera offers.

    bool operator==(const CaptureProfile&) const = default;

    /// Errors: InvalidInput, with the value and its range, for a compensation of what is fixed, and for both
    /// a white balance and a temperature.
    void validate() const;
};

/// Reads "auto", "camera", or values separated by commas: "iso=200,shutter=1/60,white-balance=5200K,ev=-0.3,
/// width=5376". "camera" is no profile: everything stays as the camera is set. Errors: InvalidInput.
std::optional<CaptureProfile> parseProfile(std::string_view spelled);

/// The text that parseProfile() reads as this profile.
std::string profileText(const std::optional<CaptureProfile>& profile);

/// "1/60" or "2.5": seconds, as photographers write them.
std::string shutterText(double seconds);

/// What a Theta V offers, for forms; the camera at hand has the last word. Shutter times in seconds.
std::span<const int> usualIsoSteps();
std::span<const double> usualShutterTimes();
std::span<const double> usualCompensations();

} // namespace spherewalk::survey
