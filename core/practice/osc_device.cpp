// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_device.h"

#include "file_commands.h"
#include "osc_parameters.h"
#include "prng.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr double kBytesPerPixel = 0.31; ///< of a Theta V photo, to tell how many more there is room for

const Json& noParameters() {
    static const Json none = Json::object();
    return none;
}

std::string serialNumber(std::uint64_t seed) {
    Prng random(seed, 0x5e71a1);
    return "00" + std::to_string(100000 + random.next() % 900000);
}

} // namespace

OscDevice::OscDevice(const PracticeCameraOptions& options, Clock& clock)
    : m_options(options),
      m_clock(clock),
      m_exposer(options),
      m_boot(clock.now()),
      m_storage(options.storageFolder, options.seed),
      m_truthFile(options.truthFile.empty() ? m_storage.folder() / "truth.jsonl" : options.truthFile),
      m_settings(options.width, options.levelled),
      m_position(options.positionM) {
    // Differs from run to run of one storage, as ids of a rebooted camera do.
    Prng random(options.seed, 0x1d + static_cast<std::uint64_t>(m_storage.files().size()));
    m_nextId = static_cast<int>(100 + random.next() % 9000);
    m_fingerprint = static_cast<int>(random.next() % 50);
}

OscDevice::~OscDevice() {
    stop();
}

void OscDevice::stop() {
    m_stop.request_stop();
    std::jthread worker;
    {
        const std::scoped_lock lock(m_mutex);
        m_countdown.request_stop();
        worker = std::move(m_worker);
    }
    worker.request_stop();
}

void OscDevice::pause(double seconds) const {
    const double scaled = seconds * m_options.timeScale;
    if (scaled > 0) {
        m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(std::chrono::duration<double>(scaled)),
                      m_stop.get_token());
    }
}

Json OscDevice::info(int httpPort) const {
    Json body;
    body["manufacturer"] = "RICOH";
    body["model"] = "RICOH THETA V";
    body["serialNumber"] = serialNumber(m_options.seed);
    body["_wlanMacAddress"] = "02:26:73:aa:bb:01";
    body["_bluetoothMacAddress"] = "02:26:73:aa:bb:02";
    body["firmwareVersion"] = "3.82.1";
    body["supportUrl"] = "https://theta360.com/en/support/";
    body["gps"] = false;
    body["gyro"] = true;
    body["uptime"] = std::chrono::duration_cast<std::chrono::seconds>(m_clock.now() - m_boot).count();
    body["api"] = {"/osc/info", "/osc/state", "/osc/checkForUpdates", "/osc/commands/execute",
                   "/osc/commands/status"};
    body["endpoints"] = {{"httpPort", httpPort}, {"httpUpdatesPort", httpPort}};
    body["apiLevel"] = Json::array({2});
    return body;
}

Json OscDevice::state(const std::string& baseUrl) const {
    const std::scoped_lock lock(m_mutex);
    const auto& files = m_storage.files();
    Json state;
    state["batteryLevel"] = std::max(0.05, 1.0 - 0.01 * (m_exposures / 5));
    state["_batteryState"] = "disconnect";
    state["storageUri"] = baseUrl + m_storage.urlFolder();
    state["_captureStatus"] = !m_phase                       ? "idle"
                              : *m_phase == Phase::Countdown ? "self-timer countdown"
                                                             : "shooting";
    state["_recordedTime"] = 0;
    state["_recordableTime"] = 0;
    state["_capturedPictures"] = 0;
    state["_latestFileUrl"] = files.empty() ? "" : baseUrl + m_storage.urlPath(files.back().name);
    state["_apiVersion"] = 2;
    state["_pluginRunning"] = false;
    state["_pluginWebServer"] = false;
    state["_cameraError"] = m_cameraError.empty() ? Json::array() : Json::array({m_cameraError});
    Json body;
    body["fingerprint"] = text("FIG_", fixed(m_fingerprint / 1000, 0), fixed(m_fingerprint / 100 % 10, 0),
                               fixed(m_fingerprint / 10 % 10, 0), fixed(m_fingerprint % 10, 0));
    body["state"] = state;
    return body;
}

OscReply OscDevice::checkForUpdates(const std::string& body) const {
    try {
        const Json request = parseJson(body, "the request");
        if (!request.is_object() || !request.contains("stateFingerprint")) {
            return refusal("unknown", OscCode::MissingParameter);
        }
    } catch (const Error&) { // not JSON: the camera refuses it as such
        return refusal("unknown", OscCode::InvalidParameterValue);
    }
    Json reply;
    reply["stateFingerprint"] = state("")["fingerprint"];
    return {200, reply};
}

