// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/positions_csv.h"

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

} // namespace spherewalk::jobs
