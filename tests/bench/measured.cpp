// SPDX-License-Identifier: Apache-2.0
#include "measured.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace spherewalk::bench {

namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double nowMs(Clock clock) {
    if (clock == Clock::Processor) {
        return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

} // namespace

void Contest::add(std::string name, std::function<void(int)> action) {
    m_entries.push_back({std::move(name), std::move(action), {}});
}

void Contest::run(int rounds, Clock clock) {
    for (Entry& entry : m_entries) {
        entry.result = {};
    }
    std::vector<std::vector<double>> times(m_entries.size());
    constexpr int kBlock = 10; // in a row, so that each finds the caches as its own runs leave them
    for (int begin = -kBlock; begin < rounds; begin += kBlock) {
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            for (int run = begin; run < std::min(begin + kBlock, rounds); ++run) {
                const double start = nowMs(clock);
                m_entries[i].action(run + kBlock);
                if (run >= 0) {
                    times[i].push_back(nowMs(clock) - start);
                }
            }
        }
    }
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const double middle = median(times[i]);
        std::vector<double> deviations;
        for (const double time : times[i]) {
            deviations.push_back(std::abs(time - middle));
        }
        m_entries[i].result = {middle, median(deviations),
                               *std::min_element(times[i].begin(), times[i].end())};
    }
}

const Measured& Contest::of(const std::string& name) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.name == name; });
    if (found == m_entries.end()) {
        throw std::logic_error("nothing was measured under the name " + name);
    }
    return found->result;
}

void Contest::print() const {
    for (const Entry& entry : m_entries) {
        std::printf("  %-34s %8.3f ms  +- %.3f  least %8.3f\n", entry.name.c_str(), entry.result.medianMs,
                    entry.result.madMs, entry.result.leastMs);
    }
}

} // namespace spherewalk::bench
