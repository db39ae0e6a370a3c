// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace spherewalk::ui {

/// Chooses how large the views of a robot that drives are made: as large as possible at kViewsPerSecond. It
/// learns from the times that views took.
class DrivePace {
  public:
    static constexpr double kViewsPerSecond = 30;
    /// Shares of the camera's width and height, largest first.
    static constexpr std::array<double, 5> kShares{1, 0.75, 0.5, 0.375, 0.25};

    /// Returns the share that the next view is made with.
    double share() const { return kShares[m_step]; }

    /// Notes how long a view of this share took. Ignores what is no time above zero, and shares besides
    /// kShares.
    void took(double share, double seconds);

    /// Forgets all times, as another camera or scene model costs otherwise.
    void forget() { *this = {}; }

  private:
    bool holds(std::size_t step) const;

    std::size_t m_step = 0;
    int m_sinceChange = 0;                          ///< Views of this step since it was chosen.
    std::array<double, kShares.size()> m_seconds{}; ///< Smoothed; 0 for a share without a view.
};

} // namespace spherewalk::ui
