// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "http/scripted_server.h"

#include "spherewalk/camera/http.h"

#include <chrono>
#include <stdexcept>
#include <thread>

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::closeSilently;
using test::expectError;
using test::httpAnswer;
using test::neverAnswer;
using test::ScriptedServer;
using test::ServerAction;
using test::ServerRequest;
using testing::HasSubstr;

HttpOptions quick() {
    HttpOptions options;
    options.connectTimeout = 2s;
    options.requestTimeout = 5s;
    options.stallTimeout = 300ms;
    return options;
}

HttpClient clientOf(const ScriptedServer& server, HttpOptions options = quick()) {
    return HttpClient(parseEndpoint(server.address()), options);
}

ServerAction ok(const std::string& body) {
    return {httpAnswer(200, "Text/Plain", body)};
}

TEST(HttpClient, SendsWhatWasGivenAndReturnsWhatCame) {
    ServerRequest seen;
    ScriptedServer server([&](const ServerRequest& request) {
        seen = request;
        return ServerAction{httpAnswer(503, "Text/Plain", "come back")};
    });
    HttpClient client = clientOf(server);
    const HttpResponse response = client.post("/osc/x", R"({"a":1})", {});
    EXPECT_EQ(response.status, 503);
    EXPECT_EQ(response.body, "come back");
    EXPECT_EQ(response.contentType, "text/plain");
    EXPECT_EQ(response.declaredBytes, 9U);
    EXPECT_EQ(seen.method, "POST");
    EXPECT_EQ(seen.body, R"({"a":1})");
    EXPECT_THAT(seen.head, HasSubstr("Content-Type: application/json;charset=utf-8\r\n"));
    EXPECT_THAT(seen.head, HasSubstr("X-XSRF-Protected: 1\r\n"));
    EXPECT_THAT(seen.head, HasSubstr("Content-Length: 7\r\n"));
}

TEST(HttpClient, SendsAnEmptyBodyWithItsLength) {
    ServerRequest seen;
    ScriptedServer server([&](const ServerRequest& request) {
        seen = request;
        return ok("{}");
    });
    HttpClient client = clientOf(server);
    client.post("/osc/state", "", {});
    EXPECT_EQ(seen.method, "POST");
    EXPECT_THAT(seen.head, HasSubstr("Content-Length: 0\r\n"));
}

TEST(HttpClient, ReadsAChunkedAnswer) {
    ScriptedServer server([](const ServerRequest&) {
        return ServerAction{
            "HTTP/1.1 200 X\r\nTransfer-Encoding: Chunked\r\n\r\n3\r\nabc\r\n2\r\nde\r\n0\r\n\r\n"};
    });
    HttpClient client = clientOf(server);
    const HttpResponse response = client.get("/a", {});
    EXPECT_EQ(response.body, "abcde");
    EXPECT_EQ(response.declaredBytes, std::nullopt);
}

TEST(HttpClient, ReusesAConnection) {
    ScriptedServer server([](const ServerRequest&) { return ok("x"); });
    HttpClient client = clientOf(server);
    client.get("/a", {});
    client.get("/b", {});
    EXPECT_EQ(server.connections(), 1);
}

TEST(HttpClient, UsesNoProxyFromTheEnvironment) {
    ::setenv("http_proxy", "http://127.0.0.1:1", 1);
    ScriptedServer server([](const ServerRequest&) { return ok("x"); });
    HttpClient client = clientOf(server);
    EXPECT_EQ(client.get("/a", {}).body, "x");
    ::unsetenv("http_proxy");
}

TEST(HttpClient, DoesNotFollowRedirects) {
    ScriptedServer server([](const ServerRequest&) {
        return ServerAction{"HTTP/1.1 302 Found\r\nLocation: /other\r\nContent-Length: 0\r\n\r\n"};
    });
    HttpClient client = clientOf(server);
    EXPECT_EQ(client.get("/a", {}).status, 302);
    EXPECT_EQ(server.count("/other"), 0);
}

/// Answers the first request and closes without an answer at all others.
ScriptedServer::Handler answerOnlyFirst() {
    return
        [requests = 0](const ServerRequest&) mutable { return ++requests == 1 ? ok("x") : closeSilently(); };
}

// Documents why postOnce exists.
TEST(HttpClient, PostIsRepeatedByLibcurlOnAKeptAliveConnection) {
    ScriptedServer server(answerOnlyFirst());
    HttpClient client = clientOf(server);
    client.get("/first", {});
    expectError(ErrorKind::Network, "broke", [&] { client.post("/shoot", "{}", {}); });
    EXPECT_EQ(server.count("/shoot"), 2);
}

