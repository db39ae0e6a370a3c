// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_trade.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

TEST(AlignmentError, TakesTheCommonYawOffAndTellsYawFromTilt) {
    test::Random random(31);
    SCOPED_TRACE(random.seed());
    const Radians common = Degrees(random.uniform(-180, 180));
    const Radians yawSigma = Degrees(0.02);
    const Radians tiltSigma = Degrees(0.05);
    TruePoses truth;
    AlignReport report;
    for (int i = 0; i < 400; ++i) {
        const Eigen::Quaterniond room =
            rotation({Radians(random.uniform(-3.1, 3.1)), Radians(0.01 * random.normal()),
                      Radians(0.01 * random.normal())});
        truth[i] = {room, random.vector()};
        align::SolvedPose pose;
        pose.isSolved = true;
        const Eigen::Quaterniond tilt =
            rotation({Radians(0), tiltSigma * random.normal(), tiltSigma * random.normal()});
        pose.roomFromPhoto.rotation = yawRotation(common + yawSigma * random.normal()) * room * tilt;
        pose.roomFromPhoto.translation =
            truth[i].translation + Eigen::Vector3d(5, 6, 7) + random.vector(0.002);
        pose.sigmaYaw = yawSigma;
        pose.sigmaPitch = tiltSigma;
        pose.sigmaRoll = tiltSigma;
        report.photos.emplace_back().photo = i;
        report.photos.back().pose = pose;
    }
    report.photos[7].pose.isSolved = false;
    report.photos.push_back(report.photos[0]);
    report.photos.back().photo = 1000; // without a truth
    const AlignmentError error = alignmentError(report, truth);
    EXPECT_EQ(error.photos, 399);
    EXPECT_NEAR(error.yawRmsDeg, 0.02, 0.003);
    EXPECT_NEAR(error.tiltRmsDeg, 0.05, 0.005);
    EXPECT_LT(error.commonLeanDeg, 0.01);
    EXPECT_NEAR(error.ownTiltRmsDeg, error.tiltRmsDeg, 0.002);
    EXPECT_NEAR(wrapped(Radians(Degrees(error.commonYawDeg)) - common).value(), 0, 1e-4);
    EXPECT_NEAR(error.yawOverSigma, 1, 0.12);
    EXPECT_NEAR(error.tiltOverSigma, 1, 0.12);
    EXPECT_GT(error.within3Sigma, 0.98);
    EXPECT_NEAR(error.positionRmsM, 0.002, 0.0003);
    EXPECT_GT(error.yawWorstDeg, error.yawRmsDeg);
    EXPECT_EQ(alignmentError(AlignReport(), truth).photos, 0);
}

} // namespace spherewalk::jobs
