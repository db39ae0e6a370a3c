// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "photographed_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

TEST(PrivacyCommand, MarksListsAndRemovesRegions) {
    const test::PhotographedSurvey survey(2);
    const std::string path = survey.path().string();
    const CliResult marked =
        runCli({"privacy", path, "--mark", "R1002.JPG", "--at", "-30,5.5", "--size", "20,12", "--json"});
    ASSERT_EQ(marked.status, 0) << marked.errors;
    const Json region = marked.json()["regions"][0];
    EXPECT_EQ(region["photo"], "R1002.JPG");
    EXPECT_EQ(region["origin"], "marked");
    EXPECT_NEAR(region["azimuth_deg"].get<double>(), -30, 1e-9);
    EXPECT_NEAR(region["height_deg"].get<double>(), 12, 1e-9);
    const CliResult listed = runCli({"privacy", path});
    EXPECT_THAT(listed.output, HasSubstr("1 region in 1 photo will be blurred in all exports."));
    EXPECT_THAT(listed.output,
                HasSubstr("1       R1002.JPG               -30.0, 5.5        20.0 x 12.0     marked"));
    const CliResult exported = runCli({"export", path, survey / "d"});
    EXPECT_THAT(exported.output, HasSubstr("1 face or screen was blurred in 1 photo."));
    EXPECT_EQ(runCli({"check", survey / "d"}).status, 0);
    EXPECT_THAT(runCli({"privacy", path, "--remove", "1"}).output, HasSubstr("0 regions in 0 photos"));
}

TEST(PrivacyCommand, LooksForFacesInNewPhotosOnly) {
    const test::PhotographedSurvey survey(2);
    const std::string path = survey.path().string();
    const CliResult found = runCli({"privacy", path, "--find", "new", "--json"});
    ASSERT_EQ(found.status, 0) << found.errors;
    EXPECT_EQ(found.json()["search"]["photos_searched"], 2);
    EXPECT_THAT(runCli({"privacy", path, "--find", "new"}).output, HasSubstr("Searched 0 photos"));
}

TEST(PrivacyCommand, SaysWhatIsMissingOrWrong) {
    const test::PhotographedSurvey survey(1);
    const std::string path = survey.path().string();
    const auto expectRefused = [&](const std::vector<std::string>& options, const std::string& words) {
        std::vector<std::string> arguments{"privacy", path};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const CliResult result = runCli(arguments);
        EXPECT_EQ(result.status, 1);
        EXPECT_THAT(result.errors, HasSubstr(words));
    };
    expectRefused({"--mark", "R1001.JPG"}, "Say where the region of the photo is");
    expectRefused({"--mark", "R9.JPG", "--at", "0,0", "--size", "5,5"}, "There is no photo R9.JPG");
    expectRefused({"--mark", "R1001.JPG", "--at", "0,95", "--size", "5,5"}, "beyond a pole");
    expectRefused({"--mark", "R1001.JPG", "--at", "0,0", "--size", "5,170"}, "a side of 170 degrees");
    expectRefused({"--remove", "3"}, "no private region 3");
}

} // namespace spherewalk
