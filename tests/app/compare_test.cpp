// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "flat_room.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk {

using test::CliResult;
using test::FlatRoom;
using test::runCli;
using testing::HasSubstr;

namespace {

/// A dataset, a camera, and the robot's picture redder than it was, some 5 cm and 2 degrees off its true
/// pose.
class Compare : public testing::Test {
  protected:
    Compare() {
        FlatRoom::write(m_folder / "d");
        writeFile(m_folder / "c.yaml",
                  bytesOf("image_width: 320\nimage_height: 240\n"
                          "camera_matrix: {data: [294.6833, 0, 159.5, 0, 294.6833, 119.5, 0, 0, 1]}\n"));
        RgbImage picture = photo::readPicture(FlatRoom::data() / "view_03.png");
        for (std::size_t i = 0; i < picture.values().size(); i += 3) {
            picture.values()[i + 1] = static_cast<std::uint8_t>(picture.values()[i + 1] * 4 / 5);
            picture.values()[i + 2] = static_cast<std::uint8_t>(picture.values()[i + 2] * 3 / 4);
        }
        photo::writePng(m_folder / "red.png", picture);
        writeFile(m_folder / "p.csv",
                  bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\n"
                          "red.png,0.45,0.32,1.11,-0.650191,0.640774,-0.298639,0.275871\n"));
    }

    CliResult compare(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"compare",      path("d"),    "--camera",
                                           path("c.yaml"), "--pictures", path("p.csv")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(Compare, RefinesFitsStoresAndReports) {
    const CliResult result = compare({"--refine-poses", "--fit-colour", "--store", "--poses",
                                      path("poses.csv"), "--report", path("report"), "--json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const Json json = result.json();
    EXPECT_EQ(json["refined"], 1);
    EXPECT_EQ(json["stored"], true);
    EXPECT_LT(json["after"]["median_px"].get<double>(), json["before"]["median_px"].get<double>() / 5);
    EXPECT_LT(json["after"]["colour_error"].get<double>(), json["before"]["colour_error"].get<double>() / 5);
    EXPECT_THAT(readTextFile(path("report") + "/report.html"), HasSubstr("<img"));

    // The dataset's views are corrected now, and the poses that were written are refined.
    const CliResult again =
        runCli({"compare", path("d"), "--camera", path("c.yaml"), "--pictures", path("poses.csv"), "--json"});
    ASSERT_EQ(again.status, 0) << again.errors;
    EXPECT_NEAR(again.json()["after"]["colour_error"].get<double>(),
                json["after"]["colour_error"].get<double>(), 0.1);
    EXPECT_NEAR(again.json()["after"]["median_px"].get<double>(), json["after"]["median_px"].get<double>(),
                0.1);
}

TEST_F(Compare, FailsWithASentenceWhereColoursCannotBeTold) {
    RgbImage grey(320, 240);
    std::fill(grey.values().begin(), grey.values().end(), std::uint8_t{90});
    photo::writePng(m_folder / "red.png", grey);
    const CliResult result = compare({"--fit-colour", "--store"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.output, HasSubstr("only grey"));
    EXPECT_TRUE(parseJson(readTextFile(path("d") + "/dataset.json"), "x")["colour_correction"].is_null());
}

TEST_F(Compare, StoresNothingThatWasNotFitted) {
    EXPECT_EQ(compare({"--store"}).status, 2);
}

} // namespace spherewalk
