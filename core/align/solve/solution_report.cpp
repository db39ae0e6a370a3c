// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solution_report.h"

#include "pairs/pair_geometry.h"
#include "solve/match_selection.h"
#include "solve/pair_normal.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::align {

namespace {

// A pair with fewer matches that agree holds nothing.
constexpr std::size_t kLeastMatches = 8;

void judgeInliers(const ComponentInput& input, const ComponentState& state,
                  const std::vector<PhotoState>& states, SolutionQuality& quality) {
    int judged = 0;
    int agreeing = 0;
    for (const int at : input.candidates.chosen) {
        const UsedPair pair = emptyPair(input.candidates, state.unknowns, input.priors, at);
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        const std::vector<bool>& isInlier = input.candidates.estimates[static_cast<std::size_t>(at)].isInlier;
        UsedMatch match;
        for (std::size_t i = 0; i < isInlier.size(); ++i) {
            if (!isInlier[i] || !usedMatch(input.candidates, at, static_cast<int>(i), match)) {
                continue;
            }
            const Judgement judgement = judge(pair, match, states[a], states[b], state.scale);
            if (judgement == Judgement::AlongBaseline) {
                continue;
            }
            const int wrong = judgement == Judgement::Agrees ? 0 : 1;
            for (const std::size_t photo : {a, b}) {
                ++quality.photos[photo].judged;
                quality.photos[photo].contradicted += wrong;
            }
            ++judged;
            agreeing += 1 - wrong;
        }
    }
    quality.agreeingShare = judged > 0 ? static_cast<double>(agreeing) / judged : 0;
}

} // namespace

SolutionQuality quality(const ComponentInput& input, const ComponentState& state) {
    SolutionQuality made;
    made.photos.resize(state.unknowns.photo.size());
    const std::vector<PhotoState> states = state.unknowns.states();
    judgeInliers(input, state, states, made);
    std::vector<double> squares(made.photos.size(), 0);
    std::vector<double> counts(made.photos.size(), 0);
    std::vector<double> all;
    for (const UsedPair& pair : state.used) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
            const double angle = row.residual * match.sigmaRad;
            all.push_back(angle);
            for (const std::size_t photo : {a, b}) {
                squares[photo] += angle * angle;
                counts[photo] += 1;
            }
        });
        if (pair.matches.size() >= kLeastMatches) {
            ++made.photos[a].pairs;
            ++made.photos[b].pairs;
        }
    }
    for (std::size_t i = 0; i < made.photos.size(); ++i) {
        made.photos[i].residualRad = counts[i] > 0 ? std::sqrt(squares[i] / counts[i]) : 0;
    }
    const double unit = std::max(median([&] {
                                     std::vector<double> sizes;
                                     for (const double angle : all) {
                                         sizes.push_back(std::abs(angle));
                                     }
                                     return sizes;
                                 }()),
                                 1e-12);
    for (double& angle : all) {
        angle /= unit;
    }
    made.residualRad = agreeingScale(std::move(all), 1e6) * unit;
    return made;
}

double report(const ComponentInput& input, Model model, const ComponentState& state,
              const SolutionQuality& quality, bool hasHeading, int component, Alignment& alignment,
              const std::stop_token& stop) {
    const RefinementOptions options = refinementOptions(*input.options, model, state.scale);
    const Uncertainty sigmas =
        uncertainty(state.unknowns, errorDraws(state.unknowns, input.priors, state.used, options, stop));
    const Eigen::Vector3d origin =
        input.priors[static_cast<std::size_t>(state.unknowns.photo.front())].positionM;
    for (std::size_t i = 0; i < state.unknowns.photo.size(); ++i) {
        SolvedPose& pose = alignment.photos[static_cast<std::size_t>(state.unknowns.photo[i])];
        const SolutionQuality::Photo& judged = quality.photos[i];
        const PhotoState where = state.unknowns.state(i);
        pose.component = component;
        pose.constraints = judged.pairs;
        pose.residualRad = judged.residualRad;
        pose.outlierShare = judged.judged > 0 ? static_cast<double>(judged.contradicted) / judged.judged : 1;
        if (judged.pairs == 0) {
            pose.why = "Its matches contradict where the other photos are. Check its position tag.";
            continue;
        }
        pose.isSolved = true;
        pose.why.clear();
        pose.roomFromPhoto.rotation = where.roomFromPhoto.normalized();
        pose.roomFromPhoto.translation = origin + where.positionM;
        pose.lenses = where.lenses;
        pose.lensSigmaM = state.unknowns.lensSigmaM;
        const Vertical up = statedUp(input.priors[static_cast<std::size_t>(state.unknowns.photo[i])]);
        pose.leanFromStated =
            Radians(leanOf(where.roomFromPhoto.normalized() * up.upInPhoto).vectorRad.norm());
        pose.sigmaYaw = Radians(sigmas.photos[i].yawRad);
        pose.sigmaPitch = Radians(sigmas.photos[i].pitchRad);
        pose.sigmaRoll = Radians(sigmas.photos[i].rollRad);
        pose.sigmaOwn = Radians(sigmas.photos[i].ownRad);
        pose.sigmaPositionM = sigmas.photos[i].positionM;
        pose.sigmaOwnPositionM = sigmas.photos[i].ownM;
    }
    if (component == 0) {
        alignment.sigmaCommonYaw = Radians(hasHeading ? sigmas.commonYawRad : std::numbers::pi);
        alignment.sigmaCommonLean = Radians(sigmas.commonLeanRad);
        alignment.residualRad = quality.residualRad;
    }
    return sigmas.commonLeanRad;
}

} // namespace spherewalk::align
