// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "device/camera_options.h"
#include "device/camera_storage.h"
#include "device/osc_protocol.h"
#include "photo/exposure.h"

#include "spherewalk/practice/fault.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace spherewalk::practice {

class FaultPlan;

/// The troubles that the camera has.
struct CameraCondition {
    std::optional<double> battery; ///< Charge, [0, 1]. Nothing: it falls as pictures are taken.
    bool isFull = false;
    bool isOutOfRoom = false; ///< It is full, and somebody asked for a picture since.
    bool isHot = false;
    bool isClockUnset = false;
    bool hasPlugin = false;
    bool saysUnknownThings = false;
    std::uint64_t serialShift = 0; ///< Another number means another camera.
    double slowness = 1;
};

/// The live preview, which shows the next photo small. There is one preview at a time; a new one ends the one
/// before. Threads: any.
class LivePreview {
  public:
    explicit LivePreview(const Exposer& exposer) : m_exposer(exposer) {}

    /// Begins a preview. Returns its number.
    std::uint64_t begin();

    void end() { begin(); }

    bool isCurrent(std::uint64_t preview) const;

    /// The preview of the photo with these settings, as a JPEG. The last picture is drawn again only if the
    /// settings change it. Stop: throws Error{Stopped}.
    std::shared_ptr<const Bytes> picture(const ExposureSettings& settings, const EquirectSize& size,
                                         const std::stop_token& stop);

  private:
    const Exposer& m_exposer;
    mutable std::mutex m_mutex; ///< Guards all below.
    std::uint64_t m_current = 0;
    ExposureSettings m_shownSettings;
    EquirectSize m_shownSize;
    std::shared_ptr<const Bytes> m_shown;
};

/// The camera behind the HTTP server. It takes requests as JSON and gives answers as JSON. baseUrl:
/// "http://host:port", the beginning of file URLs. Threads: any.
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

    /// Makes the fault happen to the camera. Outages, which close its port, go to onOutage().
    void meet(const Fault& fault);

    /// Sets the function that closes the port. Call it before the first request.
    void onOutage(std::function<void(const Fault&)> outage) { m_outage = std::move(outage); }

    /// Switches the camera off and on: a running exposure is lost; ids and settings are forgotten.
    void restart();
    void fallAsleep();

    /// Begins a live preview, which ends the one before. Returns its number, or nothing while a picture is
    /// taken.
    std::optional<std::uint64_t> beginPreview();
    /// False after a picture, after a change of the mode or the format, and after another preview began.
    bool isPreviewing(std::uint64_t preview) const;
    /// Waits for the preview's rate, and returns its next picture. Returns null once the preview ended.
    std::shared_ptr<const Bytes> nextPreviewPicture(std::uint64_t preview);

    /// The file on the disk for the path of a URL. Returns nothing if there is no such file.
    std::optional<std::filesystem::path> fileOf(const std::string& urlPath) const;
    /// The same for camera.getImage of API level 1.
    std::optional<std::filesystem::path> imageOf(const Json& request) const;

    void setPosition(const Eigen::Vector3d& positionM);
    Eigen::Vector3d position() const;
    /// Carries the camera to the next place of a walk through the room. Returns false at its end.
    bool walkOn();
    int exposures() const;
    std::filesystem::path storageFolder() const;
    std::filesystem::path truthFile() const;

    /// Ends a running exposure and joins its thread.
    void stop();

    /// Waits so many seconds of the camera's time. Stop: returns at once.
    void pause(double seconds) const { pause(seconds, m_stop.get_token()); }

    void pause(double seconds, const std::stop_token& stop) const;

  private:
    enum class Phase { Countdown, Shooting };
    enum class Outcome { Running, Done, Failed };

    struct Capture {
        std::string id;
        Outcome outcome = Outcome::Running;
        OscCode code = OscCode::Unexpected;
        std::string failure; ///< A sentence.
        std::string urlPath;
        int answers = 0;
        bool isStuck = false; ///< It says "in progress" for ever.
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
    ExposureSettings settingsOfNewShot();
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

    mutable std::mutex m_mutex; ///< Guards all below.
    CameraStorage m_storage;
    std::filesystem::path m_truthFile;
    CameraOptions m_settings;
    Eigen::Vector3d m_position;
    std::optional<std::vector<Eigen::Vector3d>> m_walk; ///< What is left of it, the next place last.
    int m_standing = 0; ///< The first shot since the camera was moved; 0 before that shot.
    std::chrono::system_clock::duration m_clockOffset{0};
    std::chrono::minutes m_zone{0};
    std::vector<Capture> m_captures; ///< Oldest first.
    std::optional<Phase> m_phase;    ///< Of the running capture.
    std::stop_source m_countdown;
    CameraCondition m_condition;
    int m_level;
    OscSession m_session;
    Clock::TimePoint m_boot;
    int m_nextId = 0;
    int m_fingerprint = 0;
    int m_exposures = 0;
    std::jthread m_worker; ///< Last: it ends before what it uses.
};

} // namespace spherewalk::practice
