// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_device.h"

#include "prng.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr double kBytesPerPixel = 0.31; ///< of a Theta V photo, to tell how many more there is room for
constexpr std::size_t kMaxDeleted = 128;
constexpr std::size_t kKeptCaptures = 64;

const Json& noParameters() {
    static const Json none = Json::object();
    return none;
}

std::string serialNumber(std::uint64_t seed) {
    Prng random(seed, 0x5e71a1);
    return "00" + std::to_string(100000 + random.next() % 900000);
}

/// A parameter that must be there.
const Json& required(const Json& parameters, const char* name) {
    if (!parameters.contains(name)) {
        throw OscError(OscCode::MissingParameter);
    }
    return parameters[name];
}

std::int64_t wholeNumber(const Json& value, std::int64_t least, std::int64_t most) {
    const bool isWhole = value.is_number_integer() ||
                         (value.is_number() && value.get<double>() == std::floor(value.get<double>()) &&
                          std::abs(value.get<double>()) < 1e15);
    const std::int64_t number = isWhole ? value.get<std::int64_t>() : least - 1;
    if (number < least || number > most) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return number;
}

std::string word(const Json& value, std::initializer_list<std::string_view> known) {
    const std::string spelled = value.is_string() ? value.get<std::string>() : std::string();
    if (std::find(known.begin(), known.end(), spelled) == known.end()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return spelled;
}

Json inProgress(std::string_view id) {
    Json body;
    body["name"] = "camera.takePicture";
    body["id"] = id;
    body["state"] = "inProgress";
    body["progress"] = {{"completion", 0.0}};
    return body;
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

OscDevice::Capture* OscDevice::capture(const std::string& id) {
    const auto found =
        std::find_if(m_captures.begin(), m_captures.end(), [&](const Capture& one) { return one.id == id; });
    return found == m_captures.end() ? nullptr : &*found;
}

OscReply OscDevice::results(std::string_view command, Json results) const {
    Json body;
    body["name"] = command;
    body["state"] = "done";
    if (!results.is_null()) {
        body["results"] = std::move(results);
    }
    return {200, body};
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
            return listFiles(parameters, baseUrl);
        }
        if (command == "camera.delete") {
            return deleteFiles(parameters);
        }
        if (command == "camera.reset") {
            m_settings.reset();
            changed();
            return results(command);
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

OscReply OscDevice::takePicture() {
    if (m_settings.value("captureMode") != "image") {
        throw OscError(OscCode::DisabledCommand);
    }
    if (m_phase) {
        throw OscError(m_options.whenBusy == PracticeCameraOptions::WhenBusy::DeviceBusy ? OscCode::DeviceBusy
                       : m_options.whenBusy == PracticeCameraOptions::WhenBusy::ServiceUnavailable
                           ? OscCode::ServiceUnavailable
                           : OscCode::DisabledCommand);
    }
    if (remainingPictures() == 0) {
        m_cameraError = "NO_MEMORY";
        changed();
        throw OscError(OscCode::DisabledCommand);
    }
    if (m_stop.stop_requested()) {
        throw OscError(OscCode::ServiceUnavailable);
    }
    const ExposureSettings settings = settingsNow(m_storage.takeShotNumber());
    const std::string id = std::to_string(m_nextId++);
    while (m_captures.size() >= kKeptCaptures) {
        m_captures.erase(m_captures.begin());
    }
    m_captures.emplace_back().id = id;
    const double countdown = m_settings.value("exposureDelay").get<double>();
    m_phase = countdown > 0 ? Phase::Countdown : Phase::Shooting;
    m_countdown = {};
    m_preview.end();
    changed();
    const double busy = busySeconds(settings);
    m_worker = std::jthread([this, id, settings, countdown, busy](const std::stop_token& stop) {
        run(stop, id, settings, countdown, busy);
    });
    return {200, inProgress(id)};
}

ExposureSettings OscDevice::settingsNow(int shot) const {
    ExposureSettings settings;
    settings.shot = shot;
    settings.nominalPositionM = m_position;
    settings.time = now();
    settings.levelled = m_settings.value("_topBottomCorrection") != "Disapply";
    settings.program = m_settings.value("exposureProgram").get<int>();
    settings.exposureTimeS = m_settings.value("shutterSpeed").get<double>();
    settings.isoSpeed = m_settings.value("iso").get<int>();
    settings.exposureBias = m_settings.value("exposureCompensation").get<double>();
    return settings;
}

double OscDevice::busySeconds(const ExposureSettings& settings) const {
    Prng random(m_options.seed, static_cast<std::uint64_t>(settings.shot));
    const Json& filter = m_settings.value("_filter");
    const double plain = filter == "hdr" || filter == "Hh hdr" ? 9 : filter == "Noise Reduction" ? 8 : 3.5;
    return plain + random.uniform(-0.5, 0.5) + 2 * settings.exposureTimeS;
}

void OscDevice::run(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
                    double countdownS, double busyS) {
    try {
        if (countdownS > 0) {
            std::stop_token countdown;
            {
                const std::scoped_lock lock(m_mutex);
                countdown = m_countdown.get_token();
            }
            const std::chrono::duration<double> wait(countdownS * m_options.timeScale);
            m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(wait), countdown);
            if (countdown.stop_requested()) {
                finish(id, Outcome::Failed, OscCode::CanceledShooting, "The self-timer was stopped.");
                return;
            }
            const std::scoped_lock lock(m_mutex);
            m_phase = Phase::Shooting;
            changed();
        }
        shoot(stop, id, settings, busyS);
    } catch (const Error& failure) {
        finish(id, Outcome::Failed, OscCode::Unexpected, failure.sentence());
    } catch (const std::exception& failure) {
        finish(id, Outcome::Failed, OscCode::Unexpected, failure.what());
    }
}

void OscDevice::shoot(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
                      double busyS) {
    const Clock::TimePoint begin = m_clock.now();
    const auto waitUntil = [&](double share) {
        const std::chrono::duration<double> due(share * busyS * m_options.timeScale);
        const std::chrono::duration<double> left = due - (m_clock.now() - begin);
        if (left.count() > 0) {
            m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(left), stop);
        }
        throwIfStopped(stop);
    };
    ExposedPhoto photo = m_exposer.expose(settings, stop);
    waitUntil(0.8);
    {
        const std::scoped_lock lock(m_mutex);
        photo.truth.file = CameraStorage::fileName(settings.shot);
        photo.truth.urlPath = m_storage.urlPath(photo.truth.file);
        TruthFile(m_truthFile).append(photo.truth); // before anybody can see the file
        m_storage.add(photo.truth.file, photo.jpeg, settings.time);
        if (Capture* own = capture(id)) { // not forgotten
            own->urlPath = photo.truth.urlPath;
        }
        ++m_exposures;
        changed();
    }
    waitUntil(1);
    finish(id, Outcome::Done, OscCode::Unexpected, {});
}

void OscDevice::finish(const std::string& id, Outcome outcome, OscCode code, const std::string& failure) {
    const std::scoped_lock lock(m_mutex);
    if (Capture* own = capture(id)) {
        own->outcome = outcome;
        own->code = code;
        own->failure = failure;
    }
    m_phase.reset();
    changed();
}

OscReply OscDevice::status(const std::string& body, const std::string& baseUrl) {
    std::string id;
    try {
        const Json request = parseJson(body, "the request");
        if (!request.is_object() || !request.contains("id")) {
            return refusal("unknown", OscCode::MissingParameter);
        }
        id = request["id"].is_string() ? request["id"].get<std::string>() : request["id"].dump();
    } catch (const Error&) { // not JSON: the camera refuses it as such
        return refusal("unknown", OscCode::InvalidParameterValue);
    }
    const std::scoped_lock lock(m_mutex);
    Capture* const found = capture(id);
    if (found == nullptr) {
        return refusal("unknown", OscCode::InvalidParameterValue);
    }
    const Capture asked = *found;
    if (asked.outcome == Outcome::Running) {
        return {200, inProgress(id)};
    }
    if (m_options.doneAnswers > 0 && ++found->answers >= m_options.doneAnswers) {
        std::erase_if(m_captures, [&](const Capture& one) { return one.id == id; });
    }
    if (asked.outcome == Outcome::Done) {
        return results("camera.takePicture", Json{{"fileUrl", baseUrl + asked.urlPath}});
    }
    OscReply reply = refusal("camera.takePicture", asked.code);
    if (asked.code == OscCode::Unexpected) {
        reply.body["error"]["message"] = asked.failure;
    }
    return reply;
}

void OscDevice::forgetIds() {
    const std::scoped_lock lock(m_mutex);
    m_captures.clear();
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
    return results("camera.getOptions", Json{{"options", m_settings.get(names, readOnly)}});
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
    return results("camera.setOptions");
}

Json OscDevice::entry(const StoredFile& file, bool detail, const std::string& baseUrl) const {
    Json entry;
    entry["name"] = file.name;
    entry["fileUrl"] = baseUrl + m_storage.urlPath(file.name);
    entry["size"] = file.sizeBytes;
    if (!detail) {
        entry["dateTime"] = exifTime(file.time);
        return entry;
    }
    entry["dateTimeZone"] = exifTime(file.time) + zoneText(file.time.zone);
    entry["width"] = file.width;
    entry["height"] = file.height;
    entry["isProcessed"] = true;
    entry["previewUrl"] = "";
    entry["_projectionType"] = "Equirectangular";
    return entry;
}

OscReply OscDevice::listFiles(const Json& parameters, const std::string& baseUrl) const {
    constexpr std::array<std::string_view, 7> kKnown = {
        "fileType", "entryCount", "maxThumbSize", "startPosition", "_startFileUrl", "_detail", "_sort"};
    for (const auto& parameter : parameters.items()) {
        if (std::find(kKnown.begin(), kKnown.end(), parameter.key()) == kKnown.end()) {
            throw OscError(OscCode::InvalidParameterName);
        }
    }
    const std::string type = word(required(parameters, "fileType"), {"all", "image", "video"});
    constexpr std::int64_t kMany = 1'000'000'000;
    const std::int64_t count = wholeNumber(required(parameters, "entryCount"), 0, kMany);
    const std::int64_t thumb = wholeNumber(required(parameters, "maxThumbSize"), 0, 640);
    if (thumb != 0 && thumb != 640) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    if (parameters.contains("_detail") && !parameters["_detail"].is_boolean()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    const bool detail = !parameters.contains("_detail") || parameters["_detail"].get<bool>();
    const bool newestFirst =
        !parameters.contains("_sort") || word(parameters["_sort"], {"newest", "oldest"}) == "newest";

    std::vector<StoredFile> files;
    if (type != "video") {
        files = m_storage.files();
    }
    if (newestFirst) {
        std::reverse(files.begin(), files.end());
    }
    std::size_t begin = 0;
    if (parameters.contains("startPosition")) {
        begin = static_cast<std::size_t>(wholeNumber(parameters["startPosition"], 0, kMany));
    } else if (parameters.contains("_startFileUrl")) {
        const Json& url = parameters["_startFileUrl"];
        const auto start = url.is_string() ? m_storage.find(url.get<std::string>()) : std::nullopt;
        if (!start) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        while (begin < files.size() && files[begin].name != start->name) {
            ++begin;
        }
    }
    Json entries = Json::array();
    for (std::size_t i = begin; i < files.size() && static_cast<std::int64_t>(entries.size()) < count; ++i) {
        entries.push_back(entry(files[i], detail, baseUrl));
    }
    return results("camera.listFiles", Json{{"entries", entries}, {"totalEntries", files.size()}});
}

OscReply OscDevice::deleteFiles(const Json& parameters) {
    const Json& urls = required(parameters, "fileUrls");
    if (!urls.is_array() || urls.empty()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    if (urls.size() > kMaxDeleted) {
        throw OscError(OscCode::TooManyParameters);
    }
    std::vector<std::string> names;
    const bool isAll = urls.size() == 1 && (urls[0] == "all" || urls[0] == "image");
    if (isAll) {
        for (const StoredFile& file : m_storage.files()) {
            names.push_back(file.name);
        }
    } else if (!(urls.size() == 1 && urls[0] == "video")) {
        for (const Json& url : urls) {
            const auto file = url.is_string() ? m_storage.find(url.get<std::string>()) : std::nullopt;
            if (!file) {
                throw OscError(OscCode::InvalidParameterValue); // all or nothing
            }
            names.push_back(file->name);
        }
    }
    for (const std::string& name : names) {
        m_storage.remove(name);
    }
    m_cameraError.clear();
    changed();
    return results("camera.delete");
}

OscReply OscDevice::stopSelfTimer() {
    if (m_phase != Phase::Countdown) {
        throw OscError(OscCode::DisabledCommand);
    }
    m_countdown.request_stop();
    return results("camera._stopSelfTimer");
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
