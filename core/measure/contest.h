// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::measure {

/// The value that this share of the values does not exceed. Range: at least one value, share in [0, 1].
double quantile(std::vector<double> values, double share);

/// Range: at least one time.
Measured measured(const std::vector<double>& timesMs);

double millisecondsSince(std::chrono::steady_clock::time_point begin);

/// Collects what the reports of views say.
class PartsOfViews {
  public:
    void add(const render::ViewReport& report) {
        m_drawMs.push_back(report.renderMs);
        m_decodeMs.push_back(report.decodeMs);
    }

    /// Range: at least one view.
    ViewParts median() const { return {quantile(m_drawMs, 0.5), quantile(m_decodeMs, 0.5)}; }

  private:
    std::vector<double> m_drawMs;
    std::vector<double> m_decodeMs;
};

/// Several things measured in turns, so that what else the machine does meets all of them alike.
class Contest {
  public:
    /// action: what is timed; run counts from 0.
    void add(std::string name, std::function<void(int run)> action);

    /// Each is run so many times, `block` times in a row, so that it finds the caches as its own runs leave
    /// them; one block each does not count. Errors: Stopped, between two runs; those of the actions.
    void run(int rounds, int block, ProgressSink& progress, std::string_view activity,
             const std::stop_token& stop);

    /// Errors: Internal if nothing has this name.
    const Measured& of(const std::string& name) const;

  private:
    struct Entry {
        std::string name;
        std::function<void(int)> action;
        std::vector<double> timesMs;
        Measured result;
    };

    static void time(Entry& entry, int begin, int end, bool counts, const std::stop_token& stop);

    std::vector<Entry> m_entries;
};

} // namespace spherewalk::measure
