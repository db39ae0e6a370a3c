// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's own requests and what goes wrong with them, and the practice requests, which no camera knows.
#include "server/camera_server.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
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

constexpr std::size_t kMaxScript = 10'000;

Json positionJson(const Eigen::Vector3d& v) {
    return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}};
}

} // namespace

void CameraServer::answerUnknown(const http::Request& request, HttpConnection& connection) {
    constexpr std::array<std::string_view, 8> kOtherMethod = {"/osc/info",
                                                              "/osc/state",
                                                              "/osc/checkForUpdates",
                                                              "/osc/commands/execute",
                                                              "/osc/commands/status",
                                                              "/practice/faults",
                                                              "/practice/stats",
                                                              "/practice/pose"};
    count(request);
    const bool isKnown =
        std::find(kOtherMethod.begin(), kOtherMethod.end(), request.path) != kOtherMethod.end();
    reply(connection, {isKnown ? 405 : 404, refusal("unknown", OscCode::NotFound).body});
}

bool CameraServer::admits(const http::Request& request, HttpConnection& connection) {
    count(request);
    if (m_faults.take(FaultKind::StaleNonce, request.path)) {
        m_gate.renew();
    }
    const std::string challenge =
        m_gate.challenge(request.method, request.target, request.header("Authorization"));
    if (challenge.empty()) {
        return true;
    }
    connection.answer({401, "text/plain", "", {{"WWW-Authenticate", challenge}}});
    return false;
}

/// Lets happen to the camera what is due at this call. Returns true if the camera is off now.
bool CameraServer::isHit(const std::string& call, HttpConnection& connection) {
    for (const Fault& fault : m_faults.takeOfCamera(call)) {
        m_device.meet(fault);
    }
    return !connection.isOpen();
}

bool CameraServer::isRefused(const std::string& call, HttpConnection& connection) {
    if (isHit(call, connection)) {
        return true;
    }
    const auto fault = m_faults.take({FaultKind::DropBeforeExecuting, FaultKind::NeverAnswer,
                                      FaultKind::ServiceUnavailable, FaultKind::Refuse, FaultKind::WebPage},
                                     call);
    if (!fault) {
        return false;
    }
    switch (fault->kind) {
    case FaultKind::NeverAnswer:
        connection.awaitLeaving();
        [[fallthrough]];
    case FaultKind::DropBeforeExecuting:
        connection.drop();
        break;
    case FaultKind::WebPage:
        connection.send(onWire("text/html", kPage, kPage.size()));
        break;
    default:
        reply(connection, refusal(call, oscCode(fault->code).value_or(OscCode::ServiceUnavailable)));
    }
    return true;
}

void CameraServer::answer(const std::string& call, HttpConnection& connection, const Act& act) {
    if (!isRefused(call, connection)) {
        deliver(call, act(), connection);
    }
}

void CameraServer::deliver(const std::string& call, const OscReply& given, HttpConnection& connection) {
    const auto fault = m_faults.take({FaultKind::ExecuteThenDrop, FaultKind::EmptyBody,
                                      FaultKind::MalformedJson, FaultKind::TruncatedJson,
                                      FaultKind::ShortLength, FaultKind::LongLength, FaultKind::Chunked},
                                     call);
    if (!fault) {
        return reply(connection, given);
    }
    constexpr std::string_view kJson = "application/json; charset=utf-8";
    const std::string body = given.body.dump(-1, ' ', false, Json::error_handler_t::replace);
    switch (fault->kind) {
    case FaultKind::EmptyBody:
        connection.send(onWire(kJson, "", 0));
        break;
    case FaultKind::MalformedJson:
        connection.send(onWire(kJson, "{\"state\": done,", 15));
        break;
    case FaultKind::TruncatedJson: {
        const std::string part = body.substr(0, std::min<std::size_t>(fault->byte, body.size() - 1));
        connection.send(onWire(kJson, part, part.size()));
        break;
    }
    case FaultKind::ShortLength:
        connection.send(onWire(kJson, body, body.size() / 2));
        break;
    case FaultKind::LongLength:
        connection.send(onWire(kJson, body, 2 * body.size()));
        connection.drop();
        break;
    case FaultKind::Chunked:
        connection.send(inChunks(body, given.status));
        break;
    default:
        connection.drop();
    }
}

