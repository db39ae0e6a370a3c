// SPDX-License-Identifier: GPL-3.0-or-later
#include "contest.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::measure {

using SteadyClock = std::chrono::steady_clock;

double quantile(std::vector<double> values, double share) {
    const auto index = std::lround(share * static_cast<double>(values.size() - 1));
    const auto at = values.begin() + index;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

Measured measured(const std::vector<double>& timesMs) {
    const double median = quantile(timesMs, 0.5);
    std::vector<double> deviations;
    deviations.reserve(timesMs.size());
    for (const double time : timesMs) {
        deviations.push_back(std::abs(time - median));
    }
    return {median, quantile(deviations, 0.5)};
}

double millisecondsSince(SteadyClock::time_point begin) {
    return std::chrono::duration<double, std::milli>(SteadyClock::now() - begin).count();
}

void Contest::add(std::string name, std::function<void(int)> action) {
    m_entries.push_back({std::move(name), std::move(action), {}, {}});
}

void Contest::time(Entry& entry, int begin, int end, bool counts, const std::stop_token& stop) {
    for (int run = begin; run < end; ++run) {
        throwIfStopped(stop);
        const auto start = SteadyClock::now();
        entry.action(run);
        const double passedMs = millisecondsSince(start);
        if (counts) {
            entry.timesMs.push_back(passedMs);
        }
    }
}

void Contest::run(int rounds, int block, ProgressSink& progress, std::string_view activity,
                  const std::stop_token& stop) {
    for (Entry& entry : m_entries) {
        entry.timesMs.clear();
    }
    const int end = rounds + block;
    for (int begin = 0; begin < end; begin += block) {
        for (Entry& entry : m_entries) {
            time(entry, begin, std::min(begin + block, end), begin > 0, stop);
        }
        progress.progress(static_cast<double>(std::min(begin + block, end)) / end, activity);
    }
    for (Entry& entry : m_entries) {
        entry.result = measured(entry.timesMs);
    }
}

const Measured& Contest::of(const std::string& name) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.name == name; });
    if (found == m_entries.end()) {
        throw Error(ErrorKind::Internal, text("Nothing was measured under the name ", name, "."));
    }
    return found->result;
}

} // namespace spherewalk::measure
