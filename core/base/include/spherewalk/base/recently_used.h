// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace spherewalk {

/// What was made for the keys used last. Threads: any; what is being made is waited for.
template <class Key, class Value>
class RecentlyUsed {
  public:
    explicit RecentlyUsed(std::size_t kept) : m_kept(kept) {}

    /// What make() gave for this key, called if it is not kept any more. Owner: shared, so it may outlive its
    /// place here.
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
    std::list<std::pair<Key, std::shared_ptr<const Value>>> m_entries; ///< most recently used first
};

} // namespace spherewalk
