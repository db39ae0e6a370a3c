// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_prediction.h"

#include "spherewalk/measure/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::jobs {

namespace {

constexpr double kAlongShare = 0.3; ///< of an offset along the axis, at half way to the picture's edge
constexpr double kLeastAcrossM = 0.01;
constexpr double kNearM = 0.5;    ///< at which a view that was left out counts half as much
constexpr double kTurnRad = 0.35; ///< likewise, a third of a usual field of view

constexpr std::size_t kEnoughThings = 30;

double nearness(const ViewLikeness& from, const ViewLikeness& view) {
    const double apart = (from.at() - view.at()).norm() / kNearM;
    return std::exp2(-apart * apart);
}

double weight(const ViewLikeness& from, const ViewLikeness& view) {
    const double turned = std::acos(std::clamp(from.axis().dot(view.axis()), -1.0, 1.0)) / kTurnRad;
    return nearness(from, view) * std::exp2(-turned * turned);
}

/// How much the way to the thing turns between a camera and the photo, small angles. thing: from the camera.
double parallax(const Eigen::Vector3d& offset, const Eigen::Vector3d& thing) {
    return std::max(kLeastAcrossM, offset.cross(thing.normalized()).norm()) / thing.norm();
}

bool isInFrame(const Eigen::Vector2d& pixel, const CameraModel& camera) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= camera.width() - 1 &&
           pixel.y() <= camera.height() - 1;
}

struct Weighted {
    double value;
    double weight;
};

/// Range: not empty.
double weightedMedian(std::vector<Weighted> values) {
    std::ranges::sort(values, {}, &Weighted::value);
    const double half = 0.5 * std::accumulate(values.begin(), values.end(), 0.0,
                                              [](double sum, const Weighted& w) { return sum + w.weight; });
    double sum = 0;
    for (const Weighted& one : values) {
        sum += one.weight;
        if (sum >= half) {
            return one.value;
        }
    }
    return values.back().value;
}

/// Nothing where too little is known of what the view has in its frame.
std::optional<double> foretoldByThings(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                       const CameraModel& camera) {
    const Eigen::Quaterniond cameraFromRoom = view.roomFromCamera.rotation.conjugate();
    std::vector<Weighted> errors;
    for (const ViewLikeness& from : leaveOneOut.views) {
        const double w = nearness(from, view);
        const Eigen::Vector3d apart = from.at() - view.at();
        for (const SeenThing& thing : from.things) {
            const Eigen::Vector3d seen = apart + thing.at;
            const auto pixel = camera.project(cameraFromRoom * seen);
            if (pixel && isInFrame(*pixel, camera)) {
                errors.push_back(
                    {thing.errorPx * parallax(view.offset, seen) / parallax(from.offset, thing.at), w});
            }
        }
    }
    return errors.size() < kEnoughThings ? std::nullopt : std::optional(weightedMedian(std::move(errors)));
}

std::optional<double> foretoldByViews(const SceneLikeness& leaveOneOut, const ViewLikeness& view) {
    double sum = 0;
    double weights = 0;
    for (const ViewLikeness& from : leaveOneOut.views) {
        const std::optional<double>& found = from.exactMedianPx ? from.exactMedianPx : from.medianPx;
        if (found) {
            const double w = weight(from, view);
            sum += w * *found / std::max(kLeastAcrossM, offsetAcross(from.offset, from.axis()));
            weights += w;
        }
    }
    return weights > 0 ? std::optional(sum / weights * offsetAcross(view.offset, view.axis())) : std::nullopt;
}

} // namespace

double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis) {
    const double along = offset.dot(axis);
    const double across = (offset - along * axis).norm();
    return std::hypot(across, kAlongShare * along);
}

std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                 const CameraModel& camera) {
    const std::optional<double> byThings = foretoldByThings(leaveOneOut, view, camera);
    return byThings ? byThings : foretoldByViews(leaveOneOut, view);
}

std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot,
                                    const CameraModel& camera) {
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
            const std::optional<double> foretold = foretoldPx(*from, view, camera);
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
