// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

namespace spherewalk::test {

/// What happened in which order, in the journal and on the wire together. Threads: any.
class EventLog {
  public:
    void add(const std::string& event) {
        const std::scoped_lock lock(m_mutex);
        m_events.push_back(event);
    }

    std::vector<std::string> events() const {
        const std::scoped_lock lock(m_mutex);
        return m_events;
    }

    /// Only those of the names, in their order.
    std::vector<std::string> only(const std::vector<std::string>& names) const {
        std::vector<std::string> result;
        for (const std::string& event : events()) {
            if (std::find(names.begin(), names.end(), event) != names.end()) {
                result.push_back(event);
            }
        }
        return result;
    }

  private:
    mutable std::mutex m_mutex;
    std::vector<std::string> m_events;
};

} // namespace spherewalk::test