OscReply OscDevice::execute(const Json& request, const std::string& baseUrl) {
    const std::string command = request.is_object() && request.contains("name") && request["name"].is_string()
                                    ? request["name"].get<std::string>()
                                    : "unknown";
    try {
        const Json& parameters =
            request.is_object() && request.contains("parameters") ? request["parameters"] : noParameters();
        if (!parameters.is_object()) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        const std::scoped_lock lock(m_mutex);
        if (command == "camera.takePicture") {
            return takePicture();
        }
        if (command == "camera.getOptions") {
            return getOptions(parameters);
        }
        if (command == "camera.setOptions") {
            return setOptions(parameters);
        }
        if (command == "camera.listFiles") {
            return done(command, listedFiles(m_storage, parameters, baseUrl));
        }
        if (command == "camera.delete") {
            deleteFiles(m_storage, parameters);
            m_cameraError.clear();
            changed();
            return done(command);
        }
        if (command == "camera.reset") {
            m_settings.reset();
            changed();
            return done(command);
        }
        if (command == "camera._stopSelfTimer") {
            return stopSelfTimer();
        }
        throw OscError(OscCode::UnknownCommand);
    } catch (const OscError& error) {
        return refusal(error.code() == OscCode::UnknownCommand ? "unknown" : command, error.code());
    } catch (const Error& failure) {
        OscReply reply = refusal(command, OscCode::Unexpected);
        reply.body["error"]["message"] = failure.sentence();
        return reply;
    }
}

std::optional<std::uint64_t> OscDevice::beginPreview() {
    const std::scoped_lock lock(m_mutex);
    return m_phase ? std::nullopt : std::optional(m_preview.begin());
}

bool OscDevice::isPreviewing(std::uint64_t preview) const {
    return !m_stop.stop_requested() && m_preview.isCurrent(preview);
}

std::shared_ptr<const Bytes> OscDevice::nextPreviewPicture(std::uint64_t preview) {
    ExposureSettings settings;
    Json format;
    {
        const std::scoped_lock lock(m_mutex);
        settings = settingsNow(m_storage.nextShotNumber());
        format = m_settings.value("previewFormat");
    }
    // However fast the camera's time runs, who looks on needs no more pictures.
    const double period = std::max(1.0, m_options.timeScale) / format["framerate"].get<double>();
    m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(std::chrono::duration<double>(period)),
                  m_stop.get_token());
    if (!isPreviewing(preview)) {
        return nullptr;
    }
    const EquirectSize size{format["width"].get<int>(), format["height"].get<int>()};
    return m_preview.picture(settings, size, m_stop.get_token());
}

OscReply OscDevice::getOptions(const Json& parameters) const {
    const Json& names = required(parameters, "optionNames");
    if (!names.is_array() || names.size() > 256) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    const ZonedTime time = now();
    const std::map<std::string, Json> readOnly = {
        {"aperture", 2.0},
        {"apertureSupport", Json::array({2.0})},
        {"_latestEnabledExposureDelayTime", 5},
        {"remainingPictures", remainingPictures()},
        {"remainingSpace", remainingBytes()},
        {"totalSpace", m_options.storageBytes},
        {"remainingVideoSeconds", remainingBytes() / 7'000'000},
        {"dateTimeZone", exifTime(time) + zoneText(time.zone)},
        {"_networkType", "AP"},
    };
    return done("camera.getOptions", Json{{"options", m_settings.get(names, readOnly)}});
}

OscReply OscDevice::setOptions(const Json& parameters) {
    const Json& options = required(parameters, "options");
    if (!options.is_object() || options.empty()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    m_settings.set(options);
    if (options.contains("captureMode") || options.contains("previewFormat")) {
        m_preview.end();
    }
    if (options.contains("dateTimeZone")) {
        const ZonedTime set = *parseDateTimeZone(options["dateTimeZone"].get<std::string>());
        m_clockOffset = set.utc - m_clock.utc();
        m_zone = set.zone;
    }
    changed();
    return done("camera.setOptions");
}

std::optional<std::filesystem::path> OscDevice::fileOf(const std::string& urlPath) const {
    const std::scoped_lock lock(m_mutex);
    const auto file = m_storage.find(urlPath);
    return file ? std::optional(m_storage.path(file->name)) : std::nullopt;
}

ZonedTime OscDevice::now() const {
    return {m_clock.utc() + m_clockOffset, m_zone};
}

std::uint64_t OscDevice::remainingBytes() const {
    const std::uint64_t used = m_storage.usedBytes();
    return used < m_options.storageBytes ? m_options.storageBytes - used : 0;
}

std::uint64_t OscDevice::remainingPictures() const {
    const double each = kBytesPerPixel * m_options.width * m_options.width / 2;
    return static_cast<std::uint64_t>(static_cast<double>(remainingBytes()) / each);
}

void OscDevice::setPosition(const Eigen::Vector3d& positionM) {
    const std::scoped_lock lock(m_mutex);
    m_position = positionM;
}

Eigen::Vector3d OscDevice::position() const {
    const std::scoped_lock lock(m_mutex);
    return m_position;
}

int OscDevice::exposures() const {
    const std::scoped_lock lock(m_mutex);
    return m_exposures;
}

std::filesystem::path OscDevice::storageFolder() const {
    return m_storage.folder();
}

std::filesystem::path OscDevice::truthFile() const {
    return m_truthFile;
}

} // namespace spherewalk::practice
