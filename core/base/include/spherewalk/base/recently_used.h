// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace spherewalk {

/// Keeps the values of the keys that were used last. Threads: any; while one thread makes a value, the others
/// wait.
template <class Key, class Value>
class RecentlyUsed {
  public:
    /// Keeps at most this many values.
    explicit RecentlyUsed(std::size_t kept) : m_kept(kept) {}

    /// The value of this key. make() is called if the value is not kept. Owner: the pointer may outlive the
    /// object.
    template <class Make>
    std::shared_ptr<const Value> get(const Key& key, Make&& make) {
        const std::scoped_lock lock(m_mutex);
        const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                        [&](const auto& entry) { return entry.first == key; });
        if (found != m_entries.end()) {
            m_entries.splice(m_entries.begin(), m_entries, found);
        } else {
            m_entries.emplace_front(key, std::make_shared<const Value>(make()));
            m_entries.resize(std::min(m_entries.size(), m_kept));
        }
        return m_entries.front().second;
    }

  private:
    std::size_t m_kept;
    std::mutex m_mutex;
    std::list<std::pair<Key, std::shared_ptr<const Value>>>
        m_entries; ///< The most recently used entry is the first.
};

} // namespace spherewalk
