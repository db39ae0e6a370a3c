// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_client.h"
#include "spherewalk/survey/capture_profile.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::camera {

/// The options that say when a camera sleeps and switches itself off.
inline constexpr std::array kDelayNames{"sleepDelay", "offDelay"};

/// Where a camera's own settings are kept while a survey sets it, so that they outlive a program that is
/// killed: a small file for each camera.
class SettingsMemory {
  public:
    SettingsMemory(const std::filesystem::path& folder, std::string_view serialNumber);

    /// The settings that were written and not forgotten; null if there are none.
    Json read() const;
    /// Writes the settings durably. Errors: Io, Full.
    void write(const Json& settings) const;
    void forget() const;

  private:
    std::filesystem::path m_file;
};

/// Brings a camera into the state in which a survey is taken (still pictures, a spherical JPEG, exposed as
/// the survey's profile says, never asleep), proves it by reading back, and puts all settings but the clock
/// back at the end. Errors: those of OscClient. Threads: those of its client.
class SettingsGuard {
  public:
    /// Owner: the client must outlive the guard.
    /// profile: none leaves the exposure as the camera is set.
    explicit SettingsGuard(OscClient& client, std::optional<survey::CaptureProfile> profile = {})
        : m_client(client), m_profile(profile) {}

    /// Where the camera's own settings are kept until they are put back, so that the next program puts them
    /// back if this one is killed: a file of this folder. Before apply().
    void rememberIn(const std::filesystem::path& folder, std::string_view serialNumber);
    /// Applies and reads back. What the camera lacks or changes without harm is returned as sentences.
    /// Errors: also Unsupported, if it stays out of still mode or offers no spherical JPEG; InvalidInput if
    /// it does not offer what the profile asks for.
    std::vector<std::string> apply(const std::stop_token& stop);
    /// Names of the options that apply() has set.
    std::set<std::string> heldNames() const;
    /// Compares these options with what apply() has set, and sets it again if they differ: a camera forgets
    /// its settings when it sleeps. What differed, as sentences.
    std::vector<std::string> hold(const Json& present, const std::stop_token& stop);
    /// Sets the camera's clock if it is more than half a minute off; what it refused, as a sentence.
    std::vector<std::string> setClock(std::chrono::system_clock::time_point now, const std::stop_token& stop);
    /// How the camera's exposure differs from the profile at this moment; changes nothing.
    std::vector<std::string> exposureDifferences(const std::stop_token& stop);
    /// Sets only the mode, after a camera has refused to take a picture.
    void applyImageMode(const std::stop_token& stop);
    /// Puts back what apply() found at its first call, or a killed program before it; nothing if apply() was
    /// not called. Sleep and power-off times come first. What the camera does not take back, as sentences.
    std::vector<std::string> restore(const std::stop_token& stop);

    /// Reads the options that this camera knows. Unknown ones are remembered and not asked for again.
    Json read(const std::vector<std::string>& names, const std::stop_token& stop);

  private:
    void keepOriginal(const Json& mode, const Json& present);
    std::vector<std::string> putBack(const Json& settings, const std::stop_token& stop);
    std::vector<std::string> changedNames() const;
    Json basics(const Json& present) const;
    Json exposure(std::vector<std::string>& lacks, const std::stop_token& stop);
    void set(const std::stop_token& stop);
    std::vector<std::string> differences(const Json& present) const;
    std::vector<std::string> exposureLosses(const Json& present) const;
    std::vector<std::string> exposureNow(const std::stop_token& stop);
    void requireKept(const Json& present, int mostLosses) const;

    OscClient& m_client;
    std::optional<survey::CaptureProfile> m_profile;
    std::set<std::string> m_unknown;
    std::optional<SettingsMemory> m_memory;
    Json m_original;                  ///< Null until apply().
    Json m_basics = Json::object();   ///< The photos' format and no sleep, as apply() has set them.
    Json m_exposure = Json::object(); ///< Exposure that apply() has set, in one call, since its values depend
                                      ///< on each other.
    int m_losses = 0;                 ///< How often in a row a look after a photo found another exposure.
};

/// The time that a shot may take before it counts as lost: the base, the self-timer, twice the exposure, and
/// an extra for filters that take several exposures. Source: times that users of Theta cameras report.
struct ShotAllowance {
    std::chrono::milliseconds base{30'000};
    std::chrono::milliseconds filterExtra{20'000};
    double exposureFactor = 2;
    double timeScale =
        1; ///< Factor for the camera's own times; 0.01 for a practice camera that is 100 times as fast.

    /// The allowance for a shot with these options: exposureDelay, shutterSpeed and _filter, if the camera
    /// has them.
    std::chrono::milliseconds of(const Json& options) const;
};

} // namespace spherewalk::camera
