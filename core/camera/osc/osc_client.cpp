// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/osc_client.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr const char* kExecutePath = "/osc/commands/execute";
constexpr const char* kStatusPath = "/osc/commands/status";
constexpr int kPageEntries = 50;
constexpr int kMaxListedFiles = 20'000;

/// An answer after the rules that hold for all: what the camera said decides, then the HTTP status.
struct Answer {
    Json json = Json::object();
    OscErrorCode error = OscErrorCode::None;
    std::string errorMessage;
    bool isFromCamera = true; ///< it has JSON
};

bool looksLikeWebPage(const HttpResponse& response) {
    const std::size_t first = response.body.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return response.contentType.starts_with("text/html") ||
           (first != std::string::npos && response.body[first] == '<');
}

Answer answerWithoutJson(const HttpResponse& response, const Endpoint& endpoint) {
    const OscErrorCode code = oscErrorCodeOfStatus(response.status);
    const bool isTemporary = code == OscErrorCode::ServiceUnavailable || code == OscErrorCode::Unauthorized;
    if (looksLikeWebPage(response) && !isTemporary) {
        throw notACamera(endpoint.name(), "it sent a web page");
    }
    if (response.status >= 300 && response.status < 400) {
        throw notACamera(endpoint.name(), "it redirects to another page");
    }
    if (code == OscErrorCode::None) {
        throw Error(ErrorKind::Corrupt,
                    text("The camera at ", endpoint.name(), " sent ",
                         response.body.empty() ? "an empty answer" : "an answer that is not valid JSON",
                         "; switch it off and on if this persists."),
                    printable(response.body));
    }
    return {Json::object(), code, text("HTTP status ", response.status), false};
}

Answer readAnswer(const HttpResponse& response, const Endpoint& endpoint) {
    Answer answer;
    try {
        answer.json = parseJson(response.body, "the camera's answer");
    } catch (const Error&) {
        // Not JSON: whether that is an error page, a refusal or a defect is told by the rest of the answer.
        return answerWithoutJson(response, endpoint);
    }
    if (!answer.json.is_object()) {
        throw Error(ErrorKind::Corrupt, text("The camera at ", endpoint.name(),
                                             " sent JSON that is not an object; update its firmware."));
    }
    const bool hasError = answer.json.contains("error") && answer.json["error"].is_object();
    if (hasError || shortText(answer.json, "state") == "error") {
        const CommandReply reply = parseCommandReply(answer.json);
        answer.error = reply.error;
        answer.errorMessage = reply.errorMessage;
    } else if (response.status >= 400) {
        answer.error = oscErrorCodeOfStatus(response.status);
        answer.errorMessage = text("HTTP status ", response.status);
        answer.isFromCamera = false;
    }
    return answer;
}

CommandReply replyOf(const Answer& answer) {
    if (answer.error == OscErrorCode::None) {
        return parseCommandReply(answer.json);
    }
    CommandReply reply;
    reply.state = CommandReply::State::Error;
    reply.error = answer.error;
    reply.errorMessage = answer.errorMessage;
    reply.isFromCamera = answer.isFromCamera;
    return reply;
}

bool isWorthRepeating(ErrorKind kind) {
    return kind == ErrorKind::Network || kind == ErrorKind::Timeout || kind == ErrorKind::Corrupt;
}

std::chrono::milliseconds scaledBy(std::chrono::milliseconds time, double factor) {
    return std::chrono::milliseconds(std::llround(static_cast<double>(time.count()) * factor));
}

void requirePause(const char* option, std::chrono::milliseconds value) {
    if (value < std::chrono::milliseconds(0) || value > std::chrono::minutes(10)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The camera option ", option, " must lie between 0 and 10 min."));
    }
}

} // namespace

void OscOptions::validate() const {
    http.validate();
    requirePause("retryPause", retryPause);
    requirePause("busyPause", busyPause);
    requirePause("applyPause", applyPause);
    if (statusTimeout < std::chrono::milliseconds(1) || statusTimeout > std::chrono::minutes(10)) {
        throw Error(ErrorKind::InvalidInput,
                    "The camera option statusTimeout must lie between 1 ms and 10 min.");
    }
    if (attempts < 1 || attempts > 100) {
        throw Error(ErrorKind::InvalidInput, "The camera option attempts must lie between 1 and 100.");
    }
}

OscOptions OscOptions::scaled(double factor) const {
    OscOptions result = *this;
    for (auto* pause : {&result.retryPause, &result.busyPause, &result.applyPause}) {
        *pause = scaledBy(*pause, factor);
    }
    return result;
}

