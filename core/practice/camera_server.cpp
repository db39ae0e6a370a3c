// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_server.h"

#include "camera_socket.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <sys/socket.h>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kKeepAlive(60'000);
constexpr std::size_t kConnections = 32;
constexpr std::size_t kMaxBody = 1 << 20;
constexpr std::size_t kChunk = 64 * 1024;
constexpr double kDownloadBytesPerSecond = 1e6; ///< 2.4 GHz
constexpr std::uint64_t kMaxPhotoBytes = 256ULL << 20;
constexpr const char* kPreviewCommand = "camera.getLivePreview";
constexpr std::string_view kRealAddress = "http://192.168.1.1";

void reply(httplib::Response& response, const OscReply& answer) {
    response.status = answer.status;
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_content(answer.body.dump(-1, ' ', false, Json::error_handler_t::replace),
                         "application/json; charset=utf-8");
}

/// The request's JSON; null for what is none.
Json requestOf(const std::string& body) {
    try {
        return parseJson(body, "the request");
    } catch (const Error&) { // answered as the unknown command that it is
        return {};
    }
}

std::string commandOf(const Json& request) {
    return request.is_object() && request.contains("name") && request["name"].is_string()
               ? printable(request["name"].get<std::string>())
               : "unknown";
}

bool isHost(const std::string& host) {
    return !host.empty() && host.size() < 256 && std::all_of(host.begin(), host.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '.' || c == ':' || c == '-' || c == '[' || c == ']';
    });
}

Json vectorJson(const Eigen::Vector3d& v) {
    return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}};
}

/// The camera knows no byte ranges. A request that names no length has no body (RFC 9112, 6.3); the library
/// would wait for one until the connection closes.
void asTheCameraReads(httplib::Request& request) {
    request.ranges.clear();
    if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
        request.set_header("Content-Length", "0");
    }
}

OscReply mistaken(const Error& error) {
    return {400, Json{{"error", error.sentence()}}};
}

} // namespace

CameraServer::CameraServer(OscDevice& device, const PracticeCameraOptions& options)
    : m_device(device), m_options(options) {
    set_tcp_nodelay(true);
    set_payload_max_length(kMaxBody);
    // A connection that is kept alive holds its thread.
    new_task_queue = [] { return new httplib::ThreadPool(kConnections); };
    // Not the library's SO_REUSEPORT: a second camera on the port must be refused.
    set_socket_options([](socket_t socket) {
        const int on = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    });
    routeCamera();
    routePractice();
    set_error_handler([this](const httplib::Request& request, httplib::Response& response) {
        if (!response.body.empty()) {
            return;
        }
        if (response.status == 404) {
            count(request);
            const bool isKnown = request.path.starts_with("/osc/") || request.path.starts_with("/practice/");
            const bool isWrongMethod =
                isKnown &&
                (request.path == "/osc/info" || request.path == "/osc/state" ||
                 request.path == "/osc/checkForUpdates" || request.path == "/osc/commands/execute" ||
                 request.path == "/osc/commands/status" || request.path == "/practice/faults" ||
                 request.path == "/practice/stats" || request.path == "/practice/pose");
            reply(response, refusal("unknown", OscCode::NotFound));
            response.status = isWrongMethod ? 405 : 404;
        }
    });
}

CameraServer::~CameraServer() {
    finish();
}

void CameraServer::start() {
    const bool isBound = m_options.port == 0 ? (m_port = bind_to_any_port(m_options.host)) > 0
                                             : bind_to_port(m_options.host, m_options.port);
    if (!isBound) {
        m_port = 0;
        throw Error(ErrorKind::Busy,
                    text("Could not start the practice camera on ", m_options.host, ", port ", m_options.port,
                         ": the port is in use or not allowed. Choose another, or 0 for any."));
    }
    m_port = m_options.port == 0 ? m_port : m_options.port;
    m_thread = std::jthread([this] { listen_after_bind(); });
    while (!is_running()) {
        std::this_thread::yield(); // until then, a stop would not be heard
    }
}

void CameraServer::finish() {
    m_stopping = true;
    m_device.stop();
    if (m_thread.joinable()) {
        stop();
        m_thread.join();
    }
}

