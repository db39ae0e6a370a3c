// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/http_server.h"

#include "spherewalk/base/text.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kTransferTimeout(20'000);
constexpr std::chrono::milliseconds kStopGlance(20); ///< How often a wait looks whether to stop.
constexpr std::size_t kMaxHead = 64 * 1024;
constexpr std::size_t kConnections = 32; ///< A connection that is kept alive holds its thread.

} // namespace

HttpConnection::HttpConnection(int socket, const std::atomic<bool>& isSilent)
    : m_socket(socket), m_isSilent(isSilent) {
    const int on = 1;
    ::setsockopt(m_socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

HttpConnection::~HttpConnection() {
    ::shutdown(m_socket, SHUT_RDWR);
    ::close(m_socket);
}

bool HttpConnection::await(short events, std::chrono::milliseconds timeout) const {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (isOpen() && std::chrono::steady_clock::now() < end) {
        pollfd waiting{m_socket, events, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kStopGlance.count()));
        if (ready > 0) {
            return true;
        }
        if (ready < 0 && errno != EINTR) {
            return false;
        }
    }
    return false;
}

bool HttpConnection::receive(std::chrono::milliseconds timeout) {
    std::array<char, 16 * 1024> bytes; // NOLINT(*-member-init): filled below
    const ssize_t count = await(POLLIN, timeout) ? ::recv(m_socket, bytes.data(), bytes.size(), 0) : -1;
    if (count <= 0) {
        drop();
        return false;
    }
    m_received.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
}

void HttpConnection::refuse(int status) {
    m_isLast = true;
    answer({status, "text/plain", ""});
    drop();
}

std::optional<http::Request> HttpConnection::nextHead(std::chrono::milliseconds timeout) {
    if (m_isLast || !isOpen() || (m_received.empty() && !receive(timeout))) {
        return std::nullopt;
    }
    m_isHead = false;
    std::size_t end = 0;
    while ((end = m_received.find("\r\n\r\n")) == std::string::npos && m_received.size() <= kMaxHead) {
        if (!receive(kTransferTimeout)) {
            return std::nullopt;
        }
    }
    std::optional<http::Request> request;
    if (end <= kMaxHead) {
        request = http::parseRequestHead(std::string_view(m_received).substr(0, end));
    }
    if (!request) {
        refuse(end <= kMaxHead ? 400 : 431);
        return std::nullopt;
    }
    m_received.erase(0, end + 4);
    m_isHead = request->method == "HEAD";
    m_isLast = !request->keepsAlive;
    return request;
}

bool HttpConnection::readBody(http::Request& request, std::size_t maxBytes) {
    const bool isChunked = request.headers.contains("Transfer-Encoding");
    const std::optional<std::size_t> length = http::contentLength(request);
    if (isChunked || !length || *length > maxBytes) {
        refuse(isChunked ? 411 : length ? 413 : 400);
        return false;
    }
    if (request.says("Expect", "100-continue")) {
        send("HTTP/1.1 100 Continue\r\n\r\n");
    }
    while (m_received.size() < *length) {
        if (!receive(kTransferTimeout)) {
            return false;
        }
    }
    request.body = m_received.substr(0, *length);
    m_received.erase(0, *length);
    return true;
}

bool HttpConnection::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t wrote = await(POLLOUT, kTransferTimeout)
                                  ? ::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                  : -1;
        if (wrote <= 0) {
            drop();
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(wrote));
    }
    return isOpen();
}

void HttpConnection::sendHead(int status, const std::vector<std::pair<std::string, std::string>>& headers) {
    std::string head = text("HTTP/1.1 ", status, " ", http::reasonPhrase(status), "\r\n");
    for (const auto& [name, value] : headers) {
        head += text(name, ": ", value, "\r\n");
    }
    head += m_isLast ? "Connection: close\r\n\r\n" : "Keep-Alive: timeout=60\r\n\r\n";
    send(head);
}

