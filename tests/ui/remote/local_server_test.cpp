// SPDX-License-Identifier: GPL-3.0-or-later
// What clients send that mean no good, byte by byte.
#include "phone.h"
#include "ui/remote/local_server.h"

#include <gmock/gmock.h>

#include <vector>

namespace spherewalk::ui {

using testing::SizeIs;

namespace {

class LocalServerTest : public testing::Test {
  protected:
    LocalServerTest() { EXPECT_TRUE(server.open(QHostAddress(QHostAddress::LocalHost))); }

    QUrl url() const { return QUrl("http://" + server.host()); }

    int statusOf(const QByteArray& request) const { return sendRaw(url(), request).status; }

    http::Answer remember(const http::Request& request) {
        served.push_back(request);
        return {200, "text/plain", "served"};
    }

    std::vector<http::Request> served;
    LocalServer server{
        [this](const http::Request& request, const QHostAddress&) { return remember(request); }};
};

} // namespace

TEST_F(LocalServerTest, AnswersARequestAndEndsTheConnection) {
    const Reply reply = sendRaw(url(), "POST /a?b=c HTTP/1.1\r\nContent-Length: 4\r\n\r\nbody and more");
    EXPECT_EQ(reply.status, 200);
    EXPECT_EQ(reply.body, "served");
    ASSERT_THAT(served, SizeIs(1));
    EXPECT_EQ(served[0].path, "/a");
    EXPECT_EQ(served[0].body, "body");
}

TEST_F(LocalServerTest, ServesARequestThatComesInPieces) {
    QTcpSocket socket;
    socket.connectToHost(url().host(), static_cast<quint16>(url().port()));
    QByteArray received;
    QObject::connect(&socket, &QTcpSocket::readyRead, [&] { received += socket.readAll(); });
    for (const char c : QByteArray("POST / HTTP/1.1\r\nContent-Length: 2\r\n\r\nab")) {
        ASSERT_TRUE(served.empty());
        socket.write(&c, 1);
        ASSERT_TRUE(socket.waitForBytesWritten() || socket.bytesToWrite() == 0);
        QCoreApplication::processEvents();
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return received.contains("served"); }));
    EXPECT_EQ(served.at(0).body, "ab");
}

TEST_F(LocalServerTest, RefusesWhatIsTooLargeOrMalformed) {
    const QByteArray post = "POST / HTTP/1.1\r\n";
    EXPECT_EQ(statusOf("GET / HTTP/1.1\r\nX: " + QByteArray(9000, 'x') + "\r\n\r\n"), 431);
    EXPECT_EQ(statusOf(QByteArray(9000, 'x')), 431) << "without an end";
    EXPECT_EQ(statusOf(post + "Content-Length: 1025\r\n\r\n"), 413);
    EXPECT_EQ(statusOf(post + "Content-Length: 99999999999999999999999\r\n\r\n"), 400);
    EXPECT_EQ(statusOf(post + "Content-Length: -1\r\n\r\n"), 400);
    EXPECT_EQ(statusOf(post + "Content-Length: 1x\r\n\r\nab"), 400);
    EXPECT_EQ(statusOf(post + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n"), 411);
    EXPECT_EQ(statusOf("\x16\x03\x01\x02\r\n\r\n"), 400) << "somebody tries TLS";
    EXPECT_EQ(statusOf("GET /\r\n\r\n"), 400);
    EXPECT_EQ(statusOf("\r\n\r\n"), 400);
    EXPECT_EQ(statusOf(QByteArray("GET /\0 HTTP/9\r\n\r\n", 18)), 400);
    EXPECT_TRUE(served.empty());
    EXPECT_EQ(statusOf("GET / HTTP/1.1\r\n\r\n"), 200) << "it still serves";
}

TEST_F(LocalServerTest, ARequestOfMegabytesIsCutOff) {
    const Reply reply = sendRaw(url(), QByteArray(8'000'000, 'x')); // refused, or dropped while it sends
    EXPECT_TRUE(reply.status == 431 || reply.status == 0) << reply.status;
    EXPECT_TRUE(served.empty());
    EXPECT_EQ(statusOf("GET / HTTP/1.1\r\n\r\n"), 200);
}

TEST_F(LocalServerTest, OneDeviceCannotTakeAllConnections) {
    std::vector<std::unique_ptr<QTcpSocket>> sockets;
    for (int i = 0; i < 2 * LocalServer::kMostConnections; ++i) {
        sockets.push_back(std::make_unique<QTcpSocket>());
        sockets.back()->connectToHost(url().host(), static_cast<quint16>(url().port()));
        sockets.back()->write("GET / ");
    }
    const auto open = [&] {
        return std::ranges::count_if(
            sockets, [](const auto& socket) { return socket->state() != QAbstractSocket::UnconnectedState; });
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return open() == LocalServer::kMostOfOneDevice; }, 100'000)) << open();
    sockets.clear();
    ASSERT_TRUE(QTest::qWaitFor([&] { return statusOf("GET / HTTP/1.1\r\n\r\n") == 200; }));
}

TEST(LocalServer, DropsAClientThatDoesNotComeToAnEnd) {
    LocalServer server([](const http::Request&, const QHostAddress&) { return http::Answer(); },
                       std::chrono::milliseconds(50));
    ASSERT_TRUE(server.open(QHostAddress(QHostAddress::LocalHost)));
    EXPECT_EQ(sendRaw(QUrl("http://" + server.host()), "GET / HTTP/1.1\r\n").status, 0);
}

TEST(LocalServer, AddressesOfOthersAreNotListenedAt) {
    LocalServer server([](const http::Request&, const QHostAddress&) { return http::Answer(); });
    EXPECT_FALSE(server.open(QHostAddress("192.0.2.1"))); // no computer has it: RFC 5737
    EXPECT_FALSE(server.isOpen());
    EXPECT_FALSE(server.sentence().isEmpty());
    EXPECT_EQ(server.host(), QString());
}

} // namespace spherewalk::ui
