// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/synthetic_survey.h"

#include "pairs/pair_geometry.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::align {

namespace {

Eigen::Vector3d onBox(const Eigen::Vector3d& least, const Eigen::Vector3d& size, FixedRandom& random) {
    // A face by its area.
    const Eigen::Vector3d areas(size.y() * size.z(), size.x() * size.z(), size.x() * size.y());
    double at = random.uniform() * areas.sum();
    int axis = 0;
    while (axis < 2 && at > areas[axis]) {
        at -= areas[axis];
        ++axis;
    }
    Eigen::Vector3d point(random.uniform(), random.uniform(), random.uniform());
    point[axis] = random.uniform() < 0.5 ? 0 : 1;
    return least + point.cwiseProduct(size);
}

Eigen::Vector3d gridCentre(const SyntheticSurveyOptions& options) {
    return {(options.columns - 1) * options.stepM / 2, (options.rows - 1) * options.stepM / 2, 0};
}

// Relative to the south-west corner of the floor. Furniture stands along the walls.
std::vector<Eigen::Vector3d> roomPoints(const SyntheticSurveyOptions& options, FixedRandom& random) {
    std::vector<Eigen::Vector3d> points;
    while (static_cast<int>(points.size()) < options.points) {
        if (options.isPlain) {
            points.emplace_back(0, random.uniform() * options.roomM.y(),
                                random.uniform() * options.roomM.z());
        } else if (random.uniform() < 0.75) {
            points.push_back(onBox(Eigen::Vector3d::Zero(), options.roomM, random));
        } else {
            const double width = 0.4 + random.uniform();
            const Eigen::Vector3d size(width, 0.5, 0.4 + random.uniform());
            const double x = random.uniform() * (options.roomM.x() - width);
            const double y = random.uniform() < 0.5 ? 0 : options.roomM.y() - size.y();
            points.push_back(onBox({x, y, 0}, size, random));
        }
    }
    return points;
}

// What a photo's detector found: the points, each with its own error, in the photo's frame.
struct Found {
    std::vector<int> point;
    std::vector<int> featureOfPoint; // -1: not found
    std::vector<Eigen::Vector3d> bearing;
};

Eigen::Vector3d disturbed(const Eigen::Vector3d& bearing, double sigmaRad, FixedRandom& random) {
    const Eigen::Vector2d error(random.sumNormal() * sigmaRad, random.sumNormal() * sigmaRad);
    return (bearing + tangentBasis(bearing) * error).normalized();
}

Found findPoints(const SyntheticSurveyOptions& options, const std::vector<Eigen::Vector3d>& points,
                 const Rigid3& roomFromPhoto, double sigmaRad, FixedRandom& random) {
    Found found;
    found.featureOfPoint.assign(points.size(), -1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d away = points[i] - roomFromPhoto.translation;
        if (random.uniform() > options.seenShare || away.norm() < 0.2) {
            continue;
        }
        found.featureOfPoint[i] = static_cast<int>(found.point.size());
        found.point.push_back(static_cast<int>(i));
        const Eigen::Vector3d bearing =
            LensPair{options.lensAheadM}.directionTo(roomFromPhoto.rotation.conjugate() * away).normalized();
        found.bearing.push_back(disturbed(bearing, sigmaRad, random));
    }
    return found;
}

// A point of the pattern's next repetition: half a metre on.
int repetitionOf(const std::vector<Eigen::Vector3d>& points, int point, FixedRandom& random) {
    const Eigen::Vector3d wanted = points[static_cast<std::size_t>(point)] + Eigen::Vector3d(0.5, 0.5, 0);
    int best = static_cast<int>(random.below(points.size()));
    for (int draw = 0; draw < 200; ++draw) {
        const auto other = random.below(points.size());
        if ((points[other] - wanted).norm() < (points[static_cast<std::size_t>(best)] - wanted).norm()) {
            best = static_cast<int>(other);
        }
    }
    return best;
}

struct Matched {
    PhotoPair pair;
    std::vector<bool> isRight;
};

Matched match(const SyntheticSurveyOptions& options, const std::vector<Eigen::Vector3d>& points,
              const Found& a, const Found& b, FixedRandom& random) {
    Matched matched;
    for (const int at : random.permutation(static_cast<int>(a.point.size()))) {
        const auto featureA = static_cast<std::size_t>(at);
        if (static_cast<int>(matched.pair.matches.size()) >= options.mostMatches) {
            break;
        }
        int featureB = b.featureOfPoint[static_cast<std::size_t>(a.point[featureA])];
        bool isRight = featureB >= 0;
        const double fate = random.uniform();
        if (fate < options.wrongShare) {
            featureB = static_cast<int>(random.below(b.point.size()));
            isRight = false;
        } else if (featureB >= 0 && fate < options.wrongShare + options.repeatedShare) {
            featureB =
                b.featureOfPoint[static_cast<std::size_t>(repetitionOf(points, a.point[featureA], random))];
            isRight = false;
        }
        // A point that b did not find leaves the shares as they are only if the wrong ones thin out alike.
        if (featureB < 0 || (fate < options.wrongShare && random.uniform() > options.seenShare)) {
            continue;
        }
        matched.pair.matches.push_back({a.bearing[featureA], b.bearing[static_cast<std::size_t>(featureB)],
                                        options.sigmaRad, at, featureB});
        matched.isRight.push_back(isRight);
    }
    return matched;
}

Eigen::Quaterniond randomAttitude(const SyntheticSurveyOptions& options, FixedRandom& random) {
    const double yaw =
        options.hasAnyYaw ? (random.uniform() * 2 - 1) * std::numbers::pi : 0.05 * random.sumNormal();
    return rotation(
        {Radians(yaw), options.tiltSigma * random.sumNormal(), options.tiltSigma * random.sumNormal()});
}

struct RailError {
    Eigen::Vector3d shift;
    double turn;
    Eigen::Vector3d centre;
};

} // namespace