void CameraServer::routeCamera() {
    const auto route = [this](const char* call, Handle handle) {
        m_handlers[call] = [this, handle = std::move(handle)](const http::Request& request,
                                                              HttpConnection& connection) {
            if (admits(request, connection)) {
                handle(request, connection);
            }
        };
    };
    const auto answered = [&](const char* call, auto act) {
        route(call, [this, act](const http::Request& request, HttpConnection& connection) {
            answer(request.path, connection, [&] {
                m_device.pause(kQuick);
                return act(request);
            });
        });
    };
    answered("GET /osc/info", [this](const http::Request&) { return OscReply{200, m_device.info(m_port)}; });
    answered("POST /osc/state", [this](const http::Request& request) {
        return OscReply{200, m_device.state(baseUrl(request))};
    });
    answered("POST /osc/checkForUpdates",
             [this](const http::Request& request) { return m_device.checkForUpdates(request.body); });
    answered("POST /osc/commands/status", [this](const http::Request& request) {
        return m_device.status(request.body, baseUrl(request));
    });
    route("POST /osc/commands/execute",
          [this](const http::Request& request, HttpConnection& connection) { execute(request, connection); });
    route("GET /files/", [this](const http::Request& request, HttpConnection& connection) {
        const auto type = request.query.find("type");
        serveFile(m_device.fileOf(request.path), type != request.query.end() && type->second == "thumb",
                  connection);
    });
}

void CameraServer::execute(const http::Request& request, HttpConnection& connection) {
    const Json body = requestOf(request.body);
    const std::string command = commandOf(body);
    {
        const std::scoped_lock lock(m_statsMutex);
        ++m_stats.commands[command];
    }
    if (isPreview(command)) {
        return servePreview(connection);
    }
    if (command == "camera.getImage") {
        if (const auto image = m_device.imageOf(body)) {
            return serveFile(image, false, connection);
        }
    }
    answer(command, connection, [&] {
        OscReply given = m_device.execute(body, baseUrl(request));
        const Json& results = given.body.contains("results") ? given.body["results"] : given.body;
        const double entries = results.contains("entries") ? 2e-3 * double(results["entries"].size()) : 0;
        m_device.pause((command == "camera.takePicture" ? kTrigger : kQuick) + entries);
        return given;
    });
}

void CameraServer::routePractice() {
    const auto route = [this](const char* call, const std::function<Json(const http::Request&)>& act) {
        m_handlers[call] = [act](const http::Request& request, HttpConnection& connection) {
            try {
                reply(connection, {200, act(request)});
            } catch (const Error& error) {
                reply(connection, {400, Json{{"error", error.sentence()}}});
            }
        };
    };
    route("GET /practice/pose", [this](const http::Request&) { return positionJson(m_device.position()); });
    route("POST /practice/pose", [this](const http::Request& request) {
        const Json body = parseJson(request.body, "the pose");
        const JsonReader reader(body, "the pose");
        m_device.setPosition({reader.number("x"), reader.number("y"), reader.number("z")});
        return positionJson(m_device.position());
    });
    route("POST /practice/walk", [this](const http::Request&) { return Json{{"moved", m_device.walkOn()}}; });
    route("GET /practice/stats", [this](const http::Request&) {
        const PracticeCameraStats given = stats();
        return Json{
            {"commands", given.commands}, {"requests", given.requests}, {"exposures", given.exposures}};
    });
    route("POST /practice/faults", [this](const http::Request& request) { return armed(request.body); });
}

Json CameraServer::armed(const std::string& script) {
    const Json body = parseJson(script, "the fault");
    const JsonReader reader(body, "the fault");
    std::vector<Fault> faults;
    if (body.is_array()) {
        const std::size_t size = reader.arraySize(kMaxScript);
        for (std::size_t i = 0; i < size; ++i) {
            faults.push_back(faultOf(reader.element(i)));
        }
    } else if (reader.string("fault") == "none") {
        m_faults.clear();
        m_device.meet({FaultKind::NoMoreTrouble, ""});
    } else {
        faults.push_back(faultOf(reader));
    }
    for (const Fault& fault : faults) {
        m_faults.arm(fault);
    }
    return {{"armed", faults.size()}};
}

} // namespace spherewalk::practice
