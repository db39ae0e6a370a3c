// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/json.h"
#include "spherewalk/practice/practice_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <optional>
#include <string>
#include <thread>

namespace spherewalk::practice {

inline PracticeCameraOptions small() {
    PracticeCameraOptions options;
    options.width = 512;
    return options;
}

/// A running camera and a client of it.
class PracticeCameraHttp : public testing::Test {
  protected:
    void run(PracticeCameraOptions options = small()) {
        m_camera.emplace(std::move(options));
        m_camera->start();
        m_client.emplace("127.0.0.1", m_camera->port());
        m_client->set_keep_alive(true);
        m_client->set_tcp_nodelay(true);
    }

    void TearDown() override {
        m_client.reset();
        m_camera.reset();
    }

    PracticeCamera& camera() { return *m_camera; }

    httplib::Client& client() { return *m_client; }

    Json get(const std::string& path, int status = 200) { return body(client().Get(path.c_str()), status); }

    Json post(const std::string& path, const Json& request, int status = 200) {
        return body(client().Post(path.c_str(), request.dump(), "application/json;charset=utf-8"), status);
    }

    Json execute(const std::string& command, const Json& parameters = Json::object(), int status = 200) {
        return post("/osc/commands/execute", {{"name", command}, {"parameters", parameters}}, status);
    }

    Json state() { return post("/osc/state", Json::object())["state"]; }

    /// Polls until the capture is no longer in progress; the last answer.
    Json finished(const std::string& id, int status = 200) {
        for (;;) {
            const auto answer =
                client().Post("/osc/commands/status", Json{{"id", id}}.dump(), "application/json");
            if (!answer) {
                ADD_FAILURE() << "no answer to status";
                return {};
            }
            const Json reply = Json::parse(answer->body);
            if (reply["state"] != "inProgress") {
                EXPECT_EQ(answer->status, status) << answer->body;
                return reply;
            }
            std::this_thread::yield();
        }
    }

    /// Takes a photo; the path of its URL.
    std::string shoot() {
        const std::string url = finished(execute("camera.takePicture")["id"])["results"]["fileUrl"];
        return url.substr(url.find("/files/"));
    }

    Json list(const Json& parameters) { return execute("camera.listFiles", parameters)["results"]; }

    Bytes download(const std::string& path) {
        const auto answer = client().Get(path.c_str());
        if (!answer || answer->status != 200) {
            ADD_FAILURE() << "no file at " << path;
            return {};
        }
        return {answer->body.begin(), answer->body.end()};
    }

    void expectRefusal(const Json& answer, const std::string& code) {
        EXPECT_EQ(answer["state"], "error");
        EXPECT_EQ(answer["error"]["code"], code);
    }

  private:
    Json body(const httplib::Result& answer, int status) {
        if (!answer) {
            ADD_FAILURE() << "no answer: " << httplib::to_string(answer.error());
            return {};
        }
        EXPECT_EQ(answer->status, status) << answer->body;
        return Json::parse(answer->body, nullptr, false);
    }

    std::optional<PracticeCamera> m_camera;
    std::optional<httplib::Client> m_client;
};

inline const Json kNewest = {{"fileType", "image"}, {"entryCount", 10}, {"maxThumbSize", 0}};

} // namespace spherewalk::practice
