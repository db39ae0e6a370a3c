// SPDX-License-Identifier: GPL-3.0-or-later
// The HTTP server of the practice camera, byte by byte.
#include "server/http_server.h"

#include "spherewalk/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <netinet/in.h>
#include <optional>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace spherewalk::practice {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace std::chrono_literals;

/// A client that sees every byte.
class RawClient {
  public:
    explicit RawClient(int port) : m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        m_isConnected = ::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
        const timeval patience{10, 0};
        ::setsockopt(m_socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }

    ~RawClient() { ::close(m_socket); }

    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    bool isConnected() const { return m_isConnected; }

    void send(std::string_view bytes) const {
        EXPECT_EQ(::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }

    void endSending() const { ::shutdown(m_socket, SHUT_WR); }

    /// What has come once the text ends so; all if the connection ends before.
    std::string readUntil(const std::string& end) {
        std::array<char, 4096> piece{};
        while (!m_received.ends_with(end)) {
            const ssize_t count = ::recv(m_socket, piece.data(), piece.size(), 0);
            if (count <= 0) {
                break;
            }
            m_received.append(piece.data(), static_cast<std::size_t>(count));
        }
        return std::exchange(m_received, {});
    }

    /// All until the server closes the connection.
    std::string readAll() { return readUntil("\x01no such end\x01"); }

  private:
    int m_socket;
    bool m_isConnected = false;
    std::string m_received;
};

/// Answers with the method, the path and the body.
void echo(HttpConnection& connection) {
    while (std::optional<http::Request> request = connection.nextHead(5s)) {
        if (!connection.readBody(*request, 1000)) {
            return;
        }
        connection.answer(
            {200, "text/plain", text(request->method, " ", request->path, " ", request->body, "!")});
    }
}

class PracticeHttp : public testing::Test {
  protected:
    void serve(HttpServer::Serve serve = echo) {
        m_server.emplace(std::move(serve));
        m_port = m_server->hold("127.0.0.1", 0);
        ASSERT_NE(m_port, 0);
        ASSERT_TRUE(m_server->open());
    }

    /// The whole conversation on a connection of its own.
    std::string talk(const std::string& bytes) const {
        RawClient client(m_port);
        client.send(bytes);
        client.endSending();
        return client.readAll();
    }

