// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_condition.h"
#include "camera_options.h"
#include "camera_storage.h"
#include "exposure.h"
#include "live_preview.h"
#include "osc_error.h"
#include "osc_session.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace spherewalk::practice {

class FaultPlan;

/// The camera behind the HTTP server: requests as JSON in, answers as JSON out. baseUrl: "http://host:port",
/// with which file URLs begin. Threads: any.
class OscDevice {
  public:
    OscDevice(const PracticeCameraOptions& options, FaultPlan& faults, Clock& clock);
    ~OscDevice();
    OscDevice(const OscDevice&) = delete;
    OscDevice& operator=(const OscDevice&) = delete;

    Json info(int httpPort) const;
    Json state(const std::string& baseUrl) const;
    OscReply checkForUpdates(const std::string& body) const;
    OscReply execute(const Json& request, const std::string& baseUrl);
    OscReply status(const std::string& body, const std::string& baseUrl);

    /// Does to the camera what the fault says. Those that close its port are passed on.
    void meet(const Fault& fault);

    /// Who closes the port. Before start.
    void onOutage(std::function<void(const Fault&)> outage) { m_outage = std::move(outage); }

    /// As at power-on: a running exposure is lost, ids and settings are forgotten.
    void restart();
    void fallAsleep();

    /// Begins a live preview, which ends the one before; nothing while a picture is taken.
    std::optional<std::uint64_t> beginPreview();
    /// False once a picture was taken, the mode or the preview's format was changed, or another began.
    bool isPreviewing(std::uint64_t preview) const;
    /// The preview's next picture, at its rate; null once it has ended.
    std::shared_ptr<const Bytes> nextPreviewPicture(std::uint64_t preview);

    /// Where the bytes of a file URL's path lie; nothing if there is no such file.
    std::optional<std::filesystem::path> fileOf(const std::string& urlPath) const;
    /// The same for camera.getImage of API level 1.
    std::optional<std::filesystem::path> imageOf(const Json& request) const;

    void setPosition(const Eigen::Vector3d& positionM);
    Eigen::Vector3d position() const;
    int exposures() const;
    std::filesystem::path storageFolder() const;
    std::filesystem::path truthFile() const;

    /// Ends a running exposure and joins its thread.
    void stop();

    /// Waits as long as the camera would need, times the time scale; sooner when stopped.
    void pause(double seconds) const { pause(seconds, m_stop.get_token()); }

    void pause(double seconds, const std::stop_token& stop) const;

  private:
    enum class Phase { Countdown, Shooting };
    enum class Outcome { Running, Done, Failed };

    struct Capture {
        std::string id;
        Outcome outcome = Outcome::Running;
        OscCode code = OscCode::Unexpected;
        std::string failure; ///< a sentence
        std::string urlPath;
        int answers = 0;
        bool isStuck = false; ///< says "in progress" for ever
    };

    Capture* capture(const std::string& id);
    OscReply executeLevelTwo(const std::string& command, const Json& parameters, const std::string& baseUrl);
    OscReply executeLevelOne(const std::string& command, const Json& parameters);
    OscReply executeAnyLevel(const std::string& command, const Json& parameters);
    OscReply takePicture();
    OscReply getOptions(const Json& parameters) const;
    OscReply setOptions(const Json& parameters);
    OscReply stopSelfTimer();
    std::string captureStatus() const;
    Json errors() const;
    void meetStatusFaults();
    Json doneResults(const Capture& capture, const std::string& baseUrl);
    bool survives(std::string_view phase);
    void takeExtraPhoto();
    void store(ExposedPhoto& photo, const ExposureSettings& settings);
    void loseCharge(double fraction);
    void forget();

    void run(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
             double countdownS, double busyS);
    void shoot(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
               double busyS);
    void finish(const std::string& id, Outcome outcome, OscCode code, const std::string& failure);
    ExposureSettings settingsNow(int shot) const;
    double busySeconds(const ExposureSettings& settings) const;
    ZonedTime now() const;
    std::uint64_t remainingBytes() const;
    std::uint64_t remainingPictures() const;

    void changed() { ++m_fingerprint; }

    const PracticeCameraOptions& m_options;
    FaultPlan& m_faults;
    std::function<void(const Fault&)> m_outage = [](const Fault&) {};
    Clock& m_clock;
    Exposer m_exposer;
    LivePreview m_preview{m_exposer};
    std::stop_source m_stop;

    mutable std::mutex m_mutex; ///< guards all below
    CameraStorage m_storage;
    std::filesystem::path m_truthFile;
    CameraOptions m_settings;
    Eigen::Vector3d m_position;
    std::chrono::system_clock::duration m_clockOffset{0};
    std::chrono::minutes m_zone{0};
    std::vector<Capture> m_captures; ///< oldest first
    std::optional<Phase> m_phase;    ///< of the capture that is running
    std::stop_source m_countdown;
    CameraCondition m_condition;
    int m_level;
    OscSession m_session;
    Clock::TimePoint m_boot;
    int m_nextId = 0;
    int m_fingerprint = 0;
    int m_exposures = 0;
    std::jthread m_worker; ///< last: ends before what it uses
};

} // namespace spherewalk::practice
