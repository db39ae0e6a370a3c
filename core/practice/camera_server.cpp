// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_server.h"

#include "camera_socket.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <sys/socket.h>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kKeepAlive(60'000);
constexpr std::size_t kConnections = 32;
constexpr std::size_t kMaxBody = 1 << 20;
constexpr std::string_view kRealAddress = "http://192.168.1.1";

bool isHost(const std::string& host) {
    return !host.empty() && host.size() < 256 && std::all_of(host.begin(), host.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '.' || c == ':' || c == '-' || c == '[' || c == ']';
    });
}

/// The camera knows no byte ranges. A request that names no length has no body (RFC 9112, 6.3); the library
/// would wait for one until the connection closes.
void asTheCameraReads(httplib::Request& request) {
    request.ranges.clear();
    if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
        request.set_header("Content-Length", "0");
    }
}

/// Between two openings of the port.
constexpr std::chrono::milliseconds kGlance(5);

} // namespace

CameraServer::CameraServer(OscDevice& device, FaultPlan& faults, const PracticeCameraOptions& options)
    : m_device(device),
      m_faults(faults),
      m_options(options),
      m_gate("RICOH THETA V", options.digestUser, options.digestPassword, options.nonceRequests,
             options.seed),
      m_outages([this](const Fault& outage, const std::stop_token& stop) { endure(outage, stop); }) {
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
        if (response.body.empty() && response.status == 404) {
            answerUnknown(request, response);
        }
    });
    m_device.onOutage([this](const Fault& outage) {
        m_stopping = true; // nothing is answered from here on
        m_outages.begin(outage);
    });
}

CameraServer::~CameraServer() {
    finish();
}

void CameraServer::start() {
    m_port = m_holder.hold(m_options.host, m_options.port);
    if (m_port == 0 || !bind_to_port(m_options.host, m_port)) {
        m_port = 0;
        throw Error(ErrorKind::Busy,
                    text("Could not start the practice camera on ", m_options.host, ", port ", m_options.port,
                         ": the port is in use or not allowed. Choose another, or 0 for any."));
    }
    listen();
    m_outages.start();
}

/// On the port that is bound.
void CameraServer::listen() {
    m_thread = std::jthread([this] { listen_after_bind(); });
    while (!is_running()) {
        std::this_thread::yield(); // until then, a stop would not be heard
    }
}

/// Closes the port and all connections.
void CameraServer::fallSilent() {
    m_stopping = true;
    if (m_thread.joinable()) {
        stop();
        m_thread.join();
    }
}

void CameraServer::finish() {
    m_outages.finish();
    m_stopping = true;
    m_device.stop();
    fallSilent();
}

void CameraServer::endure(const Fault& outage, const std::stop_token& stop) {
    fallSilent();
    if (outage.kind == FaultKind::Reboot) {
        m_device.restart();
        m_gate.renew();
    } else if (outage.kind == FaultKind::Sleep) {
        m_device.fallAsleep();
    }
    m_device.pause(outage.amount, stop);
    m_stopping = false;
    while (!stop.stop_requested()) {
        if (bind_to_port(m_options.host, m_port)) {
            return listen();
        }
        std::this_thread::sleep_for(kGlance); // the old socket may need a moment
    }
}

bool CameraServer::process_and_close_socket(socket_t socket) {
    CameraSocket connection(socket, m_stopping);
    bool isGood = true;
    bool isClosed = false;
    while (isGood && !isClosed && !connection.isDropped() && connection.awaitRequest(kKeepAlive)) {
        connection.beginAnswer();
        isGood = process_request(connection, false, isClosed, [&](httplib::Request& request) {
            asTheCameraReads(request);
            if (m_faults.take(FaultKind::DropAfterHeader, request.path)) {
                connection.drop();
            }
        });
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

} // namespace spherewalk::practice
