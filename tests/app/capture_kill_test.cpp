// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <list>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace spherewalk {

using test::runCli;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> captureOf(const std::string& survey, const practice::PracticeCamera& camera) {
    return {SPHEREWALK_CLI, "capture",  survey,
            "--practice",   "--camera", "127.0.0.1:" + std::to_string(camera.port()),
            "--time-scale", "0.05"};
}

std::map<std::string, practice::Truth> truthOf(const practice::PracticeCamera& camera) {
    std::map<std::string, practice::Truth> truthOf;
    for (const practice::Truth& truth : practice::readTruth(camera.truthFile())) {
        truthOf[truth.sha256] = truth;
    }
    return truthOf;
}

/// A camera and its survey of four stations, whose capture is killed.
class KilledCapture {
  public:
    KilledCapture(const std::filesystem::path& survey, std::uint64_t seed)
        : m_survey(survey), m_camera(options(seed)) {
        m_camera.start();
        const test::CliResult made =
            runCli({"new", m_survey, "--rect", "0,0,2,1.6", "--ceiling", "2.6", "--step", "0.6"});
        EXPECT_EQ(made.status, 0) << made.errors;
    }

    /// Kills the program up to so many milliseconds after it has triggered the camera and has not heard what
    /// became of that. A failure if no shot is in doubt then.
    testing::AssertionResult killInDoubt(practice::FaultKind fault, int mostMs, test::Random& random) {
        const int shotsBefore = random.integer(0, 2);
        const int triggers = m_camera.stats().commands[kTrigger] + shotsBefore;
        m_camera.disarm();
        m_camera.arm({fault, kTrigger, shotsBefore, 1, 0, 0});
        test::Program program(captureOf(m_survey, m_camera));
        while (m_camera.stats().commands[kTrigger] <= triggers) {
            if (program.endsWithin(5ms)) {
                return testing::AssertionFailure() << "it ended by itself: " << program.errors();
            }
        }
        program.endsWithin(std::chrono::milliseconds(random.integer(0, mostMs)));
        program.signal(SIGKILL);
        program.wait();
        m_camera.disarm();
        const bool isInDoubt = std::ranges::any_of(opened().openShots(), [](const survey::Shot& shot) {
            return shot.step < survey::ShotStep::Taken;
        });
        return isInDoubt ? testing::AssertionSuccess()
                         : testing::AssertionFailure() << "no shot is open: " << program.errors();
    }

    void carryOnAndPress() {
        m_camera.setPosition({0.1, 0.1, 1.2});
        m_camera.befall({practice::FaultKind::ExtraPhoto, "", 0, 1, 0, 0});
    }

    /// The program goes on to the end.
    void resume() {
        test::Program program(captureOf(m_survey, m_camera));
        program.wait();
        EXPECT_TRUE(opened().stationsWithoutPhoto().empty()) << program.errors();
    }

    void expectOwnPhotos() {
        const auto truths = truthOf(m_camera);
        EXPECT_EQ(std::ranges::count_if(truths, [](const auto& one) { return one.second.byButton; }), 1);
        const store::SurveyStore store = opened();
        for (const store::PhotoRecord& photo : store.photos()) {
            const auto truth = truths.find(photo.cameraSha256);
            ASSERT_NE(truth, truths.end()) << photo.fileName;
            EXPECT_FALSE(truth->second.byButton) << photo.fileName;
            EXPECT_EQ(truth->second.nominalPositionM, store.station(photo.station).station.positionM);
        }
    }

  private:
    static constexpr const char* kTrigger = "camera.takePicture";

    /// It draws stripes, and takes time for that like a Theta.
    static practice::PracticeCameraOptions options(std::uint64_t seed) {
        practice::PracticeCameraOptions options;
        options.width = 1024;
        options.isPlain = true;
        options.timeScale = 0.05;
        options.seed = seed;
        return options;
    }

    store::SurveyStore opened() const { return store::SurveyStore::open(m_survey, store::Access::Read); }

    std::string m_survey;
    practice::PracticeCamera m_camera;
};

} // namespace

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
    const std::vector<std::string> capture = captureOf(survey, camera);

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
    const std::map<std::string, practice::Truth> truthOfPhoto = truthOf(camera);
    std::set<std::int64_t> stations;
    for (const store::PhotoRecord& photo : photos) {
        ASSERT_TRUE(truthOfPhoto.contains(photo.cameraSha256)) << photo.fileName;
        EXPECT_EQ(truthOfPhoto.at(photo.cameraSha256).nominalPositionM,
                  store.station(photo.station).station.positionM);
        EXPECT_TRUE(stations.insert(photo.station).second);
    }
    RecordProperty("killed_between_shots", killedBetweenShots);
}

// capture is killed while nobody knows whether a shot was taken: the trigger was lost, or the camera does not
// say that it has a picture. The cart is carried on, and somebody presses the camera's button. That picture
// is no station's.
TEST(CaptureKill, ACartThatIsMovedAfterAKillGivesNoPhotoToTheOldStation) {
    const test::TemporaryFolder folder;
    test::Random random(20261125);
    SCOPED_TRACE(random.seed());
    std::list<KilledCapture> captures; // which wait at the same time
    for (int i = 1; i <= 6; ++i) {
        const auto fault =
            i % 2 == 0 ? practice::FaultKind::StuckInProgress : practice::FaultKind::DropBeforeExecuting;
        testing::AssertionResult isInDoubt = testing::AssertionFailure();
        for (int attempt = 1; attempt <= 5 && !isInDoubt; ++attempt) {
            if (attempt > 1) {
                captures.pop_back(); // It was killed too late, as happens on a busy machine.
            }
            const std::string name = std::to_string(i) + "-" + std::to_string(attempt) + ".spherewalk";
            captures.emplace_back(folder / name, static_cast<std::uint64_t>(i));
            isInDoubt = captures.back().killInDoubt(fault, 1000 / attempt, random);
        }
        ASSERT_TRUE(isInDoubt);
    }
    // A picture that begins earlier may be the lost trigger's: nobody carries a cart on so soon.
    std::this_thread::sleep_for(14s);
    for (KilledCapture& capture : captures) {
        capture.carryOnAndPress();
    }
    for (KilledCapture& capture : captures) {
        capture.resume();
        capture.expectOwnPhotos();
    }
}

} // namespace spherewalk
