// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracks.h"

#include "fixed_random.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace spherewalk::align {

namespace {

class Joined {
  public:
    int node(int photo, int feature) {
        const std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(photo)) << 32) |
                                  static_cast<std::uint32_t>(feature);
        const auto [entry, isNew] = m_nodes.try_emplace(key, static_cast<int>(m_root.size()));
        if (isNew) {
            m_root.push_back(entry->second);
        }
        return entry->second;
    }

    int root(int node) {
        auto at = static_cast<std::size_t>(node);
        while (m_root[at] != static_cast<int>(at)) {
            m_root[at] = m_root[static_cast<std::size_t>(m_root[at])];
            at = static_cast<std::size_t>(m_root[at]);
        }
        return static_cast<int>(at);
    }

    void join(int one, int other) {
        const int first = root(one);
        const int second = root(other);
        m_root[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
    }

    int count() const { return static_cast<int>(m_root.size()); }

  private:
    std::unordered_map<std::uint64_t, int> m_nodes;
    std::vector<int> m_root;
};

} // namespace

std::vector<std::vector<int>> tracks(std::span<const PhotoPair> pairs,
                                     std::span<const std::vector<bool>> isUsed) {
    Joined joined;
    std::vector<std::vector<int>> nodes(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PhotoPair& pair = pairs[i];
        nodes[i].assign(pair.matches.size(), -1);
        for (std::size_t j = 0; j < pair.matches.size(); ++j) {
            const Correspondence& match = pair.matches[j];
            if (isUsed[i][j] && match.featureA >= 0 && match.featureB >= 0) {
                nodes[i][j] = joined.node(pair.a, match.featureA);
                joined.join(nodes[i][j], joined.node(pair.b, match.featureB));
            }
        }
    }
    int alone = joined.count();
    for (std::vector<int>& ofPair : nodes) {
        for (int& node : ofPair) {
            node = node < 0 ? alone++ : joined.root(node);
        }
    }
    return nodes;
}

bool isHeldOut(int track, double share) {
    return FixedRandom(0x48454C44ULL + static_cast<std::uint64_t>(track) * 2654435761ULL).uniform() < share;
}

} // namespace spherewalk::align