void OscClient::pause(Clock::Duration duration, const std::stop_token& stop) {
    if (duration > Clock::Duration::zero()) {
        m_clock.sleep(duration, stop);
    }
    throwIfStopped(stop);
}

template <class Understand>
auto OscClient::repeatable(const Send& send, const Understand& understand, const std::stop_token& stop) {
    int failures = 0;
    int refusals = 0;
    for (;;) {
        Clock::Duration wait = m_options.retryPause;
        try {
            const Answer answer = readAnswer(send(), m_http.endpoint());
            if (refusals >= worthwhileRepeats(answer.error)) {
                return understand(answer);
            }
            wait = m_options.busyPause * (1 << refusals++);
        } catch (const Error& error) {
            if (!isWorthRepeating(error.kind()) || ++failures >= m_options.attempts) {
                throw;
            }
        }
        pause(wait, stop);
    }
}

CameraInfo OscClient::info(const std::stop_token& stop) {
    CameraInfo info =
        repeatable([&] { return m_http.get("/osc/info", stop); },
                   [&](const Answer& answer) {
                       if (answer.error == OscErrorCode::NotFound) {
                           throw notACamera(m_http.endpoint().name(), "it knows no /osc/info");
                       }
                       if (answer.error != OscErrorCode::None) {
                           throw refusal("describe itself", answer.error, answer.errorMessage);
                       }
                       if (!shortText(answer.json, "model")) {
                           throw notACamera(m_http.endpoint().name(), "it does not say which model it is");
                       }
                       return parseCameraInfo(answer.json);
                   },
                   stop);
    setLevels(info.apiLevels);
    return info;
}

CameraState OscClient::state(const std::stop_token& stop) {
    CameraState state = repeatable([&] { return m_http.post("/osc/state", "", stop); },
                                   [](const Answer& answer) {
                                       if (answer.error != OscErrorCode::None) {
                                           throw refusal("tell its state", answer.error, answer.errorMessage);
                                       }
                                       return parseCameraState(answer.json);
                                   },
                                   stop);
    noteVersion(state.apiVersion);
    return state;
}

CommandReply OscClient::ask(const std::string& command, const Json& parameters, const std::stop_token& stop) {
    enterLevel(stop);
    const Json before = session();
    CommandReply reply = askOnce(command, parameters, stop);
    if (isOfOtherLevel(reply.error) && renewLevelAfter(before, stop)) {
        reply = askOnce(command, parameters, stop);
    }
    return reply;
}

CommandReply OscClient::askOnce(const std::string& command, const Json& parameters,
                                const std::stop_token& stop) {
    const std::string body = request(command, parameters).dump();
    int sent = 0;
    CommandReply reply = repeatable(
        [&] {
            ++sent;
            // What libcurl sends again by itself is not counted, and would start a second session.
            return command == "camera.startSession" ? m_http.postOnce(kExecutePath, body, stop)
                                                    : m_http.post(kExecutePath, body, stop);
        },
        replyOf, stop);
    reply.sent = sent;
    return reply;
}

CommandReply OscClient::execute(const std::string& command, const Json& parameters, std::string_view tried,
                                const std::stop_token& stop) {
    CommandReply reply = ask(command, parameters, stop);
    if (reply.error != OscErrorCode::None) {
        throw refusal(tried, reply.error, reply.errorMessage);
    }
    return reply;
}

std::optional<Json> OscClient::findOptions(const std::vector<std::string>& names,
                                           const std::stop_token& stop) {
    const CommandReply reply = ask("camera.getOptions", {{"optionNames", names}}, stop);
    if (reply.error == OscErrorCode::InvalidParameterName ||
        reply.error == OscErrorCode::InvalidParameterValue) {
        return std::nullopt;
    }
    if (reply.error != OscErrorCode::None) {
        throw refusal("tell its settings", reply.error, reply.errorMessage);
    }
    const JsonReader options =
        JsonReader(reply.results, "The camera's answer about its settings").member("options");
    if (!options.value().is_object()) {
        options.fail("expected an object");
    }
    return options.value();
}

Json OscClient::getOptions(const std::vector<std::string>& names, const std::stop_token& stop) {
    std::optional<Json> options = findOptions(names, stop);
    if (!options) {
        throw refusal("tell its settings", OscErrorCode::InvalidParameterName, {});
    }
    return *std::move(options);
}

