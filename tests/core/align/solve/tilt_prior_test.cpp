// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"
#include "random.h"
#include "solve/refinement.h"
#include "solve/unknowns.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace spherewalk::align {

namespace {

constexpr double kUpsideDownRad = std::numbers::pi;

Eigen::Vector3d upLeaning(double angleRad, double towardsRad) {
    return {std::sin(angleRad) * std::cos(towardsRad), std::sin(angleRad) * std::sin(towardsRad),
            std::cos(angleRad)};
}

/// One photo that nothing but its prior holds, turned by this.
Unknowns photoAlone(const Eigen::Quaterniond& roomFromPhoto, const std::vector<PhotoPrior>& priors) {
    return unknowns(std::array{0}, priors, std::array{roomFromPhoto});
}

double leanAfterRefining(const Eigen::Quaterniond& start) {
    std::vector<PhotoPrior> priors(1);
    priors[0].levelFromPhoto = Eigen::Quaterniond::Identity();
    Unknowns photo = photoAlone(start, priors);
    RefinementOptions options;
    options.model = Model::Tilt;
    refine(photo, priors, {}, options, noProgress(), {});
    return angleBetween(photo.state(0).roomFromPhoto * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ())
        .value();
}

} // namespace

TEST(TiltPrior, CostsMoreTheFartherAPhotoLeans) {
    double before = -1;
    for (double angle = 0; angle <= kUpsideDownRad; angle += kUpsideDownRad / 64) {
        const double cost = leanOf(upLeaning(angle, 0.7)).vectorRad.norm();
        EXPECT_GT(cost, before) << "at " << angle;
        before = cost;
    }
    EXPECT_NEAR(leanOf(-Eigen::Vector3d::UnitZ()).vectorRad.norm(), kUpsideDownRad, 1e-9);
}

TEST(TiltPrior, LeavesSmallTiltsAsTheyWere) {
    for (const double angle : {0.0, 1e-6, 5e-5, 2e-4, 1e-3, 0.01}) {
        const Eigen::Vector3d up = upLeaning(angle, 2.5);
        EXPECT_LE((leanOf(up).vectorRad - up.head<2>()).norm(), angle * angle * angle) << angle;
    }
}

TEST(TiltPrior, KnowsItsOwnDerivative) {
    test::Random random(71);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d up = random.direction();
        const Lean lean = leanOf(up);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d::Unit(axis);
            const Eigen::Vector2d slope =
                (leanOf(turn(step) * up).vectorRad - leanOf(turn(-step) * up).vectorRad) / 2e-6;
            EXPECT_LT((slope - lean.byTurn.col(axis)).norm(), 1e-5 * (1 + lean.byTurn.norm()))
                << "seed 71, draw " << i << ", up " << up.transpose();
        }
    }
}

TEST(TiltPrior, PullsBackFromUpsideDown) {
    for (const double angle : {kUpsideDownRad, kUpsideDownRad - 1e-9, kUpsideDownRad - 1e-5,
                               kUpsideDownRad - 0.01, 3.0, 2.0, 1.0}) {
        EXPECT_LT(leanAfterRefining(rotation({Degrees(40), Radians(0), Radians(angle)})), 1e-6)
            << "from " << angle;
    }
}

TEST(TiltPrior, BelievesUprightEdgesMoreThanMetadata) {
    PhotoPrior photo;
    photo.levelFromPhoto = turn(Eigen::Vector3d(0.02, 0, 0));
    photo.tiltSigma = Degrees(1);
    photo.seenVertical = Vertical{turn(Eigen::Vector3d(-0.05, 0.01, 0)) * Eigen::Vector3d::UnitZ(), 0.0005};
    EXPECT_EQ(knownUp(photo).upInPhoto, photo.seenVertical->upInPhoto);
    EXPECT_GT(knownUp(photo).sigmaRad, 0.0015); // Walls lean, too.
    EXPECT_LT(knownUp(photo).sigmaRad, 0.0025);
    EXPECT_LT((levelFromPhoto(photo) * photo.seenVertical->upInPhoto - Eigen::Vector3d::UnitZ()).norm(),
              1e-12);
    EXPECT_EQ(statedUp(photo).sigmaRad, photo.tiltSigma.value());
}

TEST(TiltPrior, BelievesMetadataThatUprightEdgesContradict) {
    PhotoPrior photo;
    photo.levelFromPhoto = Eigen::Quaterniond::Identity();
    photo.tiltSigma = Degrees(1);
    photo.seenVertical = Vertical{upLeaning(Radians(Degrees(5.1)).value(), 1), 0.0005};
    EXPECT_EQ(knownUp(photo).upInPhoto, Eigen::Vector3d::UnitZ());
    EXPECT_EQ(knownUp(photo).sigmaRad, photo.tiltSigma.value());
    photo.levelFromPhoto.reset();
    EXPECT_EQ(knownUp(photo).upInPhoto, photo.seenVertical->upInPhoto);
    EXPECT_TRUE(saysUp(photo));
    photo.seenVertical.reset();
    EXPECT_FALSE(saysUp(photo));
    EXPECT_EQ(levelFromPhoto(photo).coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

} // namespace spherewalk::align
