// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/drive_pace.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kBudgetS = 1 / DrivePace::kViewsPerSecond;
constexpr double kRoom = 0.85;     ///< Share of the budget that a larger size may be expected to take.
constexpr double kNewest = 0.2;    ///< Weight of the newest time in the smoothed one.
constexpr int kFewestToShrink = 4; ///< Views before a step down: one late view is no pace.
constexpr int kFewestToGrow = 20;  ///< Views before a step up, as a size that jumps disturbs.
constexpr double kForgets = 0.995; ///< What is remembered of larger sizes a view later: they are tried again.

} // namespace

bool DrivePace::holds(std::size_t step) const {
    const double grown = kShares[step] / kShares[m_step];
    return std::max(m_seconds[step], grown * grown * m_seconds[m_step]) < kRoom * kBudgetS;
}

void DrivePace::took(double share, double seconds) {
    if (!std::isfinite(seconds) || seconds <= 0 || share != kShares[m_step]) {
        return; // of a size that was chosen before
    }
    double& own = m_seconds[m_step];
    own = own > 0 ? (1 - kNewest) * own + kNewest * seconds : seconds;
    for (std::size_t step = 0; step < m_step; ++step) {
        m_seconds[step] *= kForgets;
    }
    ++m_sinceChange;
    if (own > kBudgetS && m_sinceChange >= kFewestToShrink && m_step + 1 < kShares.size()) {
        ++m_step;
        m_seconds[m_step] = 0;
        m_sinceChange = 0;
    } else if (m_step > 0 && m_sinceChange >= kFewestToGrow && holds(m_step - 1)) {
        --m_step;
        m_seconds[m_step] = 0;
        m_sinceChange = 0;
    }
}

} // namespace spherewalk::ui
