// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "device/fault_plan.h"
#include "device/osc_device.h"
#include "server/digest_gate.h"
#include "server/http_server.h"

#include "spherewalk/practice/practice_camera.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace spherewalk::practice {

/// A thread on which the camera is away and comes back, since the threads that serve its port end meanwhile.
class Outages {
  public:
    using Endure = std::function<void(const Fault&, const std::stop_token&)>;

    explicit Outages(Endure endure) : m_endure(std::move(endure)) {}

    ~Outages() { finish(); }

    Outages(const Outages&) = delete;
    Outages& operator=(const Outages&) = delete;

    void start();
    /// Returns at once; outages follow each other. Threads: any.
    void begin(const Fault& outage);
    /// Cuts the current outage short, and joins the thread.
    void finish();

  private:
    void run(const std::stop_token& stop);

    Endure m_endure;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::deque<Fault> m_waiting;
    std::jthread m_thread;
};

/// The device on a TCP port, with all that faults do to its answers.
class CameraServer {
  public:
    CameraServer(OscDevice& device, FaultPlan& faults, const PracticeCameraOptions& options);
    ~CameraServer();
    CameraServer(const CameraServer&) = delete;
    CameraServer& operator=(const CameraServer&) = delete;

    /// Errors: Busy if the port cannot be had.
    void start();
    /// Closes the port and all connections, and ends a running exposure.
    void finish();

    int port() const { return m_port; }

    PracticeCameraStats stats() const;

  private:
    using Act = std::function<OscReply()>;
    using Handle = std::function<void(const http::Request&, HttpConnection&)>;

    void serve(HttpConnection& connection);
    void dispatch(const http::Request& request, HttpConnection& connection);
    void endure(const Fault& outage, const std::stop_token& stop);

    void routeCamera();
    void routePractice();
    void answerUnknown(const http::Request& request, HttpConnection& connection);
    void execute(const http::Request& request, HttpConnection& connection);
    /// Arms the faults of POST /practice/faults. Errors: Corrupt, InvalidInput.
    Json armed(const std::string& script);
    /// Counts the request. Returns true if it may pass; otherwise it is answered with a challenge.
    bool admits(const http::Request& request, HttpConnection& connection);
    /// Returns true if a fault keeps the call from being done. The client then has its answer, or never gets
    /// one.
    bool isRefused(const std::string& call, HttpConnection& connection);
    bool isHit(const std::string& call, HttpConnection& connection);
    void answer(const std::string& call, HttpConnection& connection, const Act& act);
    void deliver(const std::string& call, const OscReply& given, HttpConnection& connection);

    void servePreview(HttpConnection& connection);
    bool sendPicture(std::uint64_t preview, HttpConnection& connection);
    void serveFile(const std::optional<std::filesystem::path>& path, bool isThumb,
                   HttpConnection& connection);
    void sendFile(Bytes bytes, HttpConnection& connection);

    void count(const http::Request& request);
    std::string baseUrl(const http::Request& request) const;

    OscDevice& m_device;
    FaultPlan& m_faults;
    const PracticeCameraOptions& m_options;
    DigestGate m_gate;
    std::map<std::string, Handle> m_handlers; ///< By method and path: "GET /osc/info".
    int m_port = 0;
    mutable std::mutex m_statsMutex;
    PracticeCameraStats m_stats;
    HttpServer m_http;
    Outages m_outages; ///< Last: its thread uses the others.
};

/// Answers as the camera does.
void reply(HttpConnection& connection, const OscReply& answer);

} // namespace spherewalk::practice
