// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace spherewalk::align {

/// Elements 0, 1, 2 ... in sets that can be joined. Source: Tarjan 1975, with path halving.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count = 0) : m_parent(count) {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    /// Adds an element with a set of its own.
    int add() {
        m_parent.push_back(count());
        return m_parent.back();
    }

    int count() const { return static_cast<int>(m_parent.size()); }

    /// The element that stands for the whole set of this element.
    int of(int element) {
        while (parent(element) != element) {
            parent(element) = parent(parent(element));
            element = parent(element);
        }
        return element;
    }

    /// Makes one set of two. The set is then named as the second was.
    void join(int element, int into) { parent(of(element)) = of(into); }

  private:
    int& parent(int element) { return m_parent[static_cast<std::size_t>(element)]; }

    std::vector<int> m_parent;
};

} // namespace spherewalk::align
