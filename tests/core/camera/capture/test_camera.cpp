// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/test_camera.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

namespace spherewalk::test {

namespace {

constexpr std::string_view kFolder = "/files/150100525831424d42079d18e0b6c300/100RICOH/";

std::string bigEndian(int number) {
    return {static_cast<char>(number >> 8), static_cast<char>(number & 255)};
}

ServerAction done(const std::string& command, const Json& results) {
    return answerJson(Json{{"name", command}, {"state", "done"}, {"results", results}}.dump());
}

} // namespace

std::string jpegBytes(int width, int height, std::size_t sizeBytes) {
    std::string bytes = "\xff\xd8\xff\xc0";
    bytes += bigEndian(17) + '\x08' + bigEndian(height) + bigEndian(width) + '\x03';
    bytes.resize(sizeBytes - 2, 'x');
    return bytes + "\xff\xd9";
}

camera::PhotoFacts checkJpeg(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file);
    if (bytes.size() < 16 || bytes[2] != 0xff || bytes[3] != 0xc0) {
        throw Error(ErrorKind::Corrupt, text("The file ", file.string(), " is not a complete JPEG."));
    }
    return {bytes[9] * 256 + bytes[10], bytes[7] * 256 + bytes[8]};
}

TestCamera::TestCamera(ManualClock& clock, EventLog& log)
    : options(Json::parse(R"({
        "captureMode": "image", "fileFormat": {"type":"jpeg","width":5376,"height":2688},
        "fileFormatSupport": [{"type":"jpeg","width":5376,"height":2688},{"type":"mp4","width":9000,"height":4500}],
        "exposureDelay": 0, "shutterSpeed": 0, "_filter": "off", "remainingPictures": 4386,
        "sleepDelay": 180, "offDelay": 64800})")),
      m_clock(clock),
      m_log(log),
      m_server([this](const ServerRequest& request) { return handle(request); }) {
}

void TestCamera::fault(const std::string& command, Fault fault, int times) {
    const std::scoped_lock lock(m_mutex);
    m_faults[command].insert(m_faults[command].end(), static_cast<std::size_t>(times), std::move(fault));
}

void TestCamera::clearFaults() {
    const std::scoped_lock lock(m_mutex);
    m_faults.clear();
}

int TestCamera::count(const std::string& command) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_counts.find(command);
    return found == m_counts.end() ? 0 : found->second;
}

void TestCamera::addFile(const std::string& name, std::string bytes) {
    const std::scoped_lock lock(m_mutex);
    const std::size_t size = bytes.size();
    files.push_back({std::string(kFolder) + name, std::move(bytes), size, time()});
}

void TestCamera::addFile() {
    const std::scoped_lock lock(m_mutex);
    addFile(text("R00100", m_nextFile++, ".JPG"), nextPhoto);
}

void TestCamera::restart() {
    const std::scoped_lock lock(m_mutex);
    m_running.reset();
    uptimeS = 5;
}

std::string TestCamera::urlOf(const File& file) const {
    return hostOfUrls + file.path;
}

/// By a clock that goes with the computer's own at first, one zone further east.
std::string TestCamera::time() const {
    using namespace std::chrono;
    const auto local = floor<seconds>(system_clock::time_point(sys_days(year(2026) / 3 / 4)) +
                                      m_clock.now().time_since_epoch());
    const auto day = floor<days>(local);
    const year_month_day date(day);
    const hh_mm_ss clock(local - day);
    const auto two = [](auto number) { return text(number < 10 ? "0" : "", number); };
    return text(static_cast<int>(date.year()), ":", two(static_cast<unsigned>(date.month())), ":",
                two(static_cast<unsigned>(date.day())), " ", two(clock.hours().count()), ":",
                two(clock.minutes().count()), ":", two(clock.seconds().count()), "+01:00");
}

/// Writes the photo of the running command when its time has come.
void TestCamera::passTime() {
    if (m_running && m_running->fileUrl.empty() && !isStuck && m_clock.now() >= m_running->end) {
        addFile();
        files.back().takenAt = m_running->begunAt;
        m_running->fileUrl = urlOf(files.back());
    }
}

ServerAction TestCamera::handle(const ServerRequest& request) {
    const std::scoped_lock lock(m_mutex);
    passTime();
    Json message = request.body.empty() ? Json::object() : Json::parse(request.body);
    const std::string command =
        request.path == "/osc/commands/execute" ? message.value("name", "") : request.path;
    ++m_counts[command];
    m_log.add(command);
    m_lastOptions = message.value("parameters", Json::object()).value("options", Json::object());
    const auto normal = [&] { return respond(request, command, message); };
    if (auto& faults = m_faults[command]; !faults.empty()) {
        const Fault fault = faults.front();
        faults.pop_front();
        return fault(normal);
    }
    return normal();
}

