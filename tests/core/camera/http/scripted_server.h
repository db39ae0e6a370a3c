// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace spherewalk::test {

struct ServerRequest {
    std::string method;
    std::string path;
    std::string body;
    std::string head; ///< request line and headers
    int connection = 0;
};

/// What the server does with the connection after it has read a request whole.
struct ServerAction {
    enum class Then { KeepAlive, Close, Stall };

    std::string bytes; ///< sent as they are
    Then then = Then::KeepAlive;
};

std::string httpAnswer(int status, const std::string& contentType, const std::string& body);
ServerAction answerJson(const std::string& json, int status = 200);
ServerAction answerOsc(const std::string& errorCode, int status);
ServerAction answerPage(int status = 200);
ServerAction closeSilently();
/// Sends nothing and keeps the connection open until the client leaves.
ServerAction neverAnswer();

/// A TCP server on 127.0.0.1 whose every byte is in the test's hands, so that faults of the connection are
/// exact. The handler is called for one request at a time.
class ScriptedServer {
  public:
    using Handler = std::function<ServerAction(const ServerRequest&)>;

    explicit ScriptedServer(Handler handler);
    ~ScriptedServer();
    ScriptedServer(const ScriptedServer&) = delete;
    ScriptedServer& operator=(const ScriptedServer&) = delete;

    int port() const { return m_port; }

    std::string address() const;
    /// Requests that were read whole.
    int count(const std::string& path) const;
    int connections() const;
    /// Returns when so many requests to the path have been read; false after ten seconds without.
    bool waitForCount(const std::string& path, int atLeast) const;

  private:
    void accept(const std::stop_token& stop);
    void serve(int descriptor, int connection, const std::stop_token& stop);
    ServerAction handle(const ServerRequest& request);

    Handler m_handler;
    int m_listener = -1;
    int m_port = 0;
    mutable std::mutex m_mutex;
    mutable std::condition_variable m_counted;
    std::map<std::string, int> m_counts;
    int m_connections = 0;
    std::mutex m_handling;
    std::list<std::jthread> m_serving;
    std::jthread m_accepting;
};

} // namespace spherewalk::test
