// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/photo/picture_file.h"

namespace spherewalk::jobs {

using test::expectError;

TEST(PositionsCsv, ReadsColumnsInAnyOrderAndIgnoresOthers) {
    const auto positions = parsePositions(
        "\xef\xbb\xbfz_m, note ,file,y_m,x_m\r\n3,\"a, \"\"b\"\"\",\"c d.JPG\",2,1\r\n\r\n", "p.csv");
    ASSERT_EQ(positions.size(), 1U);
    EXPECT_EQ(positions[0].file, "c d.JPG");
    EXPECT_EQ(positions[0].positionM, Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(positions[0].roomFromPhoto);
    EXPECT_EQ(positions[0].line, 2);
}

TEST(PositionsCsv, ReadsYawOrAQuaternionOrNeither) {
    const auto yaw = parsePositions("file,x_m,y_m,z_m,yaw_deg\na,0,0,0,90\nb,0,0,0,\nc,0,0,0\n", "p.csv");
    EXPECT_LT((*yaw[0].roomFromPhoto * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
    EXPECT_FALSE(yaw[1].roomFromPhoto);
    EXPECT_FALSE(yaw[2].roomFromPhoto);
    const auto q =
        parsePositions("file,x_m,y_m,z_m,qw,qx,qy,qz\na,0,0,0,0.5,0.5,-0.5,0.5\nb,0,0,0,,,,\n", "p.csv");
    EXPECT_LT(angleBetween(*q[0].roomFromPhoto, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5)).value(), 1e-15);
    EXPECT_FALSE(q[1].roomFromPhoto);
}

TEST(PositionsCsv, NamesTheColumnOrTheLineThatIsWrong) {
    const std::string head = "file,x_m,y_m,z_m";
    const auto refused = [](const std::string& csv, const std::string& part) {
        expectError(ErrorKind::InvalidInput, part, [&] { parsePositions(csv, "p.csv"); });
    };
    refused("", "p.csv: it is empty");
    refused(head + "\n", "lists no photos");
    refused("file,x_m,z_m\na,1,2\n", "the column y_m is missing");
    refused(head + ",qw,qx\na,0,0,0,1,0\n", "some are missing");
    refused(head + ",yaw_deg,qw,qx,qy,qz\n", "both yaw_deg and");
    refused(head + "\na,0,0,0\nb,0,zero,0\n", "line 3: y_m is \"zero\"");
    refused(head + "\na,0,0\n", "line 2: z_m is \"\"");
    refused(head + "\na,nan,0,0\n", "line 2: x_m is \"nan\"");
    refused(head + "\na,1e300,0,0\n", "x_m");
    refused(head + "\n../a,0,0,0\n", "line 2: \"../a\"");
    refused(head + "\na,0,0,0\na,1,0,0\n", "line 3: a is listed twice");
    refused(head + ",qw,qx,qy,qz\na,0,0,0,1,1,0,0\n", "line 2 of p.csv");
    refused(head + "\n\"a,0,0,0\n", "never closed");
}

TEST(PositionsCsv, CountsLinesThroughQuotedLineBreaks) {
    expectError(ErrorKind::InvalidInput, "line 4: x_m",
                [] { parsePositions("file,x_m,y_m,z_m,note\na,0,0,0,\"two\nlines\"\nb,x,0,0,\n", "p.csv"); });
}

TEST(PositionsCsv, NamesTheFileThatCannotBeRead) {
    const test::TemporaryFolder folder;
    expectError(ErrorKind::NotFound, "none.csv", [&] { readPositions(folder / "none.csv"); });
    writeFile(folder / "p.csv", bytesOf("file,x_m\n"));
    expectError(ErrorKind::InvalidInput, "p.csv", [&] { readPositions(folder / "p.csv"); });
}

TEST(PositionsCsv, KeepsDepthsInTheFolderOfThePhotos) {
    const auto one = parsePositions("file,x_m,y_m,z_m,depth\na,0,0,0,d/a.png\nb,0,0,0,\n", "p.csv");
    EXPECT_EQ(one[0].depthFile, "d/a.png");
    EXPECT_EQ(one[1].depthFile, "");
    for (const char* name : {"/etc/passwd", "../a.png", "d/../../a.png"}) {
        expectError(ErrorKind::InvalidInput, "line 2", [&] {
            parsePositions(std::string("file,x_m,y_m,z_m,depth\na,0,0,0,") + name + "\n", "p.csv");
        });
    }
}

TEST(RobotPictures, AreFoundBesideTheirList) {
    const test::TemporaryFolder folder;
    writeFile(
        folder / "p.csv",
        bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz,depth\na.png,1,2,3,0,1,0,0,d/a.png\nb.png,1,2,3,1,0,0,0,\n"));
    const std::vector<RobotPicture> pictures = readRobotPictures(folder / "p.csv");
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[0].file, folder / "a.png");
    EXPECT_EQ(pictures[0].depthFile, folder / "d/a.png");
    EXPECT_EQ(pictures[0].roomFromCamera.translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(pictures[0].roomFromCamera.rotation.x(), 1);
    EXPECT_TRUE(pictures[1].depthFile.empty());
}

TEST(RobotPictures, NeedARotationEach) {
    const test::TemporaryFolder folder;
    writeFile(folder / "p.csv", bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\na,0,0,0,1,0,0,0\nb,0,0,0,,,,\n"));
    expectError(ErrorKind::InvalidInput, "line 3 states no rotation",
                [&] { readRobotPictures(folder / "p.csv"); });
}

// Only what compares pictures finds the poses of those that show tags.
TEST(RobotPictures, MayLackTheirPosesWhereThatIsAllowed) {
    const test::TemporaryFolder folder;
    writeFile(folder / "p.csv", bytesOf("file\na.png\nb.png\n"));
    const auto bare = readRobotPictures(folder / "p.csv", true);
    ASSERT_EQ(bare.size(), 2U);
    EXPECT_FALSE(bare[0].hasPose || bare[1].hasPose);
    expectError(ErrorKind::InvalidInput, "column x_m is missing",
                [&] { readRobotPictures(folder / "p.csv"); });
    writeFile(folder / "p.csv", bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\na,1,2,3,1,0,0,0\nb,,,,,,,\n"));
    const auto mixed = readRobotPictures(folder / "p.csv", true);
    EXPECT_TRUE(mixed[0].hasPose);
    EXPECT_FALSE(mixed[1].hasPose);
    for (const char* half : {"a,1,2,3,,,,", "a,1,,,,,,", "a,,,,1,0,0,0"}) {
        writeFile(folder / "p.csv", bytesOf(text("file,x_m,y_m,z_m,qw,qx,qy,qz\n", half, "\n")));
        expectError(ErrorKind::InvalidInput, "line 2", [&] { readRobotPictures(folder / "p.csv", true); });
    }
}

TEST(RobotPictures, HaveTheSizeOfTheCamera) {
    const test::TemporaryFolder folder;
    photo::writePng(folder / "a.png", RgbImage(8, 6));
    const RobotPicture picture{folder / "a.png", {}, {}};
    EXPECT_EQ(readRobotPicture(picture, CameraModel(CameraIntrinsics::pinhole(8, 6, 1))).width(), 8);
    expectError(ErrorKind::InvalidInput, "8 x 6 pixels, not the camera's 6 x 8",
                [&] { readRobotPicture(picture, CameraModel(CameraIntrinsics::pinhole(6, 8, 1))); });
    expectError(ErrorKind::NotFound, "none.png", [&] {
        readRobotPicture({folder / "none.png", {}, {}}, CameraModel(CameraIntrinsics::pinhole(8, 6, 1)));
    });
}

} // namespace spherewalk::jobs
