// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fault_plan.h"
#include "osc_device.h"

#include <httplib.h>

#include <atomic>
#include <functional>
#include <thread>

namespace spherewalk::practice {

/// The device on a TCP port. Serves the sockets itself, so that faults can close them at any byte.
class CameraServer : private httplib::Server {
  public:
    CameraServer(OscDevice& device, const PracticeCameraOptions& options);
    ~CameraServer() override;

    /// Errors: Busy, Network.
    void start();
    void finish();

    int port() const { return m_port; }

    FaultPlan& faults() { return m_faults; }

    PracticeCameraStats stats() const;

  private:
    bool process_and_close_socket(socket_t socket) override;

    void routeCamera();
    void routePractice();
    void servePreview(httplib::Response& response);
    bool sendPicture(std::uint64_t preview, httplib::DataSink& sink);
    void serveFile(const httplib::Request& request, httplib::Response& response);
    bool isRefused(const std::string& call, httplib::Response& response);
    void answer(const std::string& call, httplib::Response& response, const std::function<OscReply()>& act);
    void count(const httplib::Request& request);
    std::string baseUrl(const httplib::Request& request) const;

    OscDevice& m_device;
    const PracticeCameraOptions& m_options;
    FaultPlan m_faults;
    std::atomic<bool> m_stopping = false;
    int m_port = 0;
    mutable std::mutex m_statsMutex;
    PracticeCameraStats m_stats;
    std::jthread m_thread;
};

} // namespace spherewalk::practice
