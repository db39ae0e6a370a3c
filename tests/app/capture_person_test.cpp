// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "temporary_folder.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <unistd.h>

namespace spherewalk {

using test::runCli;
using testing::HasSubstr;

namespace {

/// A terminal at which a test is the person.
class Keyboard {
  public:
    Keyboard() : m_keys(::posix_openpt(O_RDWR | O_NOCTTY)) {
        if (m_keys < 0 || ::grantpt(m_keys) != 0 || ::unlockpt(m_keys) != 0) {
            ADD_FAILURE() << "there is no terminal";
        }
    }

    ~Keyboard() { ::close(m_keys); }

    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    std::string terminal() const { return ::ptsname(m_keys); }

    void press(const std::string& keys) const {
        EXPECT_EQ(::write(m_keys, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
    }

  private:
    int m_keys;
};

} // namespace

TEST(CapturePerson, EnterThatIsPressedOnceTooOftenTakesNoPicture) {
    const test::TemporaryFolder folder;
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.isPlain = true;
    options.truthFile = folder / "truth.jsonl";
    practice::PracticeCamera camera(options);
    camera.start();
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "0.6"}).status, 0);
    const std::vector<store::StationRecord> stations =
        store::SurveyStore::open(survey, store::Access::Read).stations();
    const Keyboard keyboard;
    test::Program::Options input;
    input.inputFile = keyboard.terminal();
    test::Program program({SPHEREWALK_CLI, "capture", survey, "--camera",
                           "127.0.0.1:" + std::to_string(camera.port()), "--time-scale", "0.02", "--most",
                           "3"},
                          input);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_NE(program.waitForError("Bring the camera to " + stations[i].name), "") << program.errors();
        camera.setPosition(stations[i].station.positionM);
        keyboard.press(i == 0 ? "\n\n\n" : "\n");
    }
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_THAT(program.output(), HasSubstr("Took 3 photos"));

    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    std::map<std::string, Eigen::Vector3d> placeOf;
    for (const practice::Truth& truth : practice::readTruth(folder / "truth.jsonl")) {
        placeOf[truth.sha256] = truth.nominalPositionM;
    }
    ASSERT_EQ(store.photos().size(), 3U);
    for (const store::PhotoRecord& photo : store.photos()) {
        EXPECT_EQ(placeOf.at(photo.cameraSha256), photo.positionM) << photo.fileName;
    }
}

TEST(ShotsCommand, ListsShotsWithoutAnEndAndTakesAPersonsDecision) {
    const test::TemporaryFolder folder;
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "0.6"}).status, 0);
    {
        auto store = store::SurveyStore::open(survey, store::Access::Write);
        const std::vector<store::StationRecord> stations = store.stations();
        store.markUnclear(store.beginShot(stations[0].id, "YN1", {}).id, "Is it of this station?",
                          "http://192.168.1.1/files/R0010001.JPG#17");
        store.markUnclear(store.beginShot(stations[1].id, "YN1", {}).id, "Two pictures are new.");
        store.beginShot(stations[2].id, "YN1", {});
    }
    const Json listed = runCli({"shots", survey, "--json"}).json()["shots"];
    ASSERT_EQ(listed.size(), 3U);
    EXPECT_EQ(listed[0]["picture"], "R0010001.JPG");
    EXPECT_EQ(listed[1]["sentence"], "Two pictures are new.");
    EXPECT_EQ(listed[2]["step"], "intended");
    EXPECT_THAT(runCli({"shots", survey}).output, HasSubstr("--confirm 1."));
    EXPECT_EQ(runCli({"shots", survey, "--confirm", "2"}).status, 1); // there is no picture
    const Json decided =
        runCli({"shots", survey, "--confirm", "1", "--give-up", "rail 1, stop 2", "--json"}).json()["shots"];
    ASSERT_EQ(decided.size(), 2U);
    EXPECT_EQ(decided[0]["step"], "taken");
    EXPECT_EQ(runCli({"shots", survey, "--give-up", "all", "--json"}).json()["shots"].size(), 0U);
    EXPECT_EQ(runCli({"shots", survey, "--give-up", "all"}).status, 1);
}

} // namespace spherewalk
