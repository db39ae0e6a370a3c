// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/local_server.h"

#include <QNetworkInterface>
#include <QTcpSocket>
#include <QTimer>

#include <algorithm>
#include <string>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr std::string_view kHeadEnd = "\r\n\r\n";
constexpr qint64 kMostRequest = LocalServer::kMostHead + kHeadEnd.size() + LocalServer::kMostBody;

/// Whether the address is of a private network, of a link, or of this computer. Source: RFC 1918, RFC 3927.
bool isLocal(const QHostAddress& address) {
    static const QList<QPair<QHostAddress, int>> kNetworks = {
        QHostAddress::parseSubnet("10.0.0.0/8"), QHostAddress::parseSubnet("172.16.0.0/12"),
        QHostAddress::parseSubnet("192.168.0.0/16"), QHostAddress::parseSubnet("169.254.0.0/16"),
        QHostAddress::parseSubnet("127.0.0.0/8")};
    return std::ranges::any_of(kNetworks, [&](const auto& network) { return address.isInSubnet(network); });
}

http::Answer refusal(int status) {
    return {status, "text/plain", std::string(http::reasonPhrase(status))};
}

QByteArray bytesOf(const http::Answer& answer) {
    std::string head = "HTTP/1.1 " + std::to_string(answer.status) + " ";
    head += http::reasonPhrase(answer.status);
    for (const auto& [name, value] : answer.headers) {
        head += "\r\n" + name + ": " + value;
    }
    head += "\r\nContent-Type: " + answer.type;
    head += "\r\nContent-Length: " + std::to_string(answer.body.size());
    head += "\r\nConnection: close\r\n\r\n";
    return QByteArray::fromStdString(head + answer.body);
}

} // namespace

LocalServer::LocalServer(Handler handler, std::chrono::milliseconds mostTime)
    : m_handler(std::move(handler)), m_mostTime(mostTime) {
    connect(&m_listener, &QTcpServer::newConnection, this, &LocalServer::accept);
}

LocalServer::~LocalServer() {
    close();
}

QList<QHostAddress> LocalServer::localAddresses() {
    QList<QHostAddress> found;
    for (const QNetworkInterface& network : QNetworkInterface::allInterfaces()) {
        const auto flags = network.flags();
        if (!flags.testFlag(QNetworkInterface::IsRunning) || flags.testFlag(QNetworkInterface::IsLoopBack)) {
            continue;
        }
        for (const QNetworkAddressEntry& entry : network.addressEntries()) {
            if (entry.ip().protocol() == QAbstractSocket::IPv4Protocol && isLocal(entry.ip())) {
                found << entry.ip();
            }
        }
    }
    return found;
}

bool LocalServer::open(const QHostAddress& address, quint16 port) {
    close();
    m_listener.setMaxPendingConnections(kMostConnections);
    return m_listener.listen(address, port) || m_listener.listen(address, 0);
}

void LocalServer::close() {
    m_listener.close();
    for (QTcpSocket* socket : std::exchange(m_open, {})) {
        socket->disconnect(this);
        socket->abort();
        socket->deleteLater();
    }
}

QString LocalServer::host() const {
    return isOpen() ? QString("%1:%2").arg(m_listener.serverAddress().toString()).arg(m_listener.serverPort())
                    : QString();
}

void LocalServer::accept() {
    while (QTcpSocket* socket = m_listener.nextPendingConnection()) {
        const QHostAddress peer = socket->peerAddress();
        const auto ofPeer = std::ranges::count_if(
            m_open, [&](const QTcpSocket* other) { return other->peerAddress() == peer; });
        if (!isLocal(peer) || m_open.size() >= kMostConnections || ofPeer >= kMostOfOneDevice) {
            socket->abort();
            socket->deleteLater();
            continue;
        }
        m_open << socket;
        socket->setReadBufferSize(kMostRequest);
        QTimer::singleShot(m_mostTime, socket, &QTcpSocket::abort);
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { read(socket); });
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
            m_open.removeOne(socket);
            socket->deleteLater();
        });
        read(socket); // what has come already
    }
}

void LocalServer::read(QTcpSocket* socket) {
    const QByteArray received = socket->peek(kMostRequest);
    const auto whole =
        answer({received.data(), static_cast<std::size_t>(received.size())}, socket->peerAddress());
    if (whole) {
        disconnect(socket, &QTcpSocket::readyRead, this, nullptr); // what follows counts for nothing
        socket->write(bytesOf(*whole));
        socket->disconnectFromHost();
    }
}

/// Returns nothing as long as the request is not whole.
std::optional<http::Answer> LocalServer::answer(std::string_view received, const QHostAddress& peer) const {
    const std::size_t end = received.find(kHeadEnd);
    if (end == std::string_view::npos && received.size() <= kMostHead) {
        return std::nullopt;
    }
    if (end > kMostHead) {
        return refusal(431);
    }
    auto request = http::parseRequestHead(received.substr(0, end));
    const auto length = request ? http::contentLength(*request) : std::nullopt;
    if (!length) {
        return refusal(400);
    }
    if (request->headers.contains("Transfer-Encoding")) {
        return refusal(411);
    }
    if (*length > kMostBody) {
        return refusal(413);
    }
    const std::string_view body = received.substr(end + kHeadEnd.size());
    if (body.size() < *length) {
        return std::nullopt;
    }
    request->body = body.substr(0, *length);
    return m_handler(*request, peer);
}

} // namespace spherewalk::ui
