// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/jobs/practice_pictures.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <cmath>

namespace spherewalk::jobs {

namespace {

const CameraModel& camera() {
    static const CameraModel model(CameraIntrinsics::pinhole(64, 48, 1.2));
    return model;
}

std::vector<TimedPose> path() {
    std::vector<TimedPose> poses;
    for (const double turn : {0.3, 2.9, -1.7}) {
        poses.push_back({0, {yawRotation(Radians(turn)) * bodyFromOptical(), {2.1, 1.9 + 0.1 * turn, 1.1}}});
    }
    return poses;
}

} // namespace

TEST(PracticePictures, AreWhatMeasuringReads) {
    const test::TemporaryFolder folder;
    const practice::PracticeRoom room;
    drawPracticePictures(room, camera(), path(), folder / "drawn", noProgress(), {});
    const std::vector<RobotPicture> pictures = readRobotPictures(folder / "drawn" / "pictures.csv");
    ASSERT_EQ(pictures.size(), path().size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Rigid3 pose = path()[i].roomFromCamera;
        EXPECT_LT((pictures[i].roomFromCamera.translation - pose.translation).norm(), 1e-9);
        EXPECT_LT(pictures[i].roomFromCamera.rotation.angularDistance(pose.rotation), 1e-7);
        EXPECT_EQ(readRobotPicture(pictures[i], camera()), room.view(camera(), pose));
        const DepthImage stored = photo::readDepthPng(pictures[i].depthFile);
        const DepthImage exact = room.viewDepth(camera(), pose);
        for (std::size_t k = 0; k < exact.values().size(); ++k) {
            ASSERT_NEAR(stored.values()[k], exact.values()[k], 0.00051);
        }
    }
}

TEST(PracticePictures, RefuseAnEmptyPathAndAFolderWithFiles) {
    const test::TemporaryFolder folder;
    const practice::PracticeRoom room;
    test::expectError(ErrorKind::InvalidInput, "no pose",
                      [&] { drawPracticePictures(room, camera(), {}, folder / "drawn", noProgress(), {}); });
    writeFile(folder / "mine.txt", bytesOf("kept"));
    test::expectError(ErrorKind::Exists, "give a new one",
                      [&] { drawPracticePictures(room, camera(), path(), folder.path(), noProgress(), {}); });
    EXPECT_EQ(readTextFile(folder / "mine.txt"), "kept");
}

} // namespace spherewalk::jobs
