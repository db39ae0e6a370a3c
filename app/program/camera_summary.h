// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <chrono>
#include <string>
#include <vector>

namespace spherewalk::program {

/// How long frames took from the arrival of their poses to being handed over, of the latest ones. Threads:
/// one at a time.
class Latencies {
  public:
    void add(std::chrono::duration<double, std::milli> latency);

    /// Milliseconds that this share of the frames took at most; 0 without any. Range: share in [0, 1].
    double quantile(double share) const;

  private:
    static constexpr std::size_t kKept = 65536;

    std::vector<double> m_latest;
    std::size_t m_next = 0;
};

/// What a camera in a simulator did, for people at its end.
std::string summary(const simulator::CameraCounters& counters, const Latencies& latencies);

Json toJson(const simulator::CameraCounters& counters, const Latencies& latencies);

} // namespace spherewalk::program
