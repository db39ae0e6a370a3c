// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's own requests, and what goes wrong with them.
#include "camera_server.h"
#include "camera_socket.h"
#include "reply.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>

namespace spherewalk::practice {

namespace {

constexpr double kQuick = 0.05; ///< seconds that a Theta V takes to answer
constexpr double kTrigger = 0.2;
constexpr std::string_view kPage = "<!DOCTYPE html><html><body>Please log in</body></html>";

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

bool isPreview(const std::string& command) {
    return command == "camera.getLivePreview" || command == "camera._getLivePreview";
}

/// The bytes of an answer as they go over the wire.
std::string onWire(std::string_view type, std::string_view body, std::size_t statedBytes) {
    return text("HTTP/1.1 200 OK\r\nContent-Type: ", type, "\r\nContent-Length: ", statedBytes, "\r\n\r\n",
                body);
}

std::string inChunks(std::string_view body, int status) {
    constexpr std::size_t kPiece = 7;
    std::string wire = text("HTTP/1.1 ", status, " OK\r\nContent-Type: application/json; charset=utf-8\r\n",
                            "Transfer-Encoding: Chunked\r\n\r\n");
    for (; !body.empty(); body.remove_prefix(std::min(kPiece, body.size()))) {
        const std::string_view piece = body.substr(0, kPiece);
        wire += text(piece.size(), "\r\n", piece, "\r\n");
    }
    return wire + "0\r\n\r\n";
}

} // namespace

void CameraServer::answerUnknown(const httplib::Request& request, httplib::Response& response) {
    constexpr std::array<std::string_view, 8> kOtherMethod = {"/osc/info",
                                                              "/osc/state",
                                                              "/osc/checkForUpdates",
                                                              "/osc/commands/execute",
                                                              "/osc/commands/status",
                                                              "/practice/faults",
                                                              "/practice/stats",
                                                              "/practice/pose"};
    count(request);
    reply(response, refusal("unknown", OscCode::NotFound));
    const bool isKnown =
        std::find(kOtherMethod.begin(), kOtherMethod.end(), request.path) != kOtherMethod.end();
    response.status = isKnown ? 405 : 404;
}

bool CameraServer::admits(const httplib::Request& request, httplib::Response& response) {
    count(request);
    if (m_faults.take(FaultKind::StaleNonce, request.path)) {
        m_gate.renew();
    }
    const std::string challenge =
        m_gate.challenge(request.method, request.target, request.get_header_value("Authorization"));
    if (challenge.empty()) {
        return true;
    }
    response.status = 401;
    response.set_header("WWW-Authenticate", challenge);
    response.set_content("", "text/plain");
    return false;
}

/// What happens to the camera at this call; true if it is off now.
bool CameraServer::isHit(const std::string& call) {
    for (const Fault& fault : m_faults.takeOfCamera(call)) {
        m_device.meet(fault);
    }
    if (m_stopping) {
        CameraSocket::current().drop();
    }
    return m_stopping;
}

bool CameraServer::isRefused(const std::string& call, httplib::Response& response) {
    if (isHit(call)) {
        return true;
    }
    const auto fault = m_faults.take({FaultKind::DropBeforeExecuting, FaultKind::NeverAnswer,
                                      FaultKind::ServiceUnavailable, FaultKind::Refuse, FaultKind::WebPage},
                                     call);
    if (!fault) {
        return false;
    }
    CameraSocket& socket = CameraSocket::current();
    switch (fault->kind) {
    case FaultKind::NeverAnswer:
        socket.awaitLeaving();
        [[fallthrough]];
    case FaultKind::DropBeforeExecuting:
        socket.drop();
        break;
    case FaultKind::WebPage:
        socket.answer(onWire("text/html", kPage, kPage.size()));
        break;
    default:
        reply(response, refusal(call, oscCode(fault->code).value_or(OscCode::ServiceUnavailable)));
    }
    return true;
}

void CameraServer::answer(const std::string& call, httplib::Response& response, const Act& act) {
    if (!isRefused(call, response)) {
        deliver(call, act(), response);
    }
}

void CameraServer::deliver(const std::string& call, const OscReply& given, httplib::Response& response) {
    reply(response, given);
    const auto fault = m_faults.take({FaultKind::ExecuteThenDrop, FaultKind::EmptyBody,
                                      FaultKind::MalformedJson, FaultKind::TruncatedJson,
                                      FaultKind::ShortLength, FaultKind::LongLength, FaultKind::Chunked},
                                     call);
    if (!fault) {
        return;
    }
    constexpr std::string_view kJson = "application/json; charset=utf-8";
    CameraSocket& socket = CameraSocket::current();
    const std::string& body = response.body;
    switch (fault->kind) {
    case FaultKind::EmptyBody:
        return socket.answer(onWire(kJson, "", 0));
    case FaultKind::MalformedJson:
        return socket.answer(onWire(kJson, "{\"state\": done,", 15));
    case FaultKind::TruncatedJson: {
        const std::string part = body.substr(0, std::min<std::size_t>(fault->byte, body.size() - 1));
        return socket.answer(onWire(kJson, part, part.size()));
    }
    case FaultKind::ShortLength:
        return socket.answer(onWire(kJson, body, body.size() / 2));
    case FaultKind::LongLength:
        socket.answer(onWire(kJson, body, 2 * body.size()));
        return socket.drop();
    case FaultKind::Chunked:
        return socket.answer(inChunks(body, given.status));
    default:
        socket.drop();
    }
}

void CameraServer::routeCamera() {
    const auto route = [this](auto method, const char* path, auto&& handle) {
        (this->*method)(path, [this, handle](const httplib::Request& request, httplib::Response& response) {
            if (admits(request, response)) {
                handle(request, response);
            }
        });
    };
    using Register = httplib::Server& (httplib::Server::*)(const std::string&, httplib::Server::Handler);
    const auto get = static_cast<Register>(&httplib::Server::Get);
    const auto post = static_cast<Register>(&httplib::Server::Post);
    using Request = httplib::Request;
    using Response = httplib::Response;
    route(get, "/osc/info", [this](const Request&, Response& response) {
        answer("/osc/info", response, [&] {
            m_device.pause(kQuick);
            return OscReply{200, m_device.info(m_port)};
        });
    });
    route(post, "/osc/state", [this](const Request& request, Response& response) {
        answer("/osc/state", response, [&] {
            m_device.pause(kQuick);
            return OscReply{200, m_device.state(baseUrl(request))};
        });
    });
    route(post, "/osc/checkForUpdates", [this](const Request& request, Response& response) {
        answer("/osc/checkForUpdates", response, [&] {
            m_device.pause(kQuick);
            return m_device.checkForUpdates(request.body);
        });
    });
    route(post, "/osc/commands/execute",
          [this](const Request& request, Response& response) { execute(request, response); });
    route(post, "/osc/commands/status", [this](const Request& request, Response& response) {
        answer("/osc/commands/status", response, [&] {
            m_device.pause(kQuick);
            return m_device.status(request.body, baseUrl(request));
        });
    });
    route(get, "/files/.*", [this](const Request& request, Response& response) {
        serveFile(m_device.fileOf(request.path), request.get_param_value("type") == "thumb", response);
    });
}

void CameraServer::execute(const httplib::Request& request, httplib::Response& response) {
    const Json body = requestOf(request.body);
    const std::string command = commandOf(body);
    {
        const std::scoped_lock lock(m_statsMutex);
        ++m_stats.commands[command];
    }
    if (isPreview(command)) {
        return servePreview(response);
    }
    if (command == "camera.getImage") {
        if (const auto image = m_device.imageOf(body)) {
            return serveFile(image, false, response);
        }
    }
    answer(command, response, [&] {
        OscReply given = m_device.execute(body, baseUrl(request));
        const Json& results = given.body.contains("results") ? given.body["results"] : given.body;
        const double entries = results.contains("entries") ? 2e-3 * double(results["entries"].size()) : 0;
        m_device.pause((command == "camera.takePicture" ? kTrigger : kQuick) + entries);
        return given;
    });
}

} // namespace spherewalk::practice
