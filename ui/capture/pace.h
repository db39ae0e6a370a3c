// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/survey/plan.h"

#include <chrono>
#include <optional>

namespace spherewalk::ui {

/// How fast photos are taken, and how long the rest will take: at the plan's pace at first, at the
/// operator's own once it is known.
class Pace {
  public:
    static constexpr int kKnown = 3; ///< photos after which the operator's own pace counts

    /// A run begins.
    void begin(Clock::TimePoint now) {
        m_begin = now;
        m_last = now;
        m_photos = 0;
    }

    void photo(Clock::TimePoint now) {
        ++m_photos;
        m_last = now;
    }

    int photos() const { return m_photos; }

    /// Over this run, up to its latest photo; nothing before there are enough.
    std::optional<double> photosAMinute() const {
        const double minutes = std::chrono::duration<double>(m_last - m_begin).count() / 60;
        return m_photos >= kKnown && minutes > 0 ? std::optional(m_photos / minutes) : std::nullopt;
    }

    /// photos, rails: still to be done.
    std::chrono::duration<double> left(int photos, int rails, const survey::PlanOptions& plan) const {
        if (const auto own = photosAMinute()) {
            return std::chrono::duration<double>(60 * photos / *own);
        }
        return std::chrono::duration<double>(photos * plan.secondsPerPhoto +
                                             rails * plan.secondsPerPlacement);
    }

  private:
    Clock::TimePoint m_begin{};
    Clock::TimePoint m_last{};
    int m_photos = 0;
};

} // namespace spherewalk::ui