bool CameraServer::process_and_close_socket(socket_t socket) {
    CameraSocket connection(socket, m_stopping);
    bool isGood = true;
    bool isClosed = false;
    while (isGood && !isClosed && !connection.isDropped() && connection.awaitRequest(kKeepAlive)) {
        isGood = process_request(connection, false, isClosed, asTheCameraReads);
    }
    return isGood;
}

void CameraServer::count(const httplib::Request& request) {
    const std::string path = request.path.starts_with("/files/") ? "/files" : printable(request.path);
    const std::scoped_lock lock(m_statsMutex);
    ++m_stats.requests[request.method + " " + path];
}

PracticeCameraStats CameraServer::stats() const {
    const std::scoped_lock lock(m_statsMutex);
    PracticeCameraStats stats = m_stats;
    stats.exposures = m_device.exposures();
    return stats;
}

std::string CameraServer::baseUrl(const httplib::Request& request) const {
    if (m_options.urlsOfAccessPoint) {
        return std::string(kRealAddress);
    }
    const std::string host = request.get_header_value("Host");
    return "http://" + (isHost(host) ? host : text(m_options.host, ":", m_port));
}

/// Whether a fault keeps the call from being done.
bool CameraServer::isRefused(const std::string& call, httplib::Response& response) {
    if (m_faults.take(FaultKind::DropBeforeExecuting, call)) {
        CameraSocket::current().drop();
        return true;
    }
    if (m_faults.take(FaultKind::ServiceUnavailable, call)) {
        reply(response, refusal(call, OscCode::ServiceUnavailable));
        return true;
    }
    return false;
}

void CameraServer::answer(const std::string& call, httplib::Response& response,
                          const std::function<OscReply()>& act) {
    if (isRefused(call, response)) {
        return;
    }
    const OscReply given = act();
    if (m_faults.take(FaultKind::ExecuteThenDrop, call)) {
        CameraSocket::current().drop();
        return;
    }
    reply(response, given);
}

void CameraServer::routeCamera() {
    constexpr double kQuick = 0.05; // seconds that a Theta V takes to answer
    constexpr double kTrigger = 0.2;
    Get("/osc/info", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        answer("/osc/info", response, [&] {
            m_device.pause(kQuick);
            return OscReply{200, m_device.info(m_port)};
        });
    });
    Post("/osc/state", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        answer("/osc/state", response, [&] {
            m_device.pause(kQuick);
            return OscReply{200, m_device.state(baseUrl(request))};
        });
    });
    Post("/osc/checkForUpdates", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        answer("/osc/checkForUpdates", response, [&] {
            m_device.pause(kQuick);
            return m_device.checkForUpdates(request.body);
        });
    });
    Post("/osc/commands/execute", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        const Json body = requestOf(request.body);
        const std::string command = commandOf(body);
        {
            const std::scoped_lock lock(m_statsMutex);
            ++m_stats.commands[command];
        }
        if (command == kPreviewCommand) {
            return servePreview(response);
        }
        answer(command, response, [&] {
            OscReply given = m_device.execute(body, baseUrl(request));
            const Json& results = given.body.contains("results") ? given.body["results"] : given.body;
            const double entries = results.contains("entries") ? 2e-3 * double(results["entries"].size()) : 0;
            m_device.pause((command == "camera.takePicture" ? kTrigger : kQuick) + entries);
            return given;
        });
    });
    Post("/osc/commands/status", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        answer("/osc/commands/status", response, [&] {
            m_device.pause(kQuick);
            if (m_faults.take(FaultKind::ForgetIds, "/osc/commands/status")) {
                m_device.forgetIds();
            }
            return m_device.status(request.body, baseUrl(request));
        });
    });
    Get("/files/.*", [this](const httplib::Request& request, httplib::Response& response) {
        count(request);
        serveFile(request, response);
    });
}

void CameraServer::servePreview(httplib::Response& response) {
    if (isRefused(kPreviewCommand, response)) {
        return;
    }
    const auto preview = m_device.beginPreview();
    if (!preview) {
        return reply(response, refusal(kPreviewCommand, OscCode::DisabledCommand));
    }
    constexpr double kFirstPicture = 0.5;
    m_device.pause(kFirstPicture);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_chunked_content_provider(
        kPreviewType, [this, preview = *preview](std::size_t /*sent*/, httplib::DataSink& sink) {
            return sendPicture(preview, sink);
        });
}

