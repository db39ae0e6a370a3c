// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <csignal>
#include <map>
#include <set>

namespace spherewalk {

using test::runCli;

// capture is killed at 20 random instants over one survey. At the end every station has the photo that the
// practice camera took there, every picture that the camera has stored is in the survey, and no station was
// exposed twice.
TEST(CaptureKill, TwentyKillsLoseNothingAndMixUpNothing) {
    const test::TemporaryFolder folder;
    test::Random random(20261121);
    SCOPED_TRACE(random.seed());
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.truthFile = folder / "truth.jsonl";
    practice::PracticeCamera camera(options);
    camera.start();
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "0.6"}).status, 0);
    const std::vector<std::string> capture{SPHEREWALK_CLI, "capture",
                                           survey,         "--practice",
                                           "--camera",     "127.0.0.1:" + std::to_string(camera.port()),
                                           "--time-scale", "0.05"};

    int kills = 0;
    int killedBetweenShots = 0;
    while (kills < 20) {
        test::Program program(capture);
        if (program.endsWithin(std::chrono::milliseconds(random.integer(20, 1200)))) {
            ASSERT_EQ(program.wait(), 0) << program.errors();
            break; // complete before the last kill: the survey was too small, which the check below says
        }
        program.signal(SIGKILL);
        program.wait();
        ++kills;
        const auto store = store::SurveyStore::open(survey, store::Access::Read);
        killedBetweenShots += store.openShots().empty() ? 1 : 0;
    }
    EXPECT_EQ(kills, 20);
    EXPECT_LT(killedBetweenShots, 20); // or nothing was interrupted at all
    test::Program last(capture);
    ASSERT_EQ(last.wait(), 0) << last.errors();

    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    EXPECT_TRUE(store.stationsWithoutPhoto().empty());
    EXPECT_TRUE(store.unclearShots().empty());
    const std::vector<store::PhotoRecord> photos = store.photos();
    EXPECT_EQ(photos.size(), store.stations().size());
    const std::vector<practice::Truth> truths = practice::readTruth(folder / "truth.jsonl");
    EXPECT_EQ(truths.size(), photos.size()); // none twice
    std::map<std::string, practice::Truth> truthOf;
    for (const practice::Truth& truth : truths) {
        truthOf[truth.sha256] = truth;
    }
    std::set<std::int64_t> stations;
    for (const store::PhotoRecord& photo : photos) {
        ASSERT_TRUE(truthOf.contains(photo.cameraSha256)) << photo.fileName;
        EXPECT_EQ(truthOf[photo.cameraSha256].nominalPositionM,
                  store.station(photo.station).station.positionM);
        EXPECT_TRUE(stations.insert(photo.station).second);
    }
    RecordProperty("killed_between_shots", killedBetweenShots);
}

} // namespace spherewalk
