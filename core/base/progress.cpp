// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/progress.h"

#include "spherewalk/base/error.h"

#include <algorithm>

namespace spherewalk {

namespace {

class SilentSink : public ProgressSink {
  public:
    void progress(double /*fraction*/, std::string_view /*activity*/) override {}

    void warning(std::string_view /*sentence*/) override {}
};

} // namespace

ProgressSink& noProgress() {
    static SilentSink sink;
    return sink;
}

ProgressStep::ProgressStep(ProgressSink& parent, double begin, double end)
    : m_parent(parent), m_begin(begin), m_end(end) {
}

void ProgressStep::progress(double fraction, std::string_view activity) {
    m_reached = std::max(m_reached, std::clamp(fraction, 0.0, 1.0));
    m_parent.progress(m_begin + (m_end - m_begin) * m_reached, activity);
}

void ProgressStep::warning(std::string_view sentence) {
    m_parent.warning(sentence);
}

std::optional<std::chrono::duration<double>> TimeLeft::at(TimePoint now, double fraction) {
    constexpr double kLeastGained = 0.005; // a step that begins slowly says nothing of the rest
    constexpr int kSeenAtMost = 64;        // in all of the time so far; about half of them are kept
    const auto passed = now - m_start;
    while (m_seen.size() > 1 && m_seen[1].at <= m_start + passed / 2) {
        m_seen.pop_front();
    }
    const Seen begin = m_seen.front();
    if (now - m_seen.back().at >= passed / kSeenAtMost) {
        m_seen.push_back({now, fraction});
    }
    const double gained = fraction - begin.fraction;
    if (fraction < 0.01 || passed < std::chrono::seconds(1) || gained < kLeastGained) {
        return std::nullopt;
    }
    return std::chrono::duration<double>(now - begin.at) * std::max(0.0, 1 - fraction) / gained;
}

void throwIfStopped(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Error(ErrorKind::Stopped, "Stopped on request; what was complete is kept.");
    }
}

} // namespace spherewalk
