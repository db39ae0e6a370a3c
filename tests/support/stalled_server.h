// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace spherewalk::test {

/// Takes connections and never answers.
class StalledServer {
  public:
    StalledServer() : m_socket(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* any = reinterpret_cast<sockaddr*>(&address);
        if (::bind(m_socket, any, size) != 0 || ::listen(m_socket, 8) != 0 ||
            ::getsockname(m_socket, any, &size) != 0) {
            throw std::runtime_error("no socket");
        }
        m_address = QString("127.0.0.1:%1").arg(ntohs(address.sin_port));
    }

    ~StalledServer() { ::close(m_socket); }

    StalledServer(const StalledServer&) = delete;
    StalledServer& operator=(const StalledServer&) = delete;

    const QString& address() const { return m_address; }

  private:
    int m_socket;
    QString m_address;
};

} // namespace spherewalk::test