void OscClient::setOptions(const Json& options, const std::stop_token& stop) {
    // The moment counts even if the answer is lost: the camera may have begun to change.
    m_optionsSetAt = m_clock.now();
    execute("camera.setOptions", {{"options", options}}, "change its settings", stop);
    m_optionsSetAt = m_clock.now();
}

FileList OscClient::listFiles(const FileQuery& query, const std::stop_token& stop) {
    if (isLevelOneOnly()) {
        return listImages(query, stop);
    }
    const Json parameters{{"fileType", query.fileType},
                          {"startPosition", query.startPosition},
                          {"entryCount", query.entryCount},
                          {"maxThumbSize", 0},
                          {"_detail", true},
                          {"_sort", "newest"}};
    return parseFileList(execute("camera.listFiles", parameters, "list its files", stop).results);
}

std::optional<FileEntry> OscClient::findFile(std::string_view fileUrl, const std::stop_token& stop) {
    const std::string path = pathOfUrl(fileUrl);
    FileQuery query;
    query.entryCount = 1; // a photo just taken is the newest
    while (query.startPosition < kMaxListedFiles) {
        const FileList page = listFiles(query, stop);
        for (const FileEntry& entry : page.entries) {
            if (pathOfUrl(entry.fileUrl) == path) {
                return entry;
            }
        }
        query.startPosition += static_cast<int>(page.entries.size());
        query.entryCount = kPageEntries;
        if (page.entries.empty() || query.startPosition >= page.totalEntries) {
            break;
        }
    }
    return std::nullopt;
}

void OscClient::waitUntilApplied(const std::stop_token& stop) {
    if (m_optionsSetAt) {
        pause(*m_optionsSetAt + m_options.applyPause - m_clock.now(), stop);
    }
}

CommandReply OscClient::takePicture(const std::stop_token& stop) {
    enterLevel(stop);
    waitUntilApplied(stop);
    const std::string body = request("camera.takePicture", Json::object()).dump();
    return replyOf(readAnswer(m_http.postOnce(kExecutePath, body, stop), m_http.endpoint()));
}

CommandReply OscClient::status(const std::string& id, const std::stop_token& stop) {
    const std::string body = Json{{"id", id}}.dump();
    CommandReply reply = repeatable(
        [&] { return m_http.post(kStatusPath, body, stop, m_options.statusTimeout); }, replyOf, stop);
    if (!isLevelOneOnly()) {
        reply.results.erase("fileUri"); // of a camera that has fallen back, and will name it otherwise
    }
    return reply;
}

void OscClient::streamPreview(const HttpClient::Sink& sink, const HttpClient::Tick& tick,
                              const std::stop_token& stop) {
    enterLevel(stop);
    waitUntilApplied(stop);
    constexpr std::size_t kMostHead = 4096;
    std::string head; // some cameras send a refusal with the status of a success
    const auto keepHead = [&](ByteView bytes) {
        head += textOf(bytes.first(std::min(bytes.size(), kMostHead - head.size())));
        sink(bytes);
    };
    const std::string body =
        request(isLevelOneOnly() ? "camera._getLivePreview" : "camera.getLivePreview", Json::object()).dump();
    HttpResponse response = m_http.stream(kExecutePath, body, keepHead, tick, stop);
    if (response.status == 200 && !response.contentType.starts_with("application/json")) {
        return;
    }
    response.body += head;
    const Answer answer = readAnswer(response, m_http.endpoint());
    if (answer.error != OscErrorCode::None) {
        throw refusal("show its preview", answer.error, answer.errorMessage);
    }
}

HttpResponse OscClient::download(std::string_view fileUrl, std::uint64_t maxBytes,
                                 const HttpClient::Sink& sink, const std::stop_token& stop) {
    const std::string path = pathOfUrl(fileUrl);
    // A name of level 1 became a path, and becomes a name again; a whole URL can be got as it is.
    const bool isName = isLevelOneOnly() && fileUrl.starts_with('/');
    const std::string body =
        isName ? Json{{"name", "camera.getImage"}, {"parameters", {{"fileUri", path.substr(1)}}}}.dump() : "";
    HttpResponse response = m_http.download(isName ? kExecutePath : path, maxBytes, sink, stop, body);
    if (response.status != 200) {
        const OscErrorCode code = oscErrorCodeOfStatus(response.status);
        throw refusal(text("send ", fileNameOfUrl(fileUrl)),
                      code == OscErrorCode::None ? OscErrorCode::Other : code,
                      text("HTTP status ", response.status));
    }
    return response;
}

} // namespace spherewalk::camera
