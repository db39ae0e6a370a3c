// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's port: when it is open, and what is counted.
#include "server/camera_server.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kKeepAlive(60'000);
constexpr std::size_t kMaxBody = 1 << 20;
constexpr std::string_view kRealAddress = "http://192.168.1.1";

bool isHost(const std::string& host) {
    return !host.empty() && host.size() < 256 && std::all_of(host.begin(), host.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '.' || c == ':' || c == '-' || c == '[' || c == ']';
    });
}

} // namespace

void Outages::start() {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void Outages::begin(const Fault& outage) {
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.push_back(outage);
    }
    m_changed.notify_all();
}

void Outages::finish() {
    m_thread = {};
}

void Outages::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        Fault outage;
        {
            std::unique_lock lock(m_mutex);
            if (!m_changed.wait(lock, stop, [&] { return !m_waiting.empty(); })) {
                return;
            }
            outage = m_waiting.front();
            m_waiting.pop_front();
        }
        m_endure(outage, stop);
    }
}

CameraServer::CameraServer(OscDevice& device, FaultPlan& faults, const PracticeCameraOptions& options)
    : m_device(device),
      m_faults(faults),
      m_options(options),
      m_gate("RICOH THETA V", options.digestUser, options.digestPassword, options.nonceRequests,
             options.seed),
      m_http([this](HttpConnection& connection) { serve(connection); }),
      m_outages([this](const Fault& outage, const std::stop_token& stop) { endure(outage, stop); }) {
    routeCamera();
    routePractice();
    m_device.onOutage([this](const Fault& outage) {
        m_http.silence(); // nothing is answered from here on
        m_outages.begin(outage);
    });
}

CameraServer::~CameraServer() {
    finish();
}

void CameraServer::start() {
    m_port = m_http.hold(m_options.host, m_options.port);
    if (m_port == 0 || !m_http.open()) {
        m_port = 0;
        throw Error(ErrorKind::Busy,
                    text("Could not start the practice camera on ", m_options.host, ", port ", m_options.port,
                         ": the port is in use or not allowed. Choose another, or 0 for any."));
    }
    m_outages.start();
}

void CameraServer::finish() {
    m_outages.finish();
    m_http.silence();
    m_device.stop();
    m_http.close();
}

void CameraServer::endure(const Fault& outage, const std::stop_token& stop) {
    m_http.close();
    if (outage.kind == FaultKind::Reboot) {
        m_device.restart();
        m_gate.renew();
    } else if (outage.kind == FaultKind::Sleep) {
        m_device.fallAsleep();
    }
    m_device.pause(outage.amount, stop);
    while (!stop.stop_requested() && !m_http.open()) {
        constexpr std::chrono::milliseconds kBetweenTries(5); // the old socket may need a moment
        std::this_thread::sleep_for(kBetweenTries);
    }
}

void CameraServer::serve(HttpConnection& connection) {
    while (std::optional<http::Request> request = connection.nextHead(kKeepAlive)) {
        if (m_faults.take(FaultKind::DropAfterHeader, request->path) ||
            !connection.readBody(*request, kMaxBody)) {
            return;
        }
        dispatch(*request, connection);
    }
}

void CameraServer::dispatch(const http::Request& request, HttpConnection& connection) {
    const bool isFile = request.method == "GET" && request.path.starts_with("/files/");
    const auto handler = m_handlers.find(request.method + " " + (isFile ? "/files/" : request.path));
    try {
        if (handler == m_handlers.end()) {
            answerUnknown(request, connection);
        } else {
            handler->second(request, connection);
        }
    } catch (const std::exception&) { // a defect of the practice camera must not end the program
        reply(connection, refusal("unknown", OscCode::ServerError));
    }
}

void CameraServer::count(const http::Request& request) {
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

std::string CameraServer::baseUrl(const http::Request& request) const {
    if (m_options.urlsOfAccessPoint) {
        return std::string(kRealAddress);
    }
    const std::string host = request.header("Host");
    return "http://" + (isHost(host) ? host : text(m_options.host, ":", m_port));
}

void reply(HttpConnection& connection, const OscReply& answer) {
    connection.answer({answer.status,
                       "application/json; charset=utf-8",
                       answer.body.dump(-1, ' ', false, Json::error_handler_t::replace),
                       {{"X-Content-Type-Options", "nosniff"}}});
}

} // namespace spherewalk::practice
