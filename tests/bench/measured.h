// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace spherewalk::bench {

/// Milliseconds of many runs.
struct Measured {
    double medianMs = 0;
    double madMs = 0; ///< median of the absolute deviations from the median
};

/// Several things measured in turns, so that what else the machine does meets all of them alike.
class Contest {
  public:
    void add(std::string name, std::function<void(int run)> action);

    /// Each is run so many times, after ten that do not count.
    void run(int rounds);

    const Measured& of(const std::string& name) const;
    void print() const;

  private:
    struct Entry {
        std::string name;
        std::function<void(int)> action;
        Measured result;
    };

    std::vector<Entry> m_entries;
};

} // namespace spherewalk::bench
