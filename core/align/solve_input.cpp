// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve_input.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <string>

namespace spherewalk::align {

namespace {

constexpr double kFarthestM = 1e8;

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkPhoto(const PhotoPrior& photo) {
    const std::string whose = text("Photo '", printable(photo.name), "' cannot be aligned: ");
    if (!photo.positionM.allFinite() || photo.positionM.cwiseAbs().maxCoeff() > kFarthestM) {
        refuse(text(whose, "its position is no number within ", kFarthestM, " m. Correct its station."));
    }
    if (!(photo.positionSigmaM >= 0 && photo.positionSigmaM < 10 && photo.heightSigmaM >= 0 &&
          photo.heightSigmaM < 10)) {
        refuse(text(whose, "the uncertainty of its position must be between 0 and 10 m."));
    }
    if (!(photo.tiltSigma.value() >= 0 && photo.tiltSigma.value() < 4)) {
        refuse(text(whose, "the uncertainty of its tilt must be between 0 and 180 degrees."));
    }
    if (photo.levelFromPhoto &&
        !(photo.levelFromPhoto->norm() > 0.99 && photo.levelFromPhoto->norm() < 1.01)) {
        refuse(text(whose, "the tilt that it states is no rotation. Clear its tilt and try again."));
    }
}

void checkEstimate(const PairEstimate& estimate, const PhotoPair& pair, const std::string& which) {
    if (estimate.a != pair.a || estimate.b != pair.b) {
        refuse(text("The estimates do not belong to the pairs: ", which, " differs."));
    }
    if (estimate.verdict != PairVerdict::Constraint) {
        return;
    }
    const double length = estimate.aFromB.norm();
    const bool hasBaseline = !estimate.baselineInA || std::abs(estimate.baselineInA->norm() - 1) < 0.01;
    if (estimate.isInlier.size() != pair.matches.size() || !(length > 0.99 && length < 1.01) ||
        !hasBaseline || !std::isfinite(estimate.baselineSigmaRad) || !std::isfinite(estimate.parallaxRad)) {
        refuse(text("The estimate of ", which, " is damaged. Estimate it again."));
    }
}

} // namespace

void SolveOptions::validate() const {
    if (!(placementSigmaM >= 0 && placementSigmaM <= 10)) {
        refuse(
            text("The uncertainty of a rail's place must be between 0 and 10 m, not ", placementSigmaM, "."));
    }
    if (!(placementSigma.value() >= 0 && placementSigma.value() <= 3.15)) {
        refuse("The uncertainty of a rail's heading must be between 0 and 180 degrees.");
    }
    if (!(heldOutShare > 0 && heldOutShare <= 0.5)) {
        refuse(
            text("The share of held-out matches must be above 0 and at most 0.5, not ", heldOutShare, "."));
    }
    if (threads < 0 || threads > 1024) {
        refuse(text("The number of threads must be between 0 and 1024, not ", threads, "."));
    }
}

void checkInput(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates) {
    if (pairs.size() != estimates.size()) {
        refuse(text("There are ", pairs.size(), " pairs but ", estimates.size(), " estimates."));
    }
    for (const PhotoPrior& photo : photos) {
        checkPhoto(photo);
    }
    const int count = static_cast<int>(photos.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PhotoPair& pair = pairs[i];
        const std::string which = text("the pair of photos ", pair.a, " and ", pair.b);
        if (pair.a < 0 || pair.b <= pair.a || pair.b >= count) {
            refuse(text("There is no such pair of ", count, " photos: ", which, "."));
        }
        checkEstimate(estimates[i], pair, which);
    }
}

} // namespace spherewalk::align
