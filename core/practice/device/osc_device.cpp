// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/osc_device.h"

#include "device/fault_plan.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <utility>

namespace spherewalk::practice {

namespace {

constexpr double kBytesPerPixel = 0.31; ///< of a Theta V photo, to tell how many more there is room for

std::string serialNumber(std::uint64_t seed) {
    FixedRandom random(seed, 0x5e71a1);
    return "00" + std::to_string(100000 + random.next() % 900000);
}

int firstLevel(CameraModel model) {
    return model == CameraModel::ThetaV ? 2 : 1;
}

} // namespace

OscDevice::OscDevice(const PracticeCameraOptions& options, FaultPlan& faults, Clock& clock)
    : m_options(options),
      m_faults(faults),
      m_clock(clock),
      m_exposer(options),
      m_storage(options.storageFolder, options.seed),
      m_truthFile(options.truthFile.empty() ? m_storage.folder() / "truth.jsonl" : options.truthFile),
      m_settings(options.width, options.levelled),
      m_position(options.positionM),
      m_level(firstLevel(options.model)),
      m_session(clock, options.timeScale),
      m_boot(clock.now()) {
    // Differs from run to run of one storage, as ids of a rebooted camera do.
    FixedRandom random(options.seed, 0x1d + static_cast<std::uint64_t>(m_storage.files().size()));
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

void OscDevice::pause(double seconds, const std::stop_token& stop) const {
    double scaled = seconds * m_options.timeScale;
    {
        const std::scoped_lock lock(m_mutex);
        scaled *= m_condition.slowness;
    }
    if (scaled > 0) {
        m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(std::chrono::duration<double>(scaled)),
                      stop);
    }
}

Json OscDevice::info(int httpPort) const {
    const std::scoped_lock lock(m_mutex);
    const bool isV = m_options.model == CameraModel::ThetaV;
    Json body;
    body["manufacturer"] = "RICOH";
    body["model"] = isV ? "RICOH THETA V" : "RICOH THETA S";
    body["serialNumber"] = serialNumber(m_options.seed + m_condition.serialShift);
    if (isV) {
        body["_wlanMacAddress"] = "02:26:73:aa:bb:01";
        body["_bluetoothMacAddress"] = "02:26:73:aa:bb:02";
    }
    body["firmwareVersion"] = isV ? "3.82.1" : "01.62";
    body["supportUrl"] = "https://theta360.com/en/support/";
    body["gps"] = false;
    body["gyro"] = isV;
    body["uptime"] = std::chrono::duration_cast<std::chrono::seconds>(m_clock.now() - m_boot).count();
    body["api"] = {"/osc/info", "/osc/state", "/osc/checkForUpdates", "/osc/commands/execute",
                   "/osc/commands/status"};
    body["endpoints"] = {{"httpPort", httpPort}, {"httpUpdatesPort", httpPort}};
    if (m_options.model != CameraModel::LevelOne) {
        body["apiLevel"] = isV ? Json::array({2}) : Json::array({1, 2});
    }
    if (m_condition.saysUnknownThings) {
        body["_newThing"] = {{"a", {1, 2, nullptr}}};
    }
    return body;
}

std::string OscDevice::captureStatus() const {
    if (!m_phase) {
        return "idle";
    }
    return *m_phase == Phase::Countdown    ? "self-timer countdown"
           : m_condition.saysUnknownThings ? "hyper shooting"
                                           : "shooting";
}

Json OscDevice::errors() const {
    Json errors = Json::array();
    const auto add = [&](bool isSo, const char* code) {
        if (isSo) {
            errors.push_back(code);
        }
    };
    add(m_condition.isOutOfRoom, "NO_MEMORY");
    add(m_condition.isHot, "HIGH_TEMPERATURE");
    add(m_condition.isClockUnset, "NO_DATE_SETTING");
    add(m_condition.saysUnknownThings, "BRAND_NEW_TROUBLE");
    return errors;
}

Json OscDevice::state(const std::string& baseUrl) const {
    const std::scoped_lock lock(m_mutex);
    const auto& files = m_storage.files();
    Json state;
    const int percentUsed = m_exposures / 5;
    state["batteryLevel"] = m_condition.battery.value_or(std::max(0.05, 1.0 - 0.01 * percentUsed));
    state["_batteryState"] = m_condition.saysUnknownThings ? "wireless" : "disconnect";
    state["_captureStatus"] = captureStatus();
    state["_recordedTime"] = 0;
    state["_recordableTime"] = 0;
    state["_apiVersion"] = m_level;
    state["_cameraError"] = errors();
    if (m_level == 1) {
        state["sessionId"] = m_session.id();
        state["storageChanged"] = false;
        state["_latestFileUri"] = files.empty() ? "" : m_storage.uri(files.back().name);
    } else {
        state["storageUri"] = baseUrl + m_storage.urlFolder();
        state["_capturedPictures"] = 0;
        state["_latestFileUrl"] = files.empty() ? "" : baseUrl + m_storage.urlPath(files.back().name);
        state["_pluginRunning"] = m_condition.hasPlugin;
        state["_pluginWebServer"] = false;
    }
    if (m_condition.saysUnknownThings) {
        state["_boardTemp"] = 41;
        state["_newThing"] = Json::array({{{"b", "c"}}});
    }
    Json body;
    body["fingerprint"] = text("FIG_", m_fingerprint / 1000, m_fingerprint / 100 % 10,
                               m_fingerprint / 10 % 10, m_fingerprint % 10);
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

std::optional<std::filesystem::path> OscDevice::imageOf(const Json& request) const {
    const std::scoped_lock lock(m_mutex);
    if (m_level != 1 || !request.is_object() || !request.contains("parameters")) {
        return std::nullopt;
    }
    const Json& parameters = request["parameters"];
    const bool isWellFormed =
        parameters.is_object() && parameters.contains("fileUri") && !parameters.contains("sessionId");
    const Json uri = isWellFormed ? parameters["fileUri"] : Json();
    const auto file =
        uri.is_string() ? m_storage.find(m_storage.urlFolder() + uri.get<std::string>()) : std::nullopt;
    return file ? std::optional(m_storage.path(file->name)) : std::nullopt;
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
    if (m_condition.isFull) {
        return 0;
    }
    const double each = kBytesPerPixel * m_options.width * m_options.width / 2;
    return static_cast<std::uint64_t>(static_cast<double>(remainingBytes()) / each);
}

void OscDevice::setPosition(const Eigen::Vector3d& positionM) {
    const std::scoped_lock lock(m_mutex);
    m_standing = positionM == m_position ? m_standing : 0;
    m_position = positionM;
}

Eigen::Vector3d OscDevice::position() const {
    const std::scoped_lock lock(m_mutex);
    return m_position;
}

bool OscDevice::walkOn() {
    const std::scoped_lock lock(m_mutex);
    if (!m_walk) {
        m_walk = m_exposer.walk();
        std::ranges::reverse(*m_walk);
    }
    if (m_walk->empty()) {
        return false;
    }
    m_standing = 0;
    m_position = m_walk->back();
    m_walk->pop_back();
    return true;
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

void OscDevice::meet(const Fault& fault) {
    if (fault.kind == FaultKind::ExtraPhoto) {
        return takeExtraPhoto();
    }
    const std::scoped_lock lock(m_mutex);
    changed();
    switch (fault.kind) {
    case FaultKind::Battery:
        return loseCharge(fault.amount);
    case FaultKind::StorageFull:
        m_condition.isFull = true;
        break;
    case FaultKind::Hot:
        m_condition.isHot = true;
        break;
    case FaultKind::ResetSettings:
        m_settings.forgetExposure();
        break;
    case FaultKind::ClockUnset:
        m_condition.isClockUnset = true;
        m_clockOffset = std::chrono::system_clock::from_time_t(0) - m_clock.utc();
        break;
    case FaultKind::OtherSerial:
        ++m_condition.serialShift;
        break;
    case FaultKind::LevelOne:
        m_level = m_options.model == CameraModel::ThetaV ? 2 : 1;
        m_session.end();
        break;
    case FaultKind::Plugin:
        m_condition.hasPlugin = true;
        break;
    case FaultKind::RestartCounter:
        m_storage.restartNames();
        break;
    case FaultKind::UnknownValues:
        m_condition.saysUnknownThings = true;
        break;
    case FaultKind::Slow:
        m_condition.slowness = fault.amount;
        break;
    case FaultKind::NoMoreTrouble:
        m_condition = {};
        break;
    default:
        m_outage(fault);
    }
}

void OscDevice::loseCharge(double fraction) {
    m_condition.battery = std::max(0.0, m_condition.battery.value_or(1.0) - fraction);
    if (*m_condition.battery <= 0) {
        m_condition.battery = 1.0; // somebody changes it
        m_outage({FaultKind::Reboot, "", 0, 1, 0, 3});
    }
}

/// What happens to the camera at this point of an exposure. False if it is off now.
bool OscDevice::survives(std::string_view phase) {
    const std::vector<Fault> faults = m_faults.takeOfCamera(phase);
    for (const Fault& fault : faults) {
        meet(fault);
    }
    return std::none_of(faults.begin(), faults.end(),
                        [](const Fault& fault) { return fault.kind == FaultKind::Reboot; });
}

void OscDevice::takeExtraPhoto() {
    ExposureSettings settings;
    {
        const std::scoped_lock lock(m_mutex);
        settings = settingsOfNewShot();
    }
    ExposedPhoto photo = m_exposer.expose(settings, m_stop.get_token());
    photo.truth.byButton = true;
    const std::scoped_lock lock(m_mutex);
    store(photo, settings);
}

void OscDevice::restart() {
    std::jthread worker;
    {
        const std::scoped_lock lock(m_mutex);
        m_countdown.request_stop();
        worker = std::move(m_worker);
    }
    worker = {}; // ends, and is waited for
    const std::scoped_lock lock(m_mutex);
    m_captures.clear();
    m_phase.reset();
    m_condition.hasPlugin = false;
    m_boot = m_clock.now();
    forget();
}

void OscDevice::fallAsleep() {
    const std::scoped_lock lock(m_mutex);
    forget();
}

/// What neither a sleep nor a restart leaves.
void OscDevice::forget() {
    m_settings.forgetExposure();
    m_level = m_options.model == CameraModel::ThetaV ? 2 : 1;
    m_session.end();
    m_preview.end();
    changed();
}

} // namespace spherewalk::practice