SyntheticSurvey syntheticSurvey(const SyntheticSurveyOptions& options) {
    FixedRandom random(options.seed * 7919 + 17);
    const std::vector<Eigen::Vector3d> points = roomPoints(options, random);
    const Eigen::Vector3d corner =
        Eigen::Vector3d(options.roomM.x() / 2, options.roomM.y() / 2, options.heightM) - gridCentre(options);
    SyntheticSurvey survey;
    std::vector<Found> found;
    const int railsARow = (options.columns + options.stopsARail - 1) / options.stopsARail;
    std::vector<RailError> errors;
    for (int rail = 0; rail < railsARow * options.rows; ++rail) {
        const double x = random.sumNormal() * options.placementSigmaM;
        const double y = random.sumNormal() * options.placementSigmaM;
        const double along = (rail % railsARow + 0.5) * options.stopsARail * options.stepM;
        errors.push_back({{x, y, 0},
                          random.sumNormal() * options.placementSigma.value(),
                          corner + Eigen::Vector3d(along, rail / railsARow * options.stepM, 0)});
    }
    for (int i = 0; i < options.columns * options.rows; ++i) {
        const int column = i % options.columns;
        const int row = i / options.columns;
        PhotoPrior prior;
        prior.name = text("photo ", i + 1);
        prior.placement = row * railsARow + column / options.stopsARail;
        prior.stop = column % options.stopsARail;
        const Eigen::Vector3d planned = corner + options.stepM * Eigen::Vector3d(column, row, 0);
        prior.positionM = options.originM + planned;
        prior.positionSigmaM = std::max(options.positionSigmaM, 0.0005);
        prior.heightSigmaM = std::max(options.heightSigmaM, 0.0002);
        prior.levelFromPhoto = Eigen::Quaterniond::Identity();
        prior.tiltSigma = options.tiltSigma;
        const RailError& error = errors[static_cast<std::size_t>(prior.placement)];
        Rigid3 truth;
        truth.rotation = randomAttitude(options, random);
        truth.translation = error.centre + yawRotation(Radians(error.turn)) * (planned - error.centre) +
                            error.shift +
                            Eigen::Vector3d(options.positionSigmaM * random.sumNormal(),
                                            options.positionSigmaM * random.sumNormal(),
                                            options.heightSigmaM * random.sumNormal());
        const bool isBlurred = options.blurredEvery > 0 && i % options.blurredEvery == 2;
        const double sigmaRad = (isBlurred ? options.blurFactor : 1) * options.sigmaRad;
        found.push_back(findPoints(options, points, truth, sigmaRad, random));
        truth.translation += options.originM;
        survey.roomFromPhoto.push_back(truth);
        survey.photos.push_back(prior);
    }
    const int count = options.columns * options.rows;
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const auto atA = static_cast<std::size_t>(a);
            const auto atB = static_cast<std::size_t>(b);
            if ((survey.photos[atA].positionM - survey.photos[atB].positionM).norm() > options.reachM) {
                continue;
            }
            Matched matched = match(options, points, found[atA], found[atB], random);
            matched.pair.a = a;
            matched.pair.b = b;
            survey.pairs.push_back(std::move(matched.pair));
            survey.isRight.push_back(std::move(matched.isRight));
        }
    }
    return survey;
}

SyntheticPair syntheticPair(const SyntheticSurveyOptions& options, const Eigen::Vector3d& offsetM,
                            const Eigen::Quaterniond& roomFromB) {
    FixedRandom random(options.seed * 104729 + 5);
    const std::vector<Eigen::Vector3d> points = roomPoints(options, random);
    const Rigid3 roomFromA{randomAttitude(options, random),
                           {options.roomM.x() / 2, options.roomM.y() / 2, options.heightM}};
    const Rigid3 roomFromBoth{roomFromB, roomFromA.translation + offsetM};
    const Found a = findPoints(options, points, roomFromA, options.sigmaRad, random);
    const Found b = findPoints(options, points, roomFromBoth, options.sigmaRad, random);
    SyntheticPair made;
    made.pair = match(options, points, a, b, random).pair;
    made.pair.b = 1;
    made.aFromB = roomFromA.rotation.conjugate() * roomFromB;
    made.baselineInA = roomFromA.rotation.conjugate() * offsetM;
    return made;
}

} // namespace spherewalk::align
