// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_diagnostics.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <numeric>

namespace spherewalk::ros {

using simulator::CameraCounters;

namespace {

std::uint64_t sum(const simulator::Refusals::Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::string waitingFor(const CameraCounters& counters, const NodeOptions& options) {
    return counters.poses == 0
               ? text("waiting for transforms from ", options.roomFrame, " to ", options.cameraFrame)
               : "nobody listens, or no pose comes";
}

} // namespace

void CameraDiagnostics::add(const simulator::Frame& frame) {
    const std::chrono::duration<double, std::milli> latency =
        std::chrono::steady_clock::now() - frame.poseTakenAt;
    m_leastTrust = std::min(m_leastTrust, frame.trust);
    m_worstLatencyMs = std::max(m_worstLatencyMs, latency.count());
    m_photo = frame.view.report.file;
    m_offsetM = frame.view.report.offsetM;
}

Diagnostics CameraDiagnostics::since(const CameraCounters& now, const NodeOptions& options) {
    Diagnostics status;
    const auto put = [&](const std::string& key, const std::string& value) {
        status.values.emplace_back(key, value);
    };
    const auto warn = [&](std::uint64_t count, const std::string& what) {
        put(what, text(count));
        if (count > 0) {
            status.message += text(status.message.empty() ? "" : "; ", count, " ", what);
            status.level = 1;
        }
    };
    const std::uint64_t frames = now.frames - m_last.frames;
    put("frames", text(frames));
    warn(sum(now.refused) - sum(m_last.refused), "refused");
    warn(now.dropped - m_last.dropped, "left out");
    warn(now.overlaysMissing - m_last.overlaysMissing, "without overlay");
    warn(now.outside - m_last.outside, "from outside the room");
    // A new camera begins to count anew.
    put("late", text(now.stream.late - std::min(now.stream.late, m_last.stream.late)));
    if (frames > 0) {
        put("least trust", fixed(m_leastTrust, 3));
        put("worst latency ms", fixed(m_worstLatencyMs, 1));
        put("photo", m_photo);
        put("offset m", fixed(m_offsetM, 3));
    }
    put("restarts so far", text(now.restarts));
    for (std::size_t kind = 0; kind < simulator::kRefusalKinds; ++kind) {
        put(text("refused so far: ", name(static_cast<simulator::Refusal>(kind))), text(now.refused[kind]));
    }
    if (status.message.empty()) {
        status.message = frames > 0 ? "giving frames" : waitingFor(now, options);
    }
    *this = {};
    m_last = now;
    return status;
}

} // namespace spherewalk::ros
