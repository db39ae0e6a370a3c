// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure_comparison.h"

#include "spherewalk/jobs/measure_report.h"

#include <map>

namespace spherewalk::jobs {

/// The value that this share of them does not exceed, in pixels; nothing if there are none.
std::optional<double> quantilePx(std::vector<int> hundredths, double share);

/// Views of one scene model, put together.
class SceneSummary {
  public:
    SceneSummary(render::SceneKind scene, render::Sampling sampling, Places places);

    /// view: all but what the comparison says.
    void add(const Comparison& comparison, ViewLikeness view);
    SceneLikeness result() const;

  private:
    Places m_places;
    SceneLikeness m_result;
    std::vector<int> m_matched;
    std::vector<int> m_exact;
    std::map<std::size_t, std::vector<int>> m_ofPhotos;
};

/// What the samplings do to views, put together.
class SamplingSummary {
  public:
    void add(const SamplingErrors& errors);

    /// An error that was found with one sampling as it would be with another: what samplings do comes on top
    /// of it, in another direction each time. Nothing if it is not known.
    std::optional<double> errorWith(render::Sampling sampling, render::Sampling usual,
                                    const std::optional<double>& usualPx) const;

  private:
    SamplingErrors m_errors;
};

ShownView shownView(const ViewLikeness& likeness, Places places, const RgbImage& truth, const RgbImage& view);

} // namespace spherewalk::jobs
