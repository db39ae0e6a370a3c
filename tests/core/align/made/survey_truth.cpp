// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value * value;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
}

} // namespace

SurveyErrors errorsOf(const Alignment& alignment, const std::vector<Rigid3>& truth, int component) {
    SurveyErrors errors;
    std::vector<const SolvedPose*> poses;
    std::vector<Eigen::Vector3d> leans; // in the room's frame
    Eigen::Vector3d commonLean = Eigen::Vector3d::Zero();
    double sine = 0;
    double cosine = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const SolvedPose& pose = alignment.photos[i];
        if (!pose.isSolved || pose.component != component) {
            continue;
        }
        const YawPitchRoll is = yawPitchRoll(pose.roomFromPhoto.rotation);
        const YawPitchRoll should = yawPitchRoll(truth[i].rotation);
        errors.yaw.push_back((is.yaw - should.yaw).value());
        errors.pitch.push_back(wrapped(is.pitch - should.pitch).value());
        errors.roll.push_back(wrapped(is.roll - should.roll).value());
        sine += std::sin(errors.yaw.back());
        cosine += std::cos(errors.yaw.back());
        poses.push_back(&pose);
        leans.push_back(pose.roomFromPhoto.rotation *
                        (truth[i].rotation.conjugate() * Eigen::Vector3d::UnitZ()));
        commonLean += leans.back();
    }
    errors.solved = static_cast<int>(poses.size());
    errors.commonYaw = std::atan2(sine, cosine);
    std::vector<double> yawRatios;
    std::vector<double> tiltRatios;
    int within = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        errors.yaw[i] = wrapped(Radians(errors.yaw[i] - errors.commonYaw)).value();
        errors.yawWorst = std::max(errors.yawWorst, std::abs(errors.yaw[i]));
        yawRatios.push_back(errors.yaw[i] / poses[i]->sigmaYaw.value());
        tiltRatios.push_back(errors.pitch[i] / poses[i]->sigmaPitch.value());
        tiltRatios.push_back(errors.roll[i] / poses[i]->sigmaRoll.value());
        for (const double ratio : {yawRatios.back(), tiltRatios[2 * i], tiltRatios[2 * i + 1]}) {
            within += std::abs(ratio) < 3 ? 1 : 0;
        }
    }
    errors.yawRms = rootMeanSquare(errors.yaw);
    errors.tiltRms = std::hypot(rootMeanSquare(errors.pitch), rootMeanSquare(errors.roll)) / std::sqrt(2.0);
    for (const Eigen::Vector3d& lean : leans) {
        const double apart = (lean - commonLean / static_cast<double>(leans.size())).norm();
        errors.tiltApartRms += apart * apart / 2 / static_cast<double>(leans.size());
    }
    errors.tiltApartRms = std::sqrt(errors.tiltApartRms);
    errors.ratioYaw = rootMeanSquare(yawRatios);
    errors.ratioTilt = rootMeanSquare(tiltRatios);
    errors.within3 = within / (3.0 * std::max(errors.solved, 1));
    return errors;
}

Alignment solveSurvey(const SyntheticSurvey& survey, const SolveOptions& options) {
    return solve(survey.photos, survey.pairs, estimatePairs(survey.pairs), options, noProgress(), {});
}

} // namespace spherewalk::align
