// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

TEST(ReviewCommand, RejectsPhotosAndSaysWhatIsStillToTake) {
    const test::PhotographedSurvey survey(2);
    const std::string path = survey.path().string();
    const int before = runCli({"review", path, "--json"}).json()["to_take"];
    const CliResult rejected =
        runCli({"review", path, "--reject", "R1001.JPG", "--note", "someone in it", "--json"});
    ASSERT_EQ(rejected.status, 0) << rejected.errors;
    EXPECT_EQ(rejected.json()["photos"][0]["decision"], "rejected");
    EXPECT_EQ(rejected.json()["photos"][0]["note"], "someone in it");
    EXPECT_EQ(rejected.json()["to_take"], before + 1);
    EXPECT_EQ(runCli({"status", path, "--json"}).json()["rejected_photos"], 1);
    EXPECT_THAT(runCli({"review", path, "--reopen", "R1001.JPG"}).output, HasSubstr("0 rejected, 2 open"));
    EXPECT_EQ(runCli({"review", path, "--accept", "nothing.JPG"}).status, 1);
}

TEST(RetagCommand, MovesAPhotoToTheStationThatIsNamed) {
    const test::PhotographedSurvey survey(2);
    const std::string path = survey.path().string();
    const CliResult moved =
        runCli({"retag", path, "--photo", "R1001.JPG", "--station", "rail 1, stop 3", "--json"});
    ASSERT_EQ(moved.status, 0) << moved.errors;
    EXPECT_EQ(moved.json()["moved"][0]["station"], "rail 1, stop 3");
    EXPECT_EQ(survey.open().chosenPhoto(survey.open().stations().at(2).id)->cameraFileName, "R1001.JPG");
    EXPECT_EQ(runCli({"retag", path, "--photo", "R1002.JPG"}).status, 1);
}

TEST(RetagCommand, SaysThatMovedPhotosAreNoLongerAligned) {
    const test::PhotographedSurvey survey(2);
    const std::string path = survey.path().string();
    const CliResult moved = runCli({"retag", path, "--photo", "R1001.JPG", "--station", "rail 1, stop 2",
                                    "--photo", "R1002.JPG", "--station", "rail 1, stop 1"});
    ASSERT_EQ(moved.status, 0) << moved.errors;
    EXPECT_THAT(moved.errors, HasSubstr("2 photos have left the alignment"));
    EXPECT_EQ(runCli({"check", path}).status, 0);
    const CliResult exported = runCli({"export", path, survey / "d"});
    EXPECT_THAT(exported.errors, HasSubstr("heading of 2 of 2 photos is not known"));
    EXPECT_EQ(runCli({"check", survey / "d"}).status, 0);
}

TEST(AlignCommand, NamesAnImportedPhotoForWhichAnotherStands) {
    const test::PhotographedSurvey survey(1);
    const Eigen::Vector3d at = survey.open().stations().front().station.positionM;
    const Bytes first = readFile(survey / "in/R1001.JPG");
    writeFile(survey / "in/R2000.JPG", jpeg::encode(jpeg::decode(first, "R1001.JPG"), 70));
    writeFile(survey / "q.csv",
              bytesOf(text("file,x_m,y_m,z_m\nR2000.JPG,", at.x(), ",", at.y(), ",", at.z(), "\n")));
    const CliResult imported = runCli(
        {"import", survey.path().string(), "--photos", survey / "in", "--positions", survey / "q.csv"});
    EXPECT_THAT(imported.errors, HasSubstr("R2000.JPG (line 2) and R1001.JPG are both at rail 1, stop 1"));
    EXPECT_THAT(imported.output, HasSubstr("None of them was compared with its neighbours yet"));
    const CliResult aligned = runCli({"align", survey.path().string(), "--effort", "draft"});
    EXPECT_THAT(aligned.errors, HasSubstr("R1001.JPG is left out: R2000.JPG stands for rail 1, stop 1."));
}

TEST(AlignCommand, FailsWhereNothingCouldBeSolved) {
    const test::PhotographedSurvey survey(1);
    const CliResult result = runCli({"align", survey.path().string(), "--effort", "draft"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.output, HasSubstr("How the photos are turned is not known."));
}

} // namespace spherewalk