    std::optional<HttpServer> m_server;
    int m_port = 0;
};

TEST_F(PracticeHttp, AConnectionCarriesOneRequestAfterAnother) {
    serve();
    RawClient client(m_port);
    for (int i = 0; i < 5; ++i) {
        client.send(text("POST /", i, " HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc"));
        const std::string answer = client.readUntil("!");
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
        EXPECT_THAT(answer, HasSubstr("\r\nContent-Length: 12\r\n"));
        EXPECT_THAT(answer, testing::EndsWith(text("\r\n\r\nPOST /", i, " abc!")));
    }
}

TEST_F(PracticeHttp, RequestsThatComeAtOnceAreAnsweredInTurn) {
    serve();
    const std::string answers =
        talk("GET /1 HTTP/1.1\r\n\r\nGET /2 HTTP/1.1\r\nConnection: close\r\n\r\nGET /3 HTTP/1.1\r\n\r\n");
    EXPECT_THAT(answers, HasSubstr("GET /1 !"));
    EXPECT_THAT(answers, HasSubstr("GET /2 !"));
    EXPECT_THAT(answers, HasSubstr("Connection: close"));
    EXPECT_THAT(answers, testing::Not(HasSubstr("GET /3"))) << "the client closed the connection before";
}

TEST_F(PracticeHttp, ARequestMayComeByteByByte) {
    serve();
    RawClient client(m_port);
    for (const char c : std::string("POST /slow HTTP/1.1\r\nContent-Length: 2\r\n\r\nok")) {
        client.send({&c, 1});
    }
    EXPECT_THAT(client.readUntil("!"), HasSubstr("POST /slow ok!"));
}

TEST_F(PracticeHttp, WhatIsNoRequestIsRefusedAndEndsTheConnection) {
    serve();
    EXPECT_THAT(talk("GARBAGE\r\n\r\n"), StartsWith("HTTP/1.1 400 Bad Request\r\n"));
    EXPECT_THAT(talk("GET / HTTP/1.1\r\nContent-Length: many\r\n\r\n"), StartsWith("HTTP/1.1 400"));
    EXPECT_THAT(talk("GET / HTTP/1.1\r\nContent-Length: -1\r\n\r\n"), StartsWith("HTTP/1.1 400"));
    EXPECT_THAT(talk("POST / HTTP/1.1\r\nContent-Length: 1001\r\n\r\n"), StartsWith("HTTP/1.1 413"));
    EXPECT_THAT(talk("POST / HTTP/1.1\r\nContent-Length: 99999999999999999999999\r\n\r\n"),
                StartsWith("HTTP/1.1 400"));
    EXPECT_THAT(talk("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"), StartsWith("HTTP/1.1 411"));
    std::string endless = "GET / HTTP/1.1\r\nX: ";
    endless.resize(64 * 1024 + 1, 'x');
    EXPECT_THAT(talk(endless), StartsWith("HTTP/1.1 431"));
    EXPECT_THAT(talk("GET /still HTTP/1.1\r\n\r\n"), HasSubstr("GET /still !"));
}

TEST_F(PracticeHttp, ABodyThatDoesNotComeIsNotAnswered) {
    serve();
    EXPECT_EQ(talk("POST / HTTP/1.1\r\nContent-Length: 10\r\n\r\nabc"), "");
    EXPECT_EQ(talk("POST / HTTP/1.1\r\nContent-Le"), "");
}

TEST_F(PracticeHttp, AClientThatAsksFirstIsToldToGoOn) {
    serve();
    RawClient client(m_port);
    client.send("POST / HTTP/1.1\r\nContent-Length: 2\r\nExpect: 100-continue\r\n\r\n");
    EXPECT_EQ(client.readUntil("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
    client.send("ok");
    EXPECT_THAT(client.readUntil("!"), HasSubstr("POST / ok!"));
}

TEST_F(PracticeHttp, TheHeadOfAnAnswerComesWithoutItsBody) {
    serve();
    const std::string answer = talk("HEAD /x HTTP/1.1\r\n\r\n");
    EXPECT_THAT(answer, HasSubstr("Content-Length: 9\r\n"));
    EXPECT_THAT(answer, testing::EndsWith("\r\n\r\n"));
}

TEST_F(PracticeHttp, ChunksSayTheirLength) {
    serve([](HttpConnection& connection) {
        connection.nextHead(5s);
        connection.beginChunks("text/plain");
        connection.sendChunk(bytesOf("hello"));
        connection.sendChunk(Bytes(26, 'x'));
        connection.sendChunk({});
    });
    const std::string answer = talk("GET / HTTP/1.1\r\n\r\n");
    EXPECT_THAT(answer, HasSubstr("Transfer-Encoding: chunked\r\n"));
    EXPECT_THAT(answer,
                testing::EndsWith("\r\n\r\n5\r\nhello\r\n1a\r\n" + std::string(26, 'x') + "\r\n0\r\n\r\n"));
}

TEST_F(PracticeHttp, ADroppedConnectionSendsNoMore) {
    serve([](HttpConnection& connection) {
        connection.nextHead(5s);
        connection.beginAnswer("text/plain", 10);
        connection.send("half");
        connection.drop();
        EXPECT_FALSE(connection.isOpen());
        EXPECT_FALSE(connection.send("more"));
        EXPECT_FALSE(connection.nextHead(5s));
    });
    EXPECT_THAT(talk("GET / HTTP/1.1\r\n\r\nGET / HTTP/1.1\r\n\r\n"), testing::EndsWith("\r\n\r\nhalf"));
}

TEST_F(PracticeHttp, TheServerNoticesThatTheClientLeaves) {
    std::atomic<bool> hasLeft = false;
    serve([&](HttpConnection& connection) {
        connection.nextHead(5s);
        connection.awaitLeaving();
        hasLeft = true;
    });
    {
        const RawClient client(m_port);
        client.send("GET / HTTP/1.1\r\n\r\n");
    }
    while (!hasLeft) {
        std::this_thread::yield();
    }
}

TEST_F(PracticeHttp, NothingIsSentOnceTheServerIsSilent) {
    serve([this](HttpConnection& connection) {
        connection.nextHead(5s);
        m_server->silence();
        connection.answer({200, "text/plain", "too late"});
        EXPECT_FALSE(connection.isOpen());
    });
    EXPECT_EQ(talk("GET / HTTP/1.1\r\n\r\n"), "");
}

TEST_F(PracticeHttp, AClosedPortIsHeldAndOpensAgain) {
    serve();
    RawClient waiting(m_port);
    waiting.send("GET / HTTP/1.1\r\n");
    for (int i = 0; i < 3; ++i) {
        m_server->close();
        EXPECT_FALSE(RawClient(m_port).isConnected()) << i;
        ASSERT_TRUE(m_server->open()) << i;
        EXPECT_THAT(talk("GET /again HTTP/1.1\r\n\r\n"), HasSubstr("GET /again !"));
    }
    EXPECT_EQ(waiting.readAll(), "") << "its connection was closed with the port";
    m_server->close();
    m_server->close();
}

TEST_F(PracticeHttp, APortHasOneServer) {
    serve();
    HttpServer second(echo);
    EXPECT_EQ(second.hold("127.0.0.1", m_port), 0);
}

TEST_F(PracticeHttp, ManyClientsAreServedAtOnce) {
    serve();
    std::vector<std::unique_ptr<RawClient>> clients;
    for (int i = 0; i < 20; ++i) {
        clients.push_back(std::make_unique<RawClient>(m_port));
        clients.back()->send(text("GET /", i, " HTTP/1.1\r\n\r\n"));
    }
    for (int i = 19; i >= 0; --i) {
        EXPECT_THAT(clients[std::size_t(i)]->readUntil("!"), HasSubstr(text("GET /", i, " !")));
    }
}

} // namespace
} // namespace spherewalk::practice
