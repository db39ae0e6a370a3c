// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/simulated_survey.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace spherewalk::align {

using test::Random;

namespace {

Eigen::Quaterniond smallTurn(double sigmaRad, Random& random) {
    const Eigen::Vector3d turn = random.vector(sigmaRad);
    return Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
}

double radians(double degrees) {
    return Radians(Degrees(degrees)).value();
}

/// On the walls of a room around the block of stations, some of it on furniture within.
Eigen::Vector3d roomPoint(const Eigen::Vector3d& leastM, const Eigen::Vector3d& greatestM, Random& random) {
    Eigen::Vector3d pM;
    for (int axis = 0; axis < 3; ++axis) {
        pM[axis] = random.uniform(leastM[axis], greatestM[axis]);
    }
    if (random.uniform(0, 1) < 0.8) {
        const int axis = random.integer(0, 2);
        pM[axis] = random.uniform(0, 1) < 0.5 ? leastM[axis] : greatestM[axis];
    }
    return pM;
}

} // namespace

SimulatedSurvey::SimulatedSurvey(const SimulationOptions& options, Random& random) : m_options(options) {
    for (int rail = 0; rail < options.rails; ++rail) {
        for (int stop = 0; stop < options.stops; ++stop) {
            const Eigen::Vector3d positionM =
                options.originM + options.stepM * Eigen::Vector3d(stop, rail, 0);
            plannedPositions.push_back({text("rail ", rail, ", stop ", stop), positionM, rail, stop});
            PhotoPrior photo;
            photo.name = text("R", rail, "S", stop);
            photo.positionM = positionM;
            photo.positionSigmaM = options.positionSigmaM;
            photo.placement = rail;
            photo.stop = stop;
            photo.levelFromPhoto = Eigen::Quaterniond::Identity();
            photos.push_back(photo);
            takenAt.push_back(planned(rail, stop));
        }
    }
    const Eigen::Vector3d endM = plannedPositions.back().positionM;
    const Eigen::Vector3d marginM(random.uniform(0.7, 1.5), random.uniform(0.7, 1.5), 1.2);
    for (int i = 0; i < 60; ++i) {
        m_pointsM.push_back(roomPoint(options.originM - marginM, endM + marginM, random));
    }
}

Eigen::Vector3d SimulatedSurvey::truePositionM(int photo) const {
    const auto index = static_cast<std::size_t>(photo);
    return takenAt[index] >= 0 ? plannedPositions[static_cast<std::size_t>(takenAt[index])].positionM
                               : photos[index].positionM + Eigen::Vector3d(m_options.stepM, 0, 0);
}

void SimulatedSurvey::expose(Random& random) {
    roomFromPhoto.clear();
    for (int i = 0; i < static_cast<int>(photos.size()); ++i) {
        const Eigen::Vector3d offM = random.vector(m_options.positionSigmaM);
        const YawPitchRoll turn{Radians(random.uniform(-3.1, 3.1)), Radians(random.normal(radians(0.5))),
                                Radians(random.normal(radians(0.5)))};
        roomFromPhoto.push_back({rotation(turn), truePositionM(i) + Eigen::Vector3d(offM.x(), offM.y(), 0)});
    }
    choosePairs(random);
}

void SimulatedSurvey::choosePairs(Random& random) {
    const int count = static_cast<int>(photos.size());
    std::set<std::pair<int, int>> pairs;
    for (int a = 0; a < count; ++a) {
        std::vector<std::pair<double, int>> byDistance;
        for (int b = 0; b < count; ++b) {
            const double distanceM = (photos[static_cast<std::size_t>(a)].positionM -
                                      photos[static_cast<std::size_t>(b)].positionM)
                                         .norm();
            if (b != a) {
                byDistance.emplace_back(distanceM, b);
            }
        }
        std::ranges::sort(byDistance);
        byDistance.resize(std::min(byDistance.size(), static_cast<std::size_t>(m_options.nearest)));
        for (int i = 0; i < m_options.further && count > 1; ++i) {
            byDistance.emplace_back(0, random.integer(0, count - 1));
        }
        for (const auto& [distanceM, b] : byDistance) {
            if (a != b) {
                pairs.emplace(std::min(a, b), std::max(a, b));
            }
        }
    }
    estimates.clear();
    for (const auto& [a, b] : pairs) {
        estimates.push_back(estimate(a, b, random));
    }
}

PairEstimate SimulatedSurvey::estimate(int a, int b, Random& random) const {
    const Rigid3 aFromB =
        roomFromPhoto[static_cast<std::size_t>(a)].inverse() * roomFromPhoto[static_cast<std::size_t>(b)];
    const double distanceM = aFromB.translation.norm();
    std::vector<double> movedRad;
    for (const Eigen::Vector3d& pM : m_pointsM) {
        const Eigen::Vector3d fromA = pM - roomFromPhoto[static_cast<std::size_t>(a)].translation;
        const Eigen::Vector3d fromB = pM - roomFromPhoto[static_cast<std::size_t>(b)].translation;
        movedRad.push_back(angleBetween(fromA, fromB).value());
    }
    std::ranges::nth_element(movedRad, movedRad.begin() + 30);

    PairEstimate estimate;
    estimate.a = a;
    estimate.b = b;
    estimate.verdict = PairVerdict::Constraint;
    estimate.inliers = 20 + static_cast<int>(400 * std::exp(-distanceM));
    estimate.inlierShare = 0.5;
    estimate.aFromB = smallTurn(radians(random.uniform(0.05, 0.2)) / std::sqrt(3.), random) * aFromB.rotation;
    estimate.rotationCovariance = Eigen::Matrix3d::Identity() * 1e-5;
    estimate.parallaxRad = movedRad[30] * std::exp(random.normal(0.15)) + std::abs(random.normal(0.001));
    estimate.baselineSigmaRad = radians(random.uniform(1, 4)) * std::max(1., 0.2 / (distanceM + 1e-3));
    if (distanceM > 0.03) {
        estimate.baselineInA =
            smallTurn(estimate.baselineSigmaRad / std::sqrt(2.), random) * aFromB.translation.normalized();
    }
    const double luck = random.uniform(0, 1);
    if (luck < m_options.wrongShare) {
        estimate.baselineInA = random.direction();
        estimate.parallaxRad = random.uniform(0, 0.2);
        if (luck < m_options.wrongShare / 2) {
            estimate.aFromB = random.rotation();
        }
    }
    return estimate;
}

} // namespace spherewalk::align
