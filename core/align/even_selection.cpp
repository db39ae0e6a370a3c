// SPDX-License-Identifier: GPL-3.0-or-later
#include "even_selection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace spherewalk::align {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBands = 18; ///< from pole to pole

/// Parts of about the same size: bands of elevation, each cut into as many pieces as it is long.
int partOf(const Eigen::Vector3d& bearing) {
    const double elevation = std::asin(std::clamp(bearing.z(), -1.0, 1.0));
    const int band = std::clamp(static_cast<int>((elevation / kPi + 0.5) * kBands), 0, kBands - 1);
    const double middle = ((band + 0.5) / kBands - 0.5) * kPi;
    const int pieces = std::max(1, static_cast<int>(std::lround(2 * kBands * std::cos(middle))));
    const double turn = (std::atan2(bearing.y(), bearing.x()) / kPi + 1) / 2;
    return band * 2 * kBands + std::clamp(static_cast<int>(turn * pieces), 0, pieces - 1);
}

/// The spots kept so far, found again by where they are.
class Neighbourhood {
  public:
    explicit Neighbourhood(double reachRad) : m_perUnit(1 / std::max(reachRad, 1e-5)) {}

    bool hasNear(const Eigen::Vector3d& bearing, double reachRad) const {
        const Eigen::Vector3i middle = cell(bearing);
        for (int i = 0; i < 27; ++i) {
            const Eigen::Vector3i offset(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const auto [first, last] = m_bearings.equal_range(key(middle + offset));
            if (std::any_of(first, last, [&](const auto& entry) {
                    return (entry.second - bearing).squaredNorm() < reachRad * reachRad;
                })) {
                return true;
            }
        }
        return false;
    }

    void add(const Eigen::Vector3d& bearing) { m_bearings.emplace(key(cell(bearing)), bearing); }

  private:
    Eigen::Vector3i cell(const Eigen::Vector3d& bearing) const {
        return (bearing * m_perUnit).array().floor().cast<int>();
    }

    static std::int64_t key(const Eigen::Vector3i& at) {
        return (static_cast<std::int64_t>(at.x()) << 40) + (static_cast<std::int64_t>(at.y()) << 20) + at.z();
    }

    double m_perUnit;
    std::unordered_multimap<std::int64_t, Eigen::Vector3d> m_bearings;
};

} // namespace

std::vector<int> evenSelection(const std::vector<Spot>& spots, int most) {
    std::vector<int> byStrength(spots.size());
    std::iota(byStrength.begin(), byStrength.end(), 0);
    const auto spot = [&](int i) -> const Spot& { return spots[static_cast<std::size_t>(i)]; };
    std::stable_sort(byStrength.begin(), byStrength.end(),
                     [&](int a, int b) { return spot(a).response > spot(b).response; });
    double widest = 0;
    for (const Spot& each : spots) {
        widest = std::max(widest, each.ownRad);
    }
    Neighbourhood kept(widest);
    std::map<int, int> roundOf;               // of each part, the next
    std::map<int, std::vector<int>> byRounds; // each in order of strength
    for (const int i : byStrength) {
        if (!kept.hasNear(spot(i).bearing, spot(i).ownRad)) {
            kept.add(spot(i).bearing);
            byRounds[roundOf[partOf(spot(i).bearing)]++].push_back(i);
        }
    }
    std::vector<int> selected;
    for (const auto& [round, members] : byRounds) {
        selected.insert(selected.end(), members.begin(), members.end());
    }
    selected.resize(std::min(selected.size(), static_cast<std::size_t>(most)));
    return selected;
}

} // namespace spherewalk::align