TEST(HttpClient, PostOnceIsSentOnceAfterKeptAliveUse) {
    ScriptedServer server(answerOnlyFirst());
    HttpClient client = clientOf(server);
    client.get("/first", {});
    expectError(ErrorKind::Network, "broke", [&] { client.postOnce("/shoot", "{}", {}); });
    EXPECT_EQ(server.count("/shoot"), 1);
    EXPECT_EQ(server.connections(), 2);
}

TEST(HttpClient, PostOnceIsSentOnceOnAFreshClient) {
    ScriptedServer server([](const ServerRequest&) { return closeSilently(); });
    HttpClient client = clientOf(server);
    expectError(ErrorKind::Network, "broke", [&] { client.postOnce("/shoot", "{}", {}); });
    EXPECT_EQ(server.count("/shoot"), 1);
}

TEST(HttpClient, PostOnceIsSentOnceWhenTheAnswerIsCut) {
    for (const char* cut : {"HTT", "HTTP/1.1 200 X\r\n", "HTTP/1.1 200 X\r\nContent-Length: 9\r\n\r\n",
                            "HTTP/1.1 200 X\r\nContent-Length: 9\r\n\r\n{\"st"}) {
        ScriptedServer server([&](const ServerRequest& request) {
            return request.path == "/first" ? ok("x") : ServerAction{cut, ServerAction::Then::Close};
        });
        HttpClient client = clientOf(server);
        client.get("/first", {});
        try { // libcurl takes a header that ends early for a whole answer without a body
            EXPECT_EQ(client.postOnce("/shoot", "{}", {}).body, "") << cut;
        } catch (const Error& error) {
            EXPECT_EQ(name(error.kind()), name(ErrorKind::Network)) << cut;
        }
        EXPECT_EQ(server.count("/shoot"), 1) << cut;
    }
}

TEST(HttpClient, LeavesNoConnectionBehindPostOnce) {
    ScriptedServer server([](const ServerRequest&) { return ok("x"); });
    HttpClient client = clientOf(server);
    client.postOnce("/shoot", "{}", {});
    client.postOnce("/shoot", "{}", {});
    EXPECT_EQ(server.connections(), 2);
}

TEST(HttpClient, NamesTheHostThatCannotBeReached) {
    int port = 0;
    {
        ScriptedServer server([](const ServerRequest&) { return ok("x"); });
        port = server.port();
    }
    HttpClient client(Endpoint{"127.0.0.1", port}, quick());
    expectError(ErrorKind::Network, "127.0.0.1:" + std::to_string(port), [&] { client.get("/a", {}); });
}

TEST(HttpClient, GivesUpOnASilentServer) {
    ScriptedServer server([](const ServerRequest&) { return neverAnswer(); });
    HttpOptions options = quick();
    options.requestTimeout = 150ms;
    HttpClient client = clientOf(server, options);
    expectError(ErrorKind::Timeout, "0.15 s", [&] { client.get("/a", {}); });
    expectError(ErrorKind::Timeout, "0.05 s", [&] { client.post("/a", "{}", {}, 50ms); });
}

TEST(HttpClient, StopsWhileTheServerNeverAnswers) {
    ScriptedServer server([](const ServerRequest&) { return neverAnswer(); });
    HttpOptions options = quick();
    options.requestTimeout = 10min;
    options.stallTimeout = 10min;
    HttpClient client = clientOf(server, options);
    const auto stopDuring = [&](const char* path, auto request) {
        std::stop_source stop;
        std::jthread stopper([&] {
            EXPECT_TRUE(server.waitForCount(path, 1));
            stop.request_stop();
        });
        expectError(ErrorKind::Stopped, "Stopped", [&] { request(stop.get_token()); });
    };
    stopDuring("/get", [&](const std::stop_token& stop) { client.get("/get", stop); });
    stopDuring("/post", [&](const std::stop_token& stop) { client.postOnce("/post", "{}", stop); });
    stopDuring("/file", [&](const std::stop_token& stop) {
        client.download(
            "/file", 99, [](ByteView) {}, stop);
    });
}

TEST(HttpClient, SendsNothingOnceStopped) {
    ScriptedServer server([](const ServerRequest&) { return ok("x"); });
    HttpClient client = clientOf(server);
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { client.postOnce("/a", "{}", stop.get_token()); });
    EXPECT_EQ(server.count("/a"), 0);
}

