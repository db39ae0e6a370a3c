// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/geometry/trajectory.h"

namespace spherewalk {

using test::expectError;

TEST(Trajectory, ReadsPosesWithTheQuaternionsWLast) {
    const Rigid3 pose = parsePose("1 2 3 0 0 0.7071067811865476 0.7071067811865476");
    EXPECT_EQ(pose.translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
    for (const char* bad : {"", "1 2 3", "1 2 3 0 0 0 1 9", "1 2 3 0 0 x 1", "1 2 nan 0 0 0 1"}) {
        expectError(ErrorKind::InvalidInput, "x y z qx qy qz qw", [&] { parsePose(bad); });
    }
    expectError(ErrorKind::InvalidInput, "not a unit quaternion", [] { parsePose("1 2 3 0 0 0 0"); });
}

TEST(Trajectory, ComesBackFromItsFile) {
    const test::TemporaryFolder folder;
    test::Random random(8);
    std::vector<TimedPose> poses;
    for (int i = 0; i < 20; ++i) {
        poses.push_back({1.7e9 + i / 30.0, {random.rotation(), random.vector(1e6)}});
    }
    writeFile(folder / "path.tum", bytesOf(tumText(poses) + "\r\n  \n"));
    const std::vector<TimedPose> read = readTum(folder / "path.tum");
    ASSERT_EQ(read.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_EQ(read[i].timeS, poses[i].timeS);
        EXPECT_EQ(read[i].roomFromCamera.translation, poses[i].roomFromCamera.translation);
        EXPECT_LT(angleBetween(read[i].roomFromCamera.rotation, poses[i].roomFromCamera.rotation).value(),
                  1e-15);
    }
}

TEST(Trajectory, HasAPoseAtEachTimeAndGoesOnBeyondItsEnds) {
    const auto turned = [](double yaw) { return yawRotation(Radians(yaw)); };
    const std::vector<TimedPose> path{
        {1, {turned(0), {0, 0, 0}}}, {2, {turned(0.4), {1, 0, 0}}}, {4, {turned(0.2), {1, 4, 0}}}};
    const auto expectPose = [&](double timeS, double yaw, const Eigen::Vector3d& at) {
        const Rigid3 pose = poseAt(path, timeS);
        EXPECT_LT(angleBetween(pose.rotation, turned(yaw)).value(), 1e-9) << timeS;
        EXPECT_LT((pose.translation - at).norm(), 1e-12) << timeS;
    };
    expectPose(1, 0, {0, 0, 0});
    expectPose(1.25, 0.1, {0.25, 0, 0});
    expectPose(2, 0.4, {1, 0, 0});
    expectPose(3, 0.3, {1, 2, 0});
    expectPose(4, 0.2, {1, 4, 0});
    expectPose(0.5, -0.2, {-0.5, 0, 0});
    expectPose(4.5, 0.15, {1, 5, 0});
    EXPECT_EQ(poseAt({{7, {turned(1), {1, 2, 3}}}}, 100).translation, Eigen::Vector3d(1, 2, 3));
}

TEST(Trajectory, NamesTheLineThatIsNoPose) {
    const test::TemporaryFolder folder;
    writeFile(folder / "p", bytesOf("# comment\n0 1 2 3 0 0 0 1\n0 1 2\n"));
    expectError(ErrorKind::InvalidInput, "line 3 of", [&] { readTum(folder / "p"); });
    writeFile(folder / "empty", bytesOf("# nothing\n"));
    expectError(ErrorKind::InvalidInput, "holds no pose", [&] { readTum(folder / "empty"); });
}

} // namespace spherewalk