ServerAction TestCamera::respond(const ServerRequest& request, const std::string& command,
                                 const Json& message) {
    const Json parameters = message.value("parameters", Json::object());
    if (command == "/osc/info") {
        return answerJson(text(R"({"manufacturer":"RICOH","model":")", model, R"(","serialNumber":")", serial,
                               R"(","firmwareVersion":"3.82.1","uptime":)", ++uptimeS, R"(,"apiLevel":)",
                               apiLevels, "}"));
    }
    if (command == "/osc/state") {
        return state();
    }
    if (command == "/osc/commands/status") {
        return status(message);
    }
    if (command == "camera.takePicture") {
        return takePicture();
    }
    if (command == "camera.listFiles") {
        return listFiles(parameters);
    }
    if (command == "camera.getOptions") {
        return getOptions(parameters);
    }
    if (command == "camera.setOptions") {
        return setOptions(parameters);
    }
    return request.method == "GET" ? file(request.path) : answerOsc("unknownCommand", 400);
}

ServerAction TestCamera::takePicture() {
    if (options["captureMode"] != "image") {
        return answerOsc("disabledCommand", 403);
    }
    m_running = Running{text(m_nextId++), m_clock.now() + processing, time(), {}, false};
    return answerJson(text(R"({"name":"camera.takePicture","id":")", m_running->id,
                           R"(","state":"inProgress","progress":{"completion":0.0}})"));
}

ServerAction TestCamera::status(const Json& message) {
    const bool isKnown = m_running && message.value("id", "") == m_running->id;
    if (!isKnown || (tellsEndOnce && m_running->isTold)) {
        return answerOsc("invalidParameterValue", 400);
    }
    if (m_running->fileUrl.empty()) {
        return answerJson(text(R"({"name":"camera.takePicture","id":")", m_running->id,
                               R"(","state":"inProgress","progress":{"completion":0}})"));
    }
    m_running->isTold = true;
    Json results = Json::object();
    if (tellsFileUrl) {
        results["fileUrl"] = m_running->fileUrl;
    }
    return done("camera.takePicture", results);
}

ServerAction TestCamera::listFiles(const Json& parameters) {
    Json entries = Json::array();
    const auto start = parameters["startPosition"].get<std::size_t>();
    const auto count = parameters["entryCount"].get<std::size_t>();
    for (std::size_t i = start; i < files.size() && i < start + count; ++i) {
        const File& entry = files[files.size() - 1 - i];
        entries.push_back({{"name", entry.path.substr(kFolder.size())},
                           {"fileUrl", urlOf(entry)},
                           {"size", entry.listedSize},
                           {"_somethingNew", {1, 2}}});
        if (tellsTimes) {
            entries.back()["dateTimeZone"] = entry.takenAt;
        }
    }
    return done("camera.listFiles", {{"entries", entries}, {"totalEntries", files.size()}});
}

ServerAction TestCamera::getOptions(const Json& parameters) {
    Json values = Json::object();
    for (const Json& name : parameters["optionNames"]) {
        if (tellsTimes && name == "dateTimeZone" && !options.contains("dateTimeZone")) {
            values["dateTimeZone"] = time();
            continue;
        }
        if (!options.contains(name.get<std::string>())) {
            return answerOsc("invalidParameterName", 400);
        }
        values[name.get<std::string>()] = options[name.get<std::string>()];
    }
    return done("camera.getOptions", {{"options", values}});
}

ServerAction TestCamera::setOptions(const Json& parameters) {
    for (const auto& [name, value] : parameters["options"].items()) {
        options[name] = value;
    }
    return answerJson(R"({"name":"camera.setOptions","state":"done"})");
}

ServerAction TestCamera::state() {
    const bool isShooting = showsShooting && m_running && m_running->fileUrl.empty();
    const Json state{{"batteryLevel", battery},
                     {"_batteryState", "disconnect"},
                     {"_captureStatus", isShooting ? "shooting" : captureStatus},
                     {"_latestFileUrl", files.empty() ? "" : urlOf(files.back())},
                     {"_apiVersion", 2},
                     {"_pluginRunning", isPluginRunning},
                     {"_cameraError", cameraErrors}};
    return answerJson(Json{{"fingerprint", "FIG_0012"}, {"state", state}}.dump());
}

ServerAction TestCamera::file(const std::string& path) {
    for (const File& candidate : files) {
        if (candidate.path == path) {
            return {httpAnswer(200, "image/jpeg", candidate.bytes)};
        }
    }
    return answerOsc("notFound", 404);
}

} // namespace spherewalk::test
