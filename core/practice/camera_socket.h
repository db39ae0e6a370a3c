// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <string_view>

namespace spherewalk::practice {

/// A connected socket as the HTTP library wants it, that can be told to drop what is written, and that gives
/// up soon after the server stops.
class CameraSocket : public httplib::Stream {
  public:
    CameraSocket(socket_t socket, const std::atomic<bool>& stopping);
    ~CameraSocket() override;
    CameraSocket(const CameraSocket&) = delete;
    CameraSocket& operator=(const CameraSocket&) = delete;

    /// The socket whose request this thread is answering.
    static CameraSocket& current();

    /// From here on nothing is written any more, and the connection ends with this request.
    void drop() { m_dropped = true; }

    bool isDropped() const { return m_dropped; }

    /// Sends these bytes in place of the answer that follows.
    void answer(std::string_view bytes);

    /// Forgets that an answer was replaced.
    void beginAnswer() { m_isAnswered = false; }

    /// Returns when the client has closed the connection, or the server stops.
    void awaitLeaving() const;

    /// True when there is something to read in time.
    bool awaitRequest(std::chrono::milliseconds timeout) const;

    bool is_readable() const override;
    bool is_writable() const override;
    ssize_t read(char* to, size_t size) override;
    ssize_t write(const char* from, size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    socket_t socket() const override;

    using httplib::Stream::write;

  private:
    bool await(short events, std::chrono::milliseconds timeout) const;

    socket_t m_socket;
    const std::atomic<bool>& m_stopping;
    bool m_dropped = false;
    bool m_isAnswered = false;
};

} // namespace spherewalk::practice
