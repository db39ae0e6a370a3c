// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_socket.h"

#include "spherewalk/base/error.h"

#include <cerrno>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kTransferTimeout(20'000);
constexpr std::chrono::milliseconds kGlance(20); ///< how often a wait looks whether to stop

thread_local CameraSocket* currentSocket = nullptr;

} // namespace

CameraSocket::CameraSocket(socket_t socket, const std::atomic<bool>& stopping)
    : m_socket(socket), m_stopping(stopping) {
    currentSocket = this;
}

CameraSocket::~CameraSocket() {
    currentSocket = nullptr;
    ::shutdown(m_socket, SHUT_RDWR);
    ::close(m_socket);
}

CameraSocket& CameraSocket::current() {
    if (currentSocket == nullptr) {
        throw Error(ErrorKind::Internal, "A request of the practice camera has no connection.");
    }
    return *currentSocket;
}

bool CameraSocket::await(short events, std::chrono::milliseconds timeout) const {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!m_stopping && std::chrono::steady_clock::now() < end) {
        pollfd waiting{m_socket, events, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kGlance.count()));
        if (ready > 0) {
            return true;
        }
        if (ready < 0 && errno != EINTR) {
            return false;
        }
    }
    return false;
}

bool CameraSocket::awaitRequest(std::chrono::milliseconds timeout) const {
    return await(POLLIN, timeout);
}

void CameraSocket::answer(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t wrote = write(bytes.data(), bytes.size());
        if (wrote <= 0) {
            return drop();
        }
        bytes.remove_prefix(static_cast<std::size_t>(wrote));
    }
    m_isAnswered = true;
}

void CameraSocket::awaitLeaving() const {
    while (!m_stopping) {
        pollfd waiting{m_socket, POLLRDHUP, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kGlance.count()));
        if (ready > 0 || (ready < 0 && errno != EINTR)) {
            return;
        }
    }
}

bool CameraSocket::is_readable() const {
    return !m_dropped && await(POLLIN, kTransferTimeout);
}

bool CameraSocket::is_writable() const {
    return !m_dropped && await(POLLOUT, kTransferTimeout);
}

ssize_t CameraSocket::read(char* to, size_t size) {
    return is_readable() ? ::recv(m_socket, to, size, 0) : -1;
}

ssize_t CameraSocket::write(const char* from, size_t size) {
    if (m_isAnswered) {
        return static_cast<ssize_t>(size);
    }
    return is_writable() ? ::send(m_socket, from, size, MSG_NOSIGNAL) : -1;
}

// Who is at the other end does not matter to the camera.
void CameraSocket::get_remote_ip_and_port(std::string& ip, int& port) const {
    ip.clear();
    port = 0;
}

void CameraSocket::get_local_ip_and_port(std::string& ip, int& port) const {
    ip.clear();
    port = 0;
}

socket_t CameraSocket::socket() const {
    return m_socket;
}

} // namespace spherewalk::practice
