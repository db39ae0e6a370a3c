// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace spherewalk::bench {

/// Milliseconds of many runs.
struct Measured {
    double medianMs = 0;
    double madMs = 0;   ///< median of the absolute deviations from the median
    double leastMs = 0; ///< what a busy machine disturbs least
};

enum class Clock {
    Wall,
    Processor, ///< of all threads of the program together: what else the machine does counts less
};

/// Several things measured in turns, so that what else the machine does meets all of them alike.
class Contest {
  public:
    void add(std::string name, std::function<void(int run)> action);

    /// Each is run so many times, after ten that do not count.
    void run(int rounds, Clock clock = Clock::Wall);

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
