// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/http/message.h"

#include <QHostAddress>
#include <QList>
#include <QObject>
#include <QTcpServer>

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

class QTcpSocket;

namespace spherewalk::ui {

/// Answers HTTP requests of devices on the local network, one request a connection. Whatever comes is bounded
/// in size, number and time, and a client that exceeds a bound is answered with the status for that, or
/// dropped. Threads: the GUI thread.
class LocalServer : public QObject {
    Q_OBJECT

  public:
    static constexpr quint16 kUsualPort = 8790;
    static constexpr std::size_t kMostHead = 8192; ///< Bytes of a request's head.
    static constexpr std::size_t kMostBody = 1024; ///< Bytes of a request's body.
    static constexpr int kMostConnections = 24;
    static constexpr int kMostOfOneDevice = 8;
    /// From the connection to the answer's last byte.
    static constexpr std::chrono::milliseconds kMostTime{10'000};

    /// Returns the answer to a whole request. Errors: it must throw none.
    using Handler = std::function<http::Answer(const http::Request&, const QHostAddress&)>;

    explicit LocalServer(Handler handler, std::chrono::milliseconds mostTime = kMostTime);
    ~LocalServer() override;

    /// Listens at this address only, at this port, or at any that is free if another program has that.
    /// Returns false if the address cannot be had.
    bool open(const QHostAddress& address, quint16 port = kUsualPort);
    /// Drops all connections, and listens no more.
    void close();

    bool isOpen() const { return m_listener.isListening(); }

    /// Returns "192.168.1.5:8790"; empty while closed. It is the Host of every request that is meant for
    /// here.
    QString host() const;

    /// Says why open() failed.
    QString sentence() const { return m_listener.errorString(); }

    /// Returns the addresses of this computer that only devices on a local network can reach.
    static QList<QHostAddress> localAddresses();

  private:
    void accept();
    void read(QTcpSocket* socket);
    std::optional<http::Answer> answer(std::string_view received, const QHostAddress& peer) const;

    Handler m_handler;
    std::chrono::milliseconds m_mostTime;
    QTcpServer m_listener;
    QList<QTcpSocket*> m_open;
};

} // namespace spherewalk::ui
