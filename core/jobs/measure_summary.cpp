// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_summary.h"

#include "report_parts.h"

#include "spherewalk/base/enum_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<Places, 2> kPlaces{{{Places::Features, "features"}, {Places::Pixels, "pixels"}}};
constexpr double kMedian = 0.5;
constexpr double kNearlyAll = 0.95;
constexpr std::size_t kFewestMatches = 20; ///< for a view's median to say something of the view

std::optional<double> meanOf(const std::vector<double>& values) {
    return values.empty() ? std::nullopt
                          : std::optional(std::accumulate(values.begin(), values.end(), 0.0) /
                                          static_cast<double>(values.size()));
}

void append(std::vector<int>& all, const std::vector<int>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

std::string_view name(Places places) {
    return nameOf(kPlaces, places);
}

Places places(std::string_view name) {
    return valueOf(kPlaces, "The kind of places", name);
}

std::optional<double> errorPx(Places places, const std::optional<double>& features,
                              const std::optional<double>& pixels) {
    const bool isFeatures = places == Places::Features;
    const std::optional<double>& wanted = isFeatures ? features : pixels;
    return wanted ? wanted : isFeatures ? pixels : features;
}

std::optional<double> quantilePx(std::vector<int> hundredths, double share) {
    if (hundredths.empty()) {
        return std::nullopt;
    }
    const auto place = std::min(hundredths.size() - 1,
                                static_cast<std::size_t>(share * static_cast<double>(hundredths.size())));
    const auto at = hundredths.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(hundredths.begin(), at, hundredths.end());
    return 0.01 * *at;
}

SceneSummary::SceneSummary(render::SceneKind scene, render::Sampling sampling, Places places)
    : m_places(places) {
    m_result.scene = scene;
    m_result.sampling = sampling;
}

void SceneSummary::add(const Comparison& comparison, ViewLikeness view) {
    view.psnrDb = comparison.psnrDb;
    view.ssim = comparison.ssim;
    view.matches = comparison.matched.size();
    view.medianPx = quantilePx(comparison.matched, kMedian);
    view.p95Px = quantilePx(comparison.matched, kNearlyAll);
    view.exactMedianPx = quantilePx(comparison.exact, kMedian);
    view.exactP95Px = quantilePx(comparison.exact, kNearlyAll);
    view.things = comparison.things;
    append(m_matched, comparison.matched);
    append(m_exact, comparison.exact);
    if (view.leftOut) {
        const bool isExact = m_places == Places::Pixels && !comparison.exact.empty();
        append(m_ofPhotos[*view.leftOut], isExact ? comparison.exact : comparison.matched);
    }
    m_result.views.push_back(std::move(view));
}

SceneLikeness SceneSummary::result() const {
    SceneLikeness result = m_result;
    std::vector<double> medians;
    std::vector<double> unsureMedians; // a handful of matches may all be wrong
    const auto count = static_cast<double>(result.views.size());
    result.worstPsnrDb = std::numeric_limits<double>::max();
    for (const ViewLikeness& view : result.views) {
        result.meanPsnrDb += view.psnrDb / count;
        result.meanSsim += view.ssim / count;
        result.worstPsnrDb = std::min(result.worstPsnrDb, view.psnrDb);
        if (view.medianPx) {
            (view.matches < kFewestMatches ? unsureMedians : medians).push_back(*view.medianPx);
        }
    }
    result.medianPx = meanOf(medians.empty() ? unsureMedians : medians);
    result.p95Px = quantilePx(m_matched, kNearlyAll);
    result.exactMedianPx = quantilePx(m_exact, kMedian);
    result.exactP95Px = quantilePx(m_exact, kNearlyAll);
    for (const auto& [photo, errors] : m_ofPhotos) {
        result.photos.push_back({photo, quantilePx(errors, kNearlyAll), errors.size()});
    }
    return result;
}

void SamplingSummary::add(const SamplingErrors& errors) {
    for (const auto& [sampling, values] : errors) {
        append(m_errors[sampling], values);
    }
}

std::optional<double> SamplingSummary::errorWith(render::Sampling sampling, render::Sampling usual,
                                                 const std::optional<double>& usualPx) const {
    if (sampling == usual || !usualPx) {
        return usualPx;
    }
    const auto own = [&](render::Sampling of) {
        const auto found = m_errors.find(of);
        return found == m_errors.end() ? std::nullopt : quantilePx(found->second, kNearlyAll);
    };
    const std::optional<double> added = own(sampling);
    const std::optional<double> there = own(usual);
    if (!added || !there) {
        return std::nullopt;
    }
    return std::sqrt(std::max(0.0, *usualPx * *usualPx - *there * *there) + *added * *added);
}

ShownView shownView(const ViewLikeness& likeness, Places places, const RgbImage& truth,
                    const RgbImage& view) {
    return {likeness.subject,          likeness.errorPx(places), likeness.psnrDb, truth, view,
            difference(view, truth, 1)};
}

} // namespace spherewalk::jobs
