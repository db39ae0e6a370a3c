// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using test::writeSmallCamera;
using testing::HasSubstr;

TEST(MeasureCommand, ExportsASurveyMeasuresItAndReusesBoth) {
    const test::PhotographedSurvey survey;
    const std::string camera = writeSmallCamera(survey / "c.yaml");
    const std::vector<std::string> arguments{
        "measure",  survey.path(), "--camera",         camera, "--scene", "sphere", "--views", "3",
        "--report", survey / "r",  "--sampling-views", "1",    "--json"};
    const CliResult first = runCli(arguments);
    ASSERT_EQ(first.status, 0) << first.errors;
    EXPECT_EQ(first.json()["reused_views"], 0);
    EXPECT_EQ(first.json()["scenes"].size(), 1U);
    EXPECT_EQ(first.json()["rungs"].size(), 5U);
    for (const char* file : {"report.html", "report.pdf", "report.json"}) {
        EXPECT_TRUE(std::filesystem::exists(survey / "r" / file)) << file;
    }
    EXPECT_EQ(runCli(arguments).json()["reused_views"], 3);
}

TEST(MeasureCommand, StoresItsChoiceInADatasetOnly) {
    const test::PhotographedSurvey survey;
    const std::string camera = writeSmallCamera(survey / "c.yaml");
    const CliResult refused = runCli({"measure", survey.path(), "--camera", camera, "--store"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("this is a survey"));
    const std::string dataset = survey / "d";
    ASSERT_EQ(runCli({"export", survey.path(), dataset, "--scene", "sphere"}).status, 0);
    const CliResult stored =
        runCli({"measure", dataset, "--camera", camera, "--views", "3", "--sampling-views", "1",
                "--tolerance", "900", "--cache", survey / "cache", "--store"});
    ASSERT_EQ(stored.status, 0) << stored.errors;
    EXPECT_THAT(stored.output, HasSubstr("Stored the choice"));
    const CliResult viewed = runCli({"view", dataset, "--camera", camera, "--pose",
                                     "2 2 1.3 -0.5 0.5 -0.5 0.5", "--out", survey / "v.png", "--json"});
    ASSERT_EQ(viewed.status, 0) << viewed.errors;
    const Json choice = parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json")["choice"];
    EXPECT_EQ(viewed.json()["scene"], choice["scene"]);
    EXPECT_EQ(choice["tolerance_px"], 900);
    EXPECT_THAT(stored.output, HasSubstr(choice["reason"].get<std::string>()));
}

TEST(GridStudyCommand, SaysWhatBlockItNeeds) {
    const test::PhotographedSurvey survey(2);
    const CliResult result =
        runCli({"grid-study", survey.path(), "--camera", writeSmallCamera(survey / "c.yaml"), "--no-depth"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("5 x 5 best"));
}

} // namespace spherewalk
