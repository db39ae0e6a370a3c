// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/event_log.h"
#include "http/scripted_server.h"
#include "manual_clock.h"

#include "spherewalk/base/json.h"
#include "spherewalk/camera/photo_download.h"

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::test {

/// The bytes of a JPEG's frame with this size in its header, padded to a length; nothing that decodes.
std::string jpegBytes(int width, int height, std::size_t sizeBytes = 4000);
/// Checks the markers and reads the size of what jpegBytes() makes.
camera::PhotoFacts checkJpeg(const std::filesystem::path& file);

/// A spherical camera of API level 2 for tests of the client: enough of the protocol to go through the
/// workflow, and a place for a fault before, instead of, or after each command. Its time is the manual clock.
class TestCamera {
  public:
    using Fault = std::function<ServerAction(const std::function<ServerAction()>& normal)>;

    struct File {
        std::string path;
        std::string bytes;
        std::size_t listedSize = 0;
        std::string takenAt = {}; ///< by the camera's clock
    };

    TestCamera(ManualClock& clock, EventLog& log);

    std::string address() const { return m_server.address(); }

    const ScriptedServer& server() const { return m_server; }

    /// The next requests of this command (its name, or a path) meet these faults, one each.
    void fault(const std::string& command, Fault fault, int times = 1);

    void clearFaults();

    int count(const std::string& command) const;
    void addFile(const std::string& name, std::string bytes = jpegBytes(2048, 1024));
    /// As if somebody pressed the camera's button.
    void addFile();
    /// Forgets the running command, as a restart does; a photo not yet written is lost.
    void restart();

    /// Of the command that is being answered.
    const Json& lastOptions() const { return m_lastOptions; }

    // Knobs, to be set between requests.
    std::string serial = "00123456";
    std::string model = "RICOH THETA V";
    std::string apiLevels = "[2]";
    std::chrono::milliseconds processing{3'500};
    std::string hostOfUrls = "http://192.168.1.1";
    std::string captureStatus = "idle";
    bool showsShooting = true; ///< whether the status leaves "idle" during a shot
    bool tellsFileUrl = true;
    bool isStuck = false;
    bool tellsEndOnce = false;
    bool tellsTimes = true; ///< whether it has a clock, and lists when files were taken
    Json cameraErrors = Json::array();
    double battery = 0.67;
    bool isPluginRunning = false;
    Json options;
    std::vector<File> files; ///< oldest first
    std::string nextPhoto = jpegBytes(2048, 1024);
    int uptimeS = 100;

  private:
    ServerAction handle(const ServerRequest& request);
    ServerAction respond(const ServerRequest& request, const std::string& command, const Json& message);
    ServerAction takePicture();
    ServerAction status(const Json& message);
    ServerAction listFiles(const Json& parameters);
    ServerAction getOptions(const Json& parameters);
    ServerAction setOptions(const Json& parameters);
    ServerAction state();
    ServerAction file(const std::string& path);
    void passTime();
    std::string time() const;
    std::string urlOf(const File& file) const;

    struct Running {
        std::string id;
        Clock::TimePoint end;
        std::string begunAt;
        std::string fileUrl; ///< once written
        bool isTold = false;
    };

    mutable std::recursive_mutex m_mutex; // recursive, as faults change the camera
    ManualClock& m_clock;
    EventLog& m_log;
    std::map<std::string, std::deque<Fault>> m_faults;
    std::map<std::string, int> m_counts;
    std::optional<Running> m_running;
    Json m_lastOptions = Json::object();
    int m_nextId = 306;
    int m_nextFile = 48;
    ScriptedServer m_server; // last: its thread uses the others
};

} // namespace spherewalk::test
