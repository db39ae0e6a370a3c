// SPDX-License-Identifier: GPL-3.0-or-later
// The requests that no camera knows: for the cart, and for what is to go wrong.
#include "camera_server.h"
#include "reply.h"

#include "spherewalk/base/error.h"

namespace spherewalk::practice {

namespace {

constexpr std::size_t kMaxScript = 10'000;

Json vectorJson(const Eigen::Vector3d& v) {
    return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}};
}

OscReply mistaken(const Error& error) {
    return {400, Json{{"error", error.sentence()}}};
}

} // namespace

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
            std::vector<Fault> script;
            if (body.is_array()) {
                const std::size_t size = reader.arraySize(kMaxScript);
                for (std::size_t i = 0; i < size; ++i) {
                    script.push_back(faultOf(reader.element(i)));
                }
            } else if (reader.string("fault") == "none") {
                m_faults.clear();
                m_device.meet({FaultKind::NoMoreTrouble, ""});
            } else {
                script.push_back(faultOf(reader));
            }
            for (const Fault& fault : script) {
                m_faults.arm(fault);
            }
            reply(response, {200, Json{{"armed", script.size()}}});
        } catch (const Error& error) {
            reply(response, mistaken(error));
        }
    });
}

} // namespace spherewalk::practice