/// The next picture of the preview, or the end of it. False closes the connection.
bool CameraServer::sendPicture(std::uint64_t preview, httplib::DataSink& sink) {
    std::shared_ptr<const Bytes> picture;
    try {
        picture = m_device.nextPreviewPicture(preview);
    } catch (const Error&) { // stopped, or the photo that was to be shown cannot be read
        return false;
    }
    if (!picture) {
        sink.done();
        return true;
    }
    if (m_faults.take(FaultKind::PreviewStall, kPreviewCommand)) {
        constexpr std::chrono::milliseconds kGlance(20);
        while (m_device.isPreviewing(preview)) {
            std::this_thread::sleep_for(kGlance);
        }
        return false;
    }
    PreviewPart part{true, picture->size()};
    part.hasBoundary = !m_faults.take(FaultKind::PreviewWithoutBoundary, kPreviewCommand);
    if (const auto wrong = m_faults.take(FaultKind::PreviewWrongLength, kPreviewCommand)) {
        part.statedBytes = wrong->byte;
    }
    const Bytes bytes = framed(*picture, part);
    return sink.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void CameraServer::serveFile(const httplib::Request& request, httplib::Response& response) {
    if (isRefused("/files", response)) {
        return;
    }
    const auto path = m_device.fileOf(request.path);
    if (!path) {
        reply(response, refusal("unknown", OscCode::NotFound));
        return;
    }
    auto bytes = std::make_shared<Bytes>();
    try {
        *bytes = readFile(*path, kMaxPhotoBytes);
        if (request.get_param_value("type") == "thumb") {
            *bytes = jpeg::encode(jpeg::decode(*bytes, path->string(), 8), 80);
        }
    } catch (const Error&) { // deleted meanwhile, or not decodable: the camera has no such file
        reply(response, refusal("unknown", OscCode::NotFound));
        return;
    }
    const auto cut = m_faults.take(FaultKind::CutDownload, "/files");
    const std::size_t end = cut ? std::min<std::size_t>(cut->byte, bytes->size()) : SIZE_MAX;
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_content_provider(bytes->size(), "image/jpeg",
                                  [this, bytes, end](size_t offset, size_t length, httplib::DataSink& sink) {
                                      if (offset >= end || m_stopping) {
                                          return false; // closes the connection
                                      }
                                      const std::size_t size = std::min({kChunk, length, end - offset});
                                      m_device.pause(static_cast<double>(size) / kDownloadBytesPerSecond);
                                      return sink.write(reinterpret_cast<const char*>(bytes->data()) + offset,
                                                        size);
                                  });
}

void CameraServer::routePractice() {
    Get("/practice/pose", [this](const httplib::Request&, httplib::Response& response) {
        reply(response, {200, vectorJson(m_device.position())});
    });
    Post("/practice/pose", [this](const httplib::Request& request, httplib::Response& response) {
        try {
            const Json body = parseJson(request.body, "the pose");
            const JsonReader reader(body, "the pose");
            m_device.setPosition({reader.number("x"), reader.number("y"), reader.number("z")});
            reply(response, {200, vectorJson(m_device.position())});
        } catch (const Error& error) {
            reply(response, mistaken(error));
        }
    });
    Get("/practice/stats", [this](const httplib::Request&, httplib::Response& response) {
        const PracticeCameraStats given = stats();
        Json body;
        body["commands"] = given.commands;
        body["requests"] = given.requests;
        body["exposures"] = given.exposures;
        reply(response, {200, body});
    });
    Post("/practice/faults", [this](const httplib::Request& request, httplib::Response& response) {
        try {
            const Json body = parseJson(request.body, "the fault");
            const JsonReader reader(body, "the fault");
            if (reader.string("fault") == "none") {
                m_faults.clear();
            } else {
                m_faults.arm(faultOf(reader));
            }
            reply(response, {200, Json{{"armed", reader.string("fault")}}});
        } catch (const Error& error) {
            reply(response, mistaken(error));
        }
    });
}

} // namespace spherewalk::practice
