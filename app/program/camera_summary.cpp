// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/camera_summary.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::program {

void Latencies::add(std::chrono::duration<double, std::milli> latency) {
    if (m_latest.size() < kKept) {
        m_latest.push_back(latency.count());
    } else {
        m_latest[m_next] = latency.count();
        m_next = (m_next + 1) % kKept;
    }
}

double Latencies::quantile(double share) const {
    if (m_latest.empty()) {
        return 0;
    }
    std::vector<double> sorted = m_latest;
    const auto rank =
        static_cast<std::ptrdiff_t>(std::floor(share * static_cast<double>(sorted.size() - 1) + 0.5));
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    return sorted[static_cast<std::size_t>(rank)];
}

std::string summary(const simulator::CameraCounters& counters, const Latencies& latencies) {
    std::string words = text("Gave ", counters.frames, " frames from ", counters.poses, " poses, in ",
                             fixed(latencies.quantile(0.5), 1), " ms from pose to picture (99 of 100 in ",
                             fixed(latencies.quantile(0.99), 1), " ms).");
    const auto add = [&](std::uint64_t count, const char* what) {
        words += count == 0 ? "" : text("\n", count, " ", what);
    };
    add(counters.dropped, "frames were left out since newer ones were due.");
    add(counters.stream.late, "photos were not decoded in time.");
    add(counters.overlaysMissing,
        "frames went without the simulator's objects, whose pictures did not come.");
    add(counters.overlaysUnused, "pictures of objects fitted no frame.");
    add(counters.outside, "frames were from outside of the room.");
    add(counters.restarts, "times the simulation's time went back.");
    for (std::size_t i = 0; i < counters.refused.size(); ++i) {
        const std::string kind = text("inputs were refused: ", name(static_cast<simulator::Refusal>(i)), ".");
        add(counters.refused[i], kind.c_str());
    }
    return words;
}

Json toJson(const simulator::CameraCounters& counters, const Latencies& latencies) {
    Json refused = Json::object();
    for (std::size_t i = 0; i < counters.refused.size(); ++i) {
        refused[std::string(name(static_cast<simulator::Refusal>(i)))] = counters.refused[i];
    }
    return {{"poses", counters.poses},
            {"frames", counters.frames},
            {"dropped", counters.dropped},
            {"restarts", counters.restarts},
            {"outside", counters.outside},
            {"overlays_laid", counters.overlaysLaid},
            {"overlays_missing", counters.overlaysMissing},
            {"overlays_unused", counters.overlaysUnused},
            {"late", counters.stream.late},
            {"refused", refused},
            {"latency_median_ms", latencies.quantile(0.5)},
            {"latency_99_ms", latencies.quantile(0.99)}};
}

} // namespace spherewalk::program
