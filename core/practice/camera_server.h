// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "digest_gate.h"
#include "fault_plan.h"
#include "osc_device.h"
#include "outages.h"

#include <httplib.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace spherewalk::practice {

/// The device on a TCP port. Serves the sockets itself, so that faults can close them at any byte.
class CameraServer : private httplib::Server {
  public:
    CameraServer(OscDevice& device, FaultPlan& faults, const PracticeCameraOptions& options);
    ~CameraServer() override;

    /// Errors: Busy, Network.
    void start();
    void finish();

    int port() const { return m_port; }

    PracticeCameraStats stats() const;

  private:
    using Act = std::function<OscReply()>;

    bool process_and_close_socket(socket_t socket) override;
    void listen();
    void fallSilent();
    void endure(const Fault& outage, const std::stop_token& stop);

    void routeCamera();
    void routePractice();
    void answerUnknown(const httplib::Request& request, httplib::Response& response);
    void execute(const httplib::Request& request, httplib::Response& response);
    /// Counts the request and lets it in or asks for a password.
    bool admits(const httplib::Request& request, httplib::Response& response);
    /// Whether a fault keeps the call from being done.
    bool isRefused(const std::string& call, httplib::Response& response);
    bool isHit(const std::string& call);
    void answer(const std::string& call, httplib::Response& response, const Act& act);
    void deliver(const std::string& call, const OscReply& given, httplib::Response& response);

    void servePreview(httplib::Response& response);
    bool sendPicture(std::uint64_t preview, httplib::DataSink& sink);
    void serveFile(const std::optional<std::filesystem::path>& path, bool isThumb,
                   httplib::Response& response);
    void sendFile(std::shared_ptr<Bytes> bytes, httplib::Response& response);

    void count(const httplib::Request& request);
    std::string baseUrl(const httplib::Request& request) const;

    OscDevice& m_device;
    FaultPlan& m_faults;
    const PracticeCameraOptions& m_options;
    DigestGate m_gate;
    std::atomic<bool> m_stopping = false; ///< no socket is served any longer
    int m_port = 0;
    mutable std::mutex m_statsMutex;
    PracticeCameraStats m_stats;
    PortHolder m_holder;
    std::jthread m_thread;
    Outages m_outages; ///< last: its thread uses the others
};

} // namespace spherewalk::practice