TEST(HttpClient, RefusesMoreThanACameraWouldSend) {
    ScriptedServer server([](const ServerRequest& request) {
        const std::string big(70'000, 'x');
        return request.path == "/body"
                   ? ok(big)
                   : ServerAction{"HTTP/1.1 200 X\r\nA: " + big + "\r\nB: " + big + "\r\n"};
    });
    HttpOptions options = quick();
    options.maxAnswerBytes = 50'000;
    HttpClient client = clientOf(server, options);
    expectError(ErrorKind::Corrupt, "more than a camera", [&] { client.get("/body", {}); });
    expectError(ErrorKind::Corrupt, "more than a camera", [&] { client.get("/header", {}); });
}

TEST(HttpClient, TellsAHostThatDoesNotSpeakHttp) {
    ScriptedServer server([](const ServerRequest&) {
        return ServerAction{"SSH-2.0-OpenSSH\r\n", ServerAction::Then::Close};
    });
    HttpClient client = clientOf(server);
    expectError(ErrorKind::Unsupported, "does not speak HTTP", [&] { client.get("/a", {}); });
}

TEST(HttpClient, RecoversFromAnAnswerLongerThanItSaid) {
    ScriptedServer server([](const ServerRequest& request) {
        return request.path == "/long"
                   ? ServerAction{"HTTP/1.1 200 X\r\nContent-Length: 2\r\n\r\n{}" + std::string(100'000, 'x')}
                   : ok("x");
    });
    HttpClient client = clientOf(server);
    EXPECT_EQ(client.get("/long", {}).body, "{}");
    try { // at the latest the second attempt, on a new connection, is clean
        EXPECT_EQ(client.get("/next", {}).body, "x");
    } catch (const Error& error) {
        EXPECT_EQ(name(error.kind()), name(ErrorKind::Network));
    }
    EXPECT_EQ(client.get("/next", {}).body, "x");
}

TEST(HttpDownload, GivesTheBodyToTheSink) {
    const std::string body(300'000, 'j');
    ScriptedServer server([&](const ServerRequest&) { return ok(body); });
    HttpClient client = clientOf(server);
    std::string got;
    const HttpResponse response =
        client.download("/f", 1 << 20, [&](ByteView piece) { got += textOf(piece); }, {});
    EXPECT_EQ(got, body);
    EXPECT_EQ(response.receivedBytes, body.size());
    EXPECT_TRUE(response.body.empty());
}

TEST(HttpDownload, KeepsAnErrorPageFromTheSink) {
    ScriptedServer server([](const ServerRequest&) { return test::answerPage(404); });
    HttpClient client = clientOf(server);
    const HttpResponse response = client.download("/f", 99, [](ByteView) { ADD_FAILURE(); }, {});
    EXPECT_EQ(response.status, 404);
    EXPECT_THAT(response.body, HasSubstr("Router"));
}

TEST(HttpDownload, NoticesABodyCutShort) {
    ScriptedServer server([](const ServerRequest&) {
        return ServerAction{"HTTP/1.1 200 X\r\nContent-Length: 100\r\n\r\nonly this",
                            ServerAction::Then::Close};
    });
    HttpClient client = clientOf(server);
    expectError(ErrorKind::Network, "broke", [&] { client.download("/f", 999, [](ByteView) {}, {}); });
}

TEST(HttpDownload, NoticesAStall) {
    ScriptedServer server([](const ServerRequest&) {
        return ServerAction{"HTTP/1.1 200 X\r\nContent-Length: 100\r\n\r\nonly this",
                            ServerAction::Then::Stall};
    });
    HttpClient client = clientOf(server);
    expectError(ErrorKind::Timeout, "stood still", [&] { client.download("/f", 999, [](ByteView) {}, {}); });
}

TEST(HttpDownload, PassesOnWhatTheSinkThrows) {
    ScriptedServer server([](const ServerRequest&) { return ok("body"); });
    HttpClient client = clientOf(server);
    const auto full = [](ByteView) { throw Error(ErrorKind::Full, "the disk is full"); };
    expectError(ErrorKind::Full, "disk is full", [&] { client.download("/f", 999, full, {}); });
    EXPECT_EQ(client.get("/f", {}).body, "body");
}

TEST(HttpDownload, RefusesMoreThanAllowed) {
    ScriptedServer server([](const ServerRequest&) { return ok(std::string(5000, 'x')); });
    HttpClient client = clientOf(server);
    expectError(ErrorKind::Corrupt, "more than", [&] { client.download("/f", 4999, [](ByteView) {}, {}); });
}

TEST(HttpOptions, RefusesTimesOutOfRange) {
    HttpOptions options;
    options.stallTimeout = 0ms;
    expectError(ErrorKind::InvalidInput, "stallTimeout", [&] { options.validate(); });
}

} // namespace
} // namespace spherewalk::camera
