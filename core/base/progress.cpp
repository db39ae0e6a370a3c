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

std::optional<std::chrono::duration<double>> TimeLeft::at(TimePoint now, double fraction) const {
    const std::chrono::duration<double> passed = now - m_start;
    if (fraction < 0.01 || passed.count() < 1) {
        return std::nullopt;
    }
    return passed * std::max(0.0, 1 - fraction) / fraction;
}

void throwIfStopped(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Error(ErrorKind::Stopped, "Stopped on request; what was complete is kept.");
    }
}

} // namespace spherewalk
