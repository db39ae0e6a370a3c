// SPDX-License-Identifier: GPL-3.0-or-later
#include "planned_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kSameHeightM = 0.05;
constexpr double kAtPlaceM = 0.02;

} // namespace

PlannedLines::PlannedLines(std::span<const PlannedPosition> planned)
    : m_planned(planned.begin(), planned.end()), m_places(planned.size()) {
    std::map<std::pair<int, double>, std::vector<int>> byRail;
    for (int i = 0; const PlannedPosition& position : m_planned) {
        if (position.placement >= 0 && position.positionM.allFinite()) {
            byRail[{position.placement, std::round(position.positionM.z() / kSameHeightM)}].push_back(i);
        }
        ++i;
    }
    for (auto& [key, line] : byRail) {
        std::ranges::stable_sort(line, std::less(),
                                 [this](int i) { return m_planned[static_cast<std::size_t>(i)].stop; });
        for (int index = 0; const int i : line) {
            m_places[static_cast<std::size_t>(i)] = {static_cast<int>(m_lines.size()), index++};
        }
        m_lines.push_back(std::move(line));
    }
}

PlannedLines::Place PlannedLines::place(int planned) const {
    return planned < 0 ? Place{} : m_places[static_cast<std::size_t>(planned)];
}

int PlannedLines::tag(const PhotoPrior& photo) const {
    int best = -1;
    std::tuple<bool, double> bestKey;
    for (int i = 0; const PlannedPosition& position : m_planned) {
        const double distanceM = (position.positionM - photo.positionM).norm();
        const std::tuple<bool, double> key = {
            position.placement != photo.placement || position.stop != photo.stop, distanceM};
        if (distanceM < kAtPlaceM && (best < 0 || key < bestKey)) {
            best = i;
            bestKey = key;
        }
        ++i;
    }
    return best;
}

Eigen::Vector3d PlannedLines::positionM(int line, int index) const {
    const std::vector<int>& positions = m_lines[static_cast<std::size_t>(line)];
    const auto at = [&](int i) -> const Eigen::Vector3d& {
        return m_planned[static_cast<std::size_t>(positions[static_cast<std::size_t>(i)])].positionM;
    };
    const int last = static_cast<int>(positions.size()) - 1;
    if (index < 0) {
        return 2 * at(0) - at(1);
    }
    return index > last ? Eigen::Vector3d(2 * at(last) - at(last - 1)) : at(index);
}

} // namespace spherewalk::align