void HttpConnection::answer(const http::Answer& answer) {
    auto headers = answer.headers;
    if (!answer.type.empty()) {
        headers.emplace_back("Content-Type", answer.type);
    }
    headers.emplace_back("Content-Length", text(answer.body.size()));
    sendHead(answer.status, headers);
    send(m_isHead ? std::string_view() : answer.body);
}

void HttpConnection::beginAnswer(const std::string& type, std::size_t bytes) {
    sendHead(
        200,
        {{"X-Content-Type-Options", "nosniff"}, {"Content-Type", type}, {"Content-Length", text(bytes)}});
}

void HttpConnection::beginChunks(const std::string& type) {
    sendHead(
        200,
        {{"X-Content-Type-Options", "nosniff"}, {"Content-Type", type}, {"Transfer-Encoding", "chunked"}});
}

bool HttpConnection::sendChunk(ByteView bytes) {
    std::array<char, 16> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), bytes.size(), 16).ptr;
    return send(text(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())), "\r\n",
                     std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "\r\n"));
}

void HttpConnection::awaitLeaving() const {
    while (isOpen()) {
        pollfd waiting{m_socket, POLLRDHUP, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kStopGlance.count()));
        if (ready > 0 || (ready < 0 && errno != EINTR)) {
            return;
        }
    }
}

HttpServer::~HttpServer() {
    close();
    if (m_holder >= 0) {
        ::close(m_holder);
    }
}

namespace {

/// A socket that is bound to the address; -1 if it cannot be had. Both the holding and the listening socket
/// must allow the other, and a second camera on the port must be refused: hence SO_REUSEADDR and not
/// SO_REUSEPORT.
int boundSocket(const sockaddr* address, socklen_t bytes) {
    const int made = ::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    if (made >= 0 && ::setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
        ::bind(made, address, bytes) == 0) {
        return made;
    }
    if (made >= 0) {
        ::close(made);
    }
    return -1;
}

} // namespace

int HttpServer::hold(const std::string& host, int port) {
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) {
        return 0;
    }
    m_holder = boundSocket(found->ai_addr, found->ai_addrlen);
    ::freeaddrinfo(found);
    auto* const address = reinterpret_cast<sockaddr*>(&m_address);
    m_addressBytes = sizeof m_address;
    std::array<char, NI_MAXSERV> service{};
    if (m_holder < 0 || ::getsockname(m_holder, address, &m_addressBytes) != 0 ||
        ::getnameinfo(address, m_addressBytes, nullptr, 0, service.data(), service.size(), NI_NUMERICSERV) !=
            0) {
        return 0;
    }
    return static_cast<int>(parseNumber(service.data()).value_or(0));
}

bool HttpServer::open() {
    m_listening = boundSocket(reinterpret_cast<const sockaddr*>(&m_address), m_addressBytes);
    if (m_listening < 0 || ::listen(m_listening, SOMAXCONN) != 0) {
        close();
        return false;
    }
    m_isSilent = false;
    for (std::size_t i = 0; i < kConnections; ++i) {
        m_threads.emplace_back([this] { acceptAndServe(); });
    }
    return true;
}

void HttpServer::acceptAndServe() {
    while (!m_isSilent) {
        const int socket = ::accept4(m_listening, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket >= 0) {
            HttpConnection connection(socket, m_isSilent);
            m_serve(connection);
        } else if (errno != EINTR && errno != ECONNABORTED) {
            constexpr std::chrono::milliseconds kRelief(5); // no descriptor is free, or the port was closed
            std::this_thread::sleep_for(kRelief);
        }
    }
}

void HttpServer::close() {
    m_isSilent = true;
    if (m_listening >= 0) {
        ::shutdown(m_listening, SHUT_RDWR); // ends accept4 in all threads
        m_threads.clear();
        ::close(m_listening);
        m_listening = -1;
    }
}

} // namespace spherewalk::practice
