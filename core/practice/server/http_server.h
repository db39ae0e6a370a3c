// SPDX-License-Identifier: GPL-3.0-or-later
// A small HTTP/1.1 server whose handlers own the bytes of their answers, so that they can spoil any of them.
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/http/message.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <thread>
#include <utility>
#include <vector>

namespace spherewalk::practice {

/// One connected socket. Threads: the one that serves it. Stop: each function returns within 20 ms after the
/// server falls silent. From then on the connection is closed.
class HttpConnection {
  public:
    /// Owner: takes the socket. isSilent: becomes true when the server shall not send another byte.
    HttpConnection(int socket, const std::atomic<bool>& isSilent);
    ~HttpConnection();
    HttpConnection(const HttpConnection&) = delete;
    HttpConnection& operator=(const HttpConnection&) = delete;

    /// Waits for the head of the next request. Returns nothing at the end of the connection, and after a bad
    /// or too long head, which is answered with its status.
    std::optional<http::Request> nextHead(std::chrono::milliseconds timeout);
    /// Reads the body that the head announces. Without a Content-Length there is none (RFC 9112, 6.3).
    /// Returns false at the end of the connection, and for a body that is too long or chunked, which is
    /// answered with its status.
    bool readBody(http::Request& request, std::size_t maxBytes);

    void answer(const http::Answer& answer);
    /// Sends a status line and headers that announce a body of this length; send() sends the body.
    void beginAnswer(const std::string& type, std::size_t bytes);
    /// Sends headers that announce a body in chunks, of which sendChunk() sends one. An empty chunk ends the
    /// body.
    void beginChunks(const std::string& type);
    bool sendChunk(ByteView bytes);
    /// Sends bytes as they are. Returns false if the connection is closed.
    bool send(std::string_view bytes);

    /// Ends the connection without another byte.
    void drop() { m_isOpen = false; }

    bool isOpen() const { return m_isOpen && !m_isSilent; }

    /// Returns when the client has closed the connection, or the server fell silent.
    void awaitLeaving() const;

  private:
    bool await(short events, std::chrono::milliseconds timeout) const;
    bool receive(std::chrono::milliseconds timeout);
    void refuse(int status);
    void sendHead(int status, const std::vector<std::pair<std::string, std::string>>& headers);

    int m_socket;
    const std::atomic<bool>& m_isSilent;
    bool m_isOpen = true;
    bool m_isLast = false;  ///< The connection ends with this answer.
    bool m_isHead = false;  ///< The answer to HEAD has no body.
    std::string m_received; ///< Not yet read by a request.
};

/// A TCP port and the threads that serve its connections. Threads: silence() may be called from any thread,
/// the others from one at a time.
class HttpServer {
  public:
    /// Gets each connection, on a thread of its own, and returns at the connection's end.
    using Serve = std::function<void(HttpConnection&)>;

    explicit HttpServer(Serve serve) : m_serve(std::move(serve)) {}

    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Keeps the port from other programs without listening, so that connections are refused. port: 0 for any
    /// that is free. Returns the port, or 0 if it cannot be had.
    int hold(const std::string& host, int port);
    /// Listens on the port that hold() took. Returns false if another program listens there. After close() it
    /// may be called again.
    bool open();

    /// No byte is sent from here on.
    void silence() { m_isSilent = true; }

    bool isSilent() const { return m_isSilent; }

    /// Falls silent, closes the port and all connections, and joins their threads.
    void close();

  private:
    void acceptAndServe();

    Serve m_serve;
    std::atomic<bool> m_isSilent = false;
    sockaddr_storage m_address{};
    socklen_t m_addressBytes = 0;
    int m_holder = -1;
    int m_listening = -1;
    std::vector<std::jthread> m_threads;
};

} // namespace spherewalk::practice
