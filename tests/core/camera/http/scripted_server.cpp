// SPDX-License-Identifier: GPL-3.0-or-later
#include "http/scripted_server.h"

#include <arpa/inet.h>
#include <array>
#include <charconv>
#include <chrono>
#include <netinet/in.h>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace spherewalk::test {

namespace {

/// Waits until there is something to read (or the peer is gone), looking at the stop token.
bool waitReadable(int descriptor, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        pollfd watched{descriptor, POLLIN, 0};
        if (::poll(&watched, 1, 20) > 0) {
            return true;
        }
    }
    return false;
}

std::size_t contentLength(const std::string& head) {
    const std::size_t name = head.find("Content-Length: ");
    std::size_t length = 0;
    if (name != std::string::npos) {
        const char* digits = head.data() + name + 16;
        std::from_chars(digits, head.data() + head.size(), length);
    }
    return length;
}

/// Takes one whole request out of what has been received.
std::optional<ServerRequest> takeRequest(std::string& received) {
    const std::size_t end = received.find("\r\n\r\n");
    if (end == std::string::npos) {
        return std::nullopt;
    }
    ServerRequest request;
    request.head = received.substr(0, end + 2);
    const std::size_t length = contentLength(request.head);
    if (received.size() < end + 4 + length) {
        return std::nullopt;
    }
    request.body = received.substr(end + 4, length);
    received.erase(0, end + 4 + length);
    const std::size_t space = request.head.find(' ');
    request.method = request.head.substr(0, space);
    request.path = request.head.substr(space + 1, request.head.find(' ', space + 1) - space - 1);
    return request;
}

/// False if the client has left.
bool sendAll(int descriptor, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count = ::send(descriptor, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (count <= 0) {
            return false;
        }
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

bool receiveSome(int descriptor, std::string& into) {
    std::array<char, 4096> buffer{};
    const ssize_t count = ::recv(descriptor, buffer.data(), buffer.size(), 0);
    if (count <= 0) {
        return false;
    }
    into.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

void require(bool worked, const char* what) {
    if (!worked) {
        throw std::runtime_error(what);
    }
}

} // namespace

std::string httpAnswer(int status, const std::string& contentType, const std::string& body) {
    return "HTTP/1.1 " + std::to_string(status) + " X\r\nContent-Type: " + contentType +
           "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

ServerAction answerJson(const std::string& json, int status) {
    return {httpAnswer(status, "application/json; charset=utf-8", json)};
}

ServerAction answerOsc(const std::string& errorCode, int status) {
    return answerJson(R"({"name":"x","state":"error","error":{"code":")" + errorCode +
                          R"(","message":"words of the camera"}})",
                      status);
}

ServerAction answerPage(int status) {
    return {httpAnswer(status, "text/html", "<!DOCTYPE html><html><body>Router</body></html>")};
}

ServerAction closeSilently() {
    return {"", ServerAction::Then::Close};
}

ServerAction neverAnswer() {
    return {"", ServerAction::Then::Stall};
}

ScriptedServer::ScriptedServer(Handler handler) : m_handler(std::move(handler)) {
    m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    require(m_listener >= 0, "socket");
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof(address);
    auto* generic = reinterpret_cast<sockaddr*>(&address);
    require(::bind(m_listener, generic, length) == 0, "bind");
    require(::listen(m_listener, 16) == 0, "listen");
    require(::getsockname(m_listener, generic, &length) == 0, "getsockname");
    m_port = ntohs(address.sin_port);
    m_accepting = std::jthread([this](const std::stop_token& stop) { accept(stop); });
}

ScriptedServer::~ScriptedServer() {
    m_accepting.request_stop();
    m_accepting.join();
    m_serving.clear(); // each asks its thread to stop and joins it
    ::close(m_listener);
}

std::string ScriptedServer::address() const {
    return "127.0.0.1:" + std::to_string(m_port);
}

int ScriptedServer::count(const std::string& path) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_counts.find(path);
    return found == m_counts.end() ? 0 : found->second;
}

int ScriptedServer::connections() const {
    const std::scoped_lock lock(m_mutex);
    return m_connections;
}

bool ScriptedServer::waitForCount(const std::string& path, int atLeast) const {
    std::unique_lock lock(m_mutex);
    return m_counted.wait_for(lock, std::chrono::seconds(10), [&] {
        const auto found = m_counts.find(path);
        return found != m_counts.end() && found->second >= atLeast;
    });
}

void ScriptedServer::accept(const std::stop_token& stop) {
    while (waitReadable(m_listener, stop)) {
        const int descriptor = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        if (descriptor < 0) {
            continue;
        }
        int connection = 0;
        {
            const std::scoped_lock lock(m_mutex);
            connection = ++m_connections;
        }
        m_serving.emplace_back([this, descriptor, connection](const std::stop_token& stopServing) {
            serve(descriptor, connection, stopServing);
            ::close(descriptor);
        });
    }
}

void ScriptedServer::serve(int descriptor, int connection, const std::stop_token& stop) {
    std::string received;
    while (waitReadable(descriptor, stop) && receiveSome(descriptor, received)) {
        while (auto request = takeRequest(received)) {
            request->connection = connection;
            const ServerAction action = handle(*request);
            if (!sendAll(descriptor, action.bytes) || action.then == ServerAction::Then::Close) {
                return;
            }
            if (action.then == ServerAction::Then::Stall) {
                waitReadable(descriptor, stop); // until the client leaves
                return;
            }
        }
    }
}

ServerAction ScriptedServer::handle(const ServerRequest& request) {
    {
        const std::scoped_lock lock(m_mutex);
        ++m_counts[request.path];
    }
    m_counted.notify_all();
    const std::scoped_lock lock(m_handling);
    return m_handler(request);
}

} // namespace spherewalk::test
