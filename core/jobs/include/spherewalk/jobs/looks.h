// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/compare/line_shape.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// How a view looks beside the true picture.
struct Looks {
    double psnrDb = 0;      ///< Range: at most 99.
    double ssim = 0;        ///< compare::structuralSimilarity().
    double falseEdges = 0;  ///< Share of the view's edge pixels, as compare::edgeAgreement() has it.
    double missedEdges = 0; ///< Share of the truth's edge pixels.
    /// Root mean square distance of the truth's straight lines from straight ones in the view, in pixels.
    /// Nothing if the view shows none of them.
    std::optional<double> bendPx;
    std::size_t lines = 0;      ///< Number of straight lines in the truth.
    std::size_t linesFound = 0; ///< Number of those that the view shows.
};

/// How the view looks beside the truth. lines: what compare::straightLines() finds in the truth. Errors:
/// InvalidInput if the sizes differ.
Looks looksOf(const RgbImage& truth, const std::vector<compare::PictureLine>& lines, const RgbImage& view);

/// The looks that toJson() wrote. Errors: Corrupt, with the member's path.
Looks looksOf(const JsonReader& reader);

/// The looks of several views.
struct LooksSummary {
    Looks mean;  ///< Lines are counted together; bendPx is the mean of the views that have one.
    Looks worst; ///< The worst of each figure, from whichever view; lines are those of `mean`.
    std::size_t views = 0;
};

/// Zeros without views.
LooksSummary summaryOf(const std::vector<Looks>& looks);

/// How much worse one row of views looks than another of the same places.
struct PairedDifference {
    double mean = 0;
    double margin = 0; ///< What a difference must pass: two standard errors, but at least 0.005.

    bool isWorse() const { return mean > margin; }
};

/// Views of one scene model beside those of another, view by view.
struct LooksBeside {
    std::size_t views = 0;
    PairedDifference ssim;       ///< By how much the SSIM is lower.
    PairedDifference falseEdges; ///< By how much the share of false edges is higher.

    bool isWorse() const { return ssim.isWorse() || falseEdges.isWorse(); }
};

/// Nothing for fewer than four views, because their spread is not known, and for lists of other lengths.
/// Views at one place count as if they were independent.
std::optional<LooksBeside> looksBeside(const std::vector<Looks>& views, const std::vector<Looks>& others);

Json toJson(const Looks& looks);

/// Adds the members of toJson() to an object, each with the prefix before its name.
void putLooks(Json& object, std::string_view prefix, const Looks& looks);

/// The titles of the columns that looksCells() fills.
const std::vector<std::string>& looksTitles();

/// PSNR, SSIM, false and missed edges in percent, and the bend of lines.
std::vector<std::string> looksCells(const Looks& looks);

} // namespace spherewalk::jobs
