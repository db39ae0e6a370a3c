// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_prediction.h"

#include "spherewalk/measure/rank_correlation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr double kAlongShare = 0.3; ///< of an offset along the axis, at half way to the picture's edge
constexpr double kLeastAcrossM = 0.01;
constexpr double kNearM = 0.5;    ///< at which a view that was left out counts half as much
constexpr double kTurnRad = 0.35; ///< likewise, a third of a usual field of view

double weight(const ViewLikeness& from, const ViewLikeness& view) {
    const double apart = (from.at - view.at).norm() / kNearM;
    const double turned = std::acos(std::clamp(from.axis.dot(view.axis), -1.0, 1.0)) / kTurnRad;
    return std::exp2(-apart * apart - turned * turned);
}

} // namespace

double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis) {
    const double along = offset.dot(axis);
    const double across = (offset - along * axis).norm();
    return std::hypot(across, kAlongShare * along);
}

std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view) {
    double sum = 0;
    double weights = 0;
    for (const ViewLikeness& from : leaveOneOut.views) {
        const std::optional<double>& found = from.exactMedianPx ? from.exactMedianPx : from.medianPx;
        if (found) {
            const double w = weight(from, view);
            sum += w * *found / std::max(kLeastAcrossM, offsetAcross(from.offset, from.axis));
            weights += w;
        }
    }
    return weights > 0 ? std::optional(sum / weights * offsetAcross(view.offset, view.axis)) : std::nullopt;
}

std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot) {
    std::vector<Prediction> result;
    for (const SceneLikeness& found : robot.scenes) {
        const auto from = std::find_if(leaveOneOut.scenes.begin(), leaveOneOut.scenes.end(),
                                       [&](const SceneLikeness& s) { return s.scene == found.scene; });
        if (from == leaveOneOut.scenes.end()) {
            continue;
        }
        Prediction prediction;
        prediction.scene = found.scene;
        for (const ViewLikeness& view : found.views) {
            const std::optional<double> foretold = foretoldPx(*from, view);
            const std::optional<double>& px = view.exactMedianPx ? view.exactMedianPx : view.medianPx;
            if (foretold && px) {
                prediction.foretoldPx.push_back(*foretold);
                prediction.foundPx.push_back(*px);
            }
        }
        prediction.rankCorrelation = measure::rankCorrelation(prediction.foretoldPx, prediction.foundPx);
        result.push_back(std::move(prediction));
    }
    return result;
}

} // namespace spherewalk::jobs
