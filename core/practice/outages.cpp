// SPDX-License-Identifier: GPL-3.0-or-later
#include "outages.h"

#include <array>
#include <cstdlib>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

namespace spherewalk::practice {

PortHolder::~PortHolder() {
    if (m_socket >= 0) {
        ::close(m_socket);
    }
}

int PortHolder::hold(const std::string& host, int port) {
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) {
        return 0;
    }
    sockaddr_storage bound{};
    socklen_t size = sizeof bound;
    auto* const any = reinterpret_cast<sockaddr*>(&bound);
    m_socket = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    // Both this socket and the one that listens must allow the other.
    const bool isHeld =
        m_socket >= 0 && ::setsockopt(m_socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
        ::bind(m_socket, found->ai_addr, found->ai_addrlen) == 0 && ::getsockname(m_socket, any, &size) == 0;
    ::freeaddrinfo(found);
    std::array<char, NI_MAXSERV> service{};
    if (!isHeld ||
        ::getnameinfo(any, size, nullptr, 0, service.data(), service.size(), NI_NUMERICSERV) != 0) {
        return 0;
    }
    return std::atoi(service.data());
}

void Outages::start() {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void Outages::begin(const Fault& outage) {
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.push_back(outage);
    }
    m_changed.notify_all();
}

void Outages::finish() {
    m_thread = {};
}

void Outages::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        Fault outage;
        {
            std::unique_lock lock(m_mutex);
            if (!m_changed.wait(lock, stop, [&] { return !m_waiting.empty(); })) {
                return;
            }
            outage = m_waiting.front();
            m_waiting.pop_front();
        }
        m_endure(outage, stop);
    }
}

} // namespace spherewalk::practice
