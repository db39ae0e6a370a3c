// SPDX-License-Identifier: Apache-2.0
#include "measured.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace spherewalk::bench {

namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

void Contest::add(std::string name, std::function<void(int)> action) {
    m_entries.push_back({std::move(name), std::move(action), {}});
}

void Contest::run(int rounds) {
    for (Entry& entry : m_entries) {
        entry.result = {};
    }
    std::vector<std::vector<double>> times(m_entries.size());
    constexpr int kBlock = 10; // in a row, so that each finds the caches as its own runs leave them
    for (int begin = -kBlock; begin < rounds; begin += kBlock) {
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            for (int run = begin; run < std::min(begin + kBlock, rounds); ++run) {
                const auto start = std::chrono::steady_clock::now();
                m_entries[i].action(run + kBlock);
                const std::chrono::duration<double, std::milli> passed =
                    std::chrono::steady_clock::now() - start;
                if (run >= 0) {
                    times[i].push_back(passed.count());
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
        m_entries[i].result = {middle, median(deviations)};
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
        std::printf("  %-34s %8.3f ms  +- %.3f\n", entry.name.c_str(), entry.result.medianMs,
                    entry.result.madMs);
    }
}

} // namespace spherewalk::bench
