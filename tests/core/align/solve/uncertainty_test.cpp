// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solution_report.h"

#include "spherewalk/base/fixed_random.h"

#include <gtest/gtest.h>

#include <vector>

namespace spherewalk::align {

namespace {

constexpr int kPhotos = 6;

/// Level photos on a grid, and draws of their errors.
struct Drawn {
    Unknowns photos;
    ErrorDraws draws{Eigen::MatrixXd::Zero(3 * kPhotos, kBootstrapDraws),
                     Eigen::MatrixXd::Zero(3 * kPhotos, kBootstrapDraws)};
    FixedRandom random{1};

    Drawn() {
        std::vector<int> indices;
        std::vector<PhotoPrior> priors(kPhotos);
        for (int i = 0; i < kPhotos; ++i) {
            indices.push_back(i);
            priors[static_cast<std::size_t>(i)].positionM = {0.2 * (i % 3), 0.2 * (i / 3), 1.2};
        }
        photos = unknowns(indices, priors, std::vector(kPhotos, Eigen::Quaterniond::Identity()));
    }

    void add(Eigen::MatrixXd& to, int photo, const Eigen::Vector3d& sigmas) {
        for (Eigen::Index draw = 0; draw < kBootstrapDraws; ++draw) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                to(3 * photo + axis, draw) += sigmas[axis] * random.sumNormal();
            }
        }
    }

    Uncertainty sigmas() const { return uncertainty(photos, draws); }
};

} // namespace

TEST(Uncertainty, OfAPhotoGrowsByNoOtherThatIsHardlyKnown) {
    Drawn made;
    for (int i = 0; i < kPhotos; ++i) {
        made.add(made.draws.turn, i, Eigen::Vector3d::Constant(i == 2 ? 0.1 : 0.001));
    }
    const Uncertainty sigmas = made.sigmas();
    for (int i = 0; i < kPhotos; ++i) {
        const PhotoUncertainty& photo = sigmas.photos[static_cast<std::size_t>(i)];
        const double expected = i == 2 ? 0.1 : 0.001;
        EXPECT_NEAR(photo.yawRad, expected, 0.3 * expected) << "photo " << i;
        EXPECT_NEAR(photo.ownRad, expected, 0.4 * expected) << "photo " << i;
    }
    EXPECT_LT(sigmas.commonYawRad, 0.001);
}

TEST(Uncertainty, OfYawHoldsNoTurnThatAllShare) {
    Drawn made;
    for (int i = 0; i < kPhotos; ++i) {
        made.add(made.draws.turn, i, Eigen::Vector3d::Constant(0.001));
    }
    Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(3 * kPhotos, kBootstrapDraws);
    made.add(shared, 0, {0, 0, 0.05});
    for (int i = 0; i < kPhotos; ++i) {
        made.draws.turn.middleRows<3>(3 * i) += shared.topRows<3>();
    }
    const Uncertainty sigmas = made.sigmas();
    EXPECT_NEAR(sigmas.commonYawRad, 0.05, 0.01);
    for (const PhotoUncertainty& photo : sigmas.photos) {
        EXPECT_NEAR(photo.yawRad, 0.001, 0.0003);
    }
}

TEST(Uncertainty, OfAPlaceIsThatOfTheWorseOfFloorAndHeight) {
    Drawn made;
    for (int i = 0; i < kPhotos; ++i) {
        made.add(made.draws.position, i,
                 i < 3 ? Eigen::Vector3d(0.004, 0.004, 0.001) : Eigen::Vector3d(0.001, 0.001, 0.004));
    }
    for (const PhotoUncertainty& photo : made.sigmas().photos) {
        EXPECT_NEAR(photo.positionM, 0.004, 0.0006);
    }
}

} // namespace spherewalk::align
