// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/looks.h"

#include "parts/report_parts.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/compare/picture_looks.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr double kMostDb = 99;
constexpr std::size_t kFewestBeside = 4;
constexpr double kLeastMargin = 0.005;
constexpr double kMarginErrors = 2; ///< standard errors
constexpr int kMostLines = 1'000'000;

PairedDifference pairedDifference(const std::vector<double>& worseBy) {
    const auto count = static_cast<double>(worseBy.size());
    PairedDifference result;
    for (const double one : worseBy) {
        result.mean += one / count;
    }
    double squares = 0;
    for (const double one : worseBy) {
        squares += (one - result.mean) * (one - result.mean);
    }
    result.margin = std::max(kLeastMargin, kMarginErrors * std::sqrt(squares / (count - 1) / count));
    return result;
}

} // namespace

Looks looksOf(const RgbImage& truth, const std::vector<compare::PictureLine>& lines, const RgbImage& view) {
    const compare::EdgeAgreement edges = compare::edgeAgreement(truth, view);
    const compare::Straightness straight = compare::straightness(view, lines);
    return {std::min(kMostDb, photo::psnr(truth, view)),
            compare::structuralSimilarity(truth, view).value_or(0),
            edges.falseShare,
            edges.missedShare,
            straight.rmsPx,
            straight.lines,
            straight.found};
}

Looks looksOf(const JsonReader& reader) {
    const auto count = [&](std::string_view key) {
        return static_cast<std::size_t>(reader.integer(key, 0, kMostLines));
    };
    Looks looks;
    looks.psnrDb = reader.number("psnr_db");
    looks.ssim = reader.number("ssim");
    looks.falseEdges = reader.number("false_edges");
    looks.missedEdges = reader.number("missed_edges");
    if (!reader.isAbsent("bend_px")) {
        looks.bendPx = reader.number("bend_px");
    }
    looks.lines = count("lines");
    looks.linesFound = count("lines_found");
    return looks;
}

Json toJson(const Looks& looks) {
    return {{"psnr_db", looks.psnrDb},         {"ssim", looks.ssim},
            {"false_edges", looks.falseEdges}, {"missed_edges", looks.missedEdges},
            {"bend_px", orNull(looks.bendPx)}, {"lines", looks.lines},
            {"lines_found", looks.linesFound}};
}

void putLooks(Json& object, std::string_view prefix, const Looks& looks) {
    const Json members = toJson(looks);
    for (const auto& [key, value] : members.items()) {
        object[std::string(prefix) + key] = value;
    }
}

LooksSummary summaryOf(const std::vector<Looks>& looks) {
    LooksSummary result;
    result.views = looks.size();
    if (looks.empty()) {
        return result;
    }
    result.worst.psnrDb = kMostDb;
    result.worst.ssim = 1;
    const auto count = static_cast<double>(looks.size());
    double bends = 0;
    for (const Looks& one : looks) {
        result.mean.psnrDb += one.psnrDb / count;
        result.mean.ssim += one.ssim / count;
        result.mean.falseEdges += one.falseEdges / count;
        result.mean.missedEdges += one.missedEdges / count;
        result.mean.lines += one.lines;
        result.mean.linesFound += one.linesFound;
        result.worst.psnrDb = std::min(result.worst.psnrDb, one.psnrDb);
        result.worst.ssim = std::min(result.worst.ssim, one.ssim);
        result.worst.falseEdges = std::max(result.worst.falseEdges, one.falseEdges);
        result.worst.missedEdges = std::max(result.worst.missedEdges, one.missedEdges);
        if (one.bendPx) {
            result.mean.bendPx = result.mean.bendPx.value_or(0) + *one.bendPx;
            result.worst.bendPx = std::max(result.worst.bendPx.value_or(0), *one.bendPx);
            ++bends;
        }
    }
    if (result.mean.bendPx) {
        *result.mean.bendPx /= bends;
    }
    result.worst.lines = result.mean.lines;
    result.worst.linesFound = result.mean.linesFound;
    return result;
}

std::optional<LooksBeside> looksBeside(const std::vector<Looks>& views, const std::vector<Looks>& others) {
    if (views.size() != others.size() || views.size() < kFewestBeside) {
        return std::nullopt;
    }
    std::vector<double> ssim;
    std::vector<double> falseEdges;
    for (std::size_t i = 0; i < views.size(); ++i) {
        ssim.push_back(others[i].ssim - views[i].ssim);
        falseEdges.push_back(views[i].falseEdges - others[i].falseEdges);
    }
    return LooksBeside{views.size(), pairedDifference(ssim), pairedDifference(falseEdges)};
}

const std::vector<std::string>& looksTitles() {
    static const std::vector<std::string> kTitles{"PSNR dB", "SSIM", "false edges %", "missed edges %",
                                                  "bend px"};
    return kTitles;
}

std::vector<std::string> looksCells(const Looks& looks) {
    return {fixed(looks.psnrDb, 2), fixed(looks.ssim, 3), fixed(100 * looks.falseEdges, 1),
            fixed(100 * looks.missedEdges, 1), orDash(looks.bendPx)};
}

} // namespace spherewalk::jobs
