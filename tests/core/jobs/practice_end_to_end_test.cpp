// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <map>

namespace spherewalk::jobs {

namespace {

/// Moves the practice cart, never repeats a shot, and counts what it was asked for.
class CountingOperator : public Operator {
  public:
    explicit CountingOperator(const camera::Endpoint& endpoint) : m_cart(endpoint) {}

    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override {
        ++moves;
        m_cart.moveTo(station, stop);
    }

    bool tryAgain(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                  int /*tries*/, const std::stop_token& /*stop*/) override {
        ++questions;
        return false;
    }

    void cameraReady(const camera::CameraInfo& /*camera*/,
                     const camera::CameraReadiness& /*readiness*/) override {
        ++readies;
    }

    void shotEnded(const store::StationRecord& station, const camera::ShotOutcome& /*outcome*/,
                   const photo::Verdict* /*verdict*/) override {
        ended.push_back(station.id);
    }

    int moves = 0;
    int questions = 0;
    int readies = 0;
    std::vector<std::int64_t> ended;

  private:
    PracticeOperator m_cart;
};

/// A practice camera, a survey of its room, and what stands between them.
class PracticeEndToEnd : public testing::Test {
  protected:
    void begin(int photoWidth, double stepM) {
        practice::PracticeCameraOptions options;
        options.width = photoWidth;
        options.truthFile = folder / "truth.jsonl";
        camera = std::make_unique<practice::PracticeCamera>(options);
        camera->start();
        const practice::RoomPlan drawn = practice::PracticeRoom().plan();
        const survey::Room room{drawn.outline, drawn.obstacles, drawn.ceilingM};
        survey::PlanOptions plan;
        plan.stepM = stepM;
        store = std::make_unique<store::SurveyStore>(
            store::SurveyStore::create(folder / "s.spherewalk", "s", room, plan, survey::plan(room, plan)));
        people = std::make_unique<CountingOperator>(camera::Endpoint{"127.0.0.1", camera->port()});
    }

    CaptureSurveyReport capture(int most, std::vector<std::int64_t> again = {}) {
        constexpr double kTimeScale = 0.02;
        camera::OscClient client({"127.0.0.1", camera->port()}, camera::OscOptions{}.scaled(kTimeScale),
                                 systemClock());
        CaptureSurveyOptions options = practiceCaptureOptions(kTimeScale);
        options.most = most;
        options.again = std::move(again);
        return captureSurvey(*store, client, *people, systemClock(), options, noProgress(), {});
    }

    /// What is left to differ is the rendering.
    void solveFromTruth() {
        store::NewSolution solution{"practice", "truth", "{}", {}};
        for (const auto& [photo, pose] : readTruePoses(*store, folder / "truth.jsonl")) {
            store::SolvedPhoto solved;
            solved.photo = photo;
            solved.roomFromPhoto = pose.rotation;
            solved.positionM = pose.translation;
            solution.photos.push_back(solved);
        }
        store->addSolution(solution, true);
    }

    test::TemporaryFolder folder;
    std::unique_ptr<practice::PracticeCamera> camera;
    std::unique_ptr<store::SurveyStore> store;
    std::unique_ptr<CountingOperator> people;
};

} // namespace

TEST_F(PracticeEndToEnd, AViewAtAPhotosPlaceIsTheExactPictureToMoreThan35Decibels) {
    begin(5376, 1.0);
    ASSERT_EQ(capture(2).taken, 2);
    solveFromTruth();
    exportDataset(*store, folder / "d", {}, noProgress(), {});
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
    const practice::PracticeRoom room;
    const CameraModel robot(CameraIntrinsics::pinhole(640, 480, Radians(Degrees(69)).value()));
    for (const practice::Truth& truth : practice::readTruth(folder / "truth.jsonl")) {
        for (const auto& [yawDeg, pitchDeg] : {std::pair{20, 0}, {140, 15}, {-100, -30}, {180, 60}}) {
            const Rigid3 pose{rotation({Degrees(yawDeg), Degrees(pitchDeg), Radians(0)}) * bodyFromOptical(),
                              truth.positionM};
            const render::View view = renderer.render(robot, pose);
            EXPECT_LT(view.report.offsetM, 1e-9);
            EXPECT_GT(photo::psnr(view.picture, room.view(robot, pose)), 35) << yawDeg << " " << pitchDeg;
            // The same view, mirrored or turned by the smallest convention error one could make, is far off.
            const Rigid3 turned{yawRotation(Radians(Degrees(180))) * pose.rotation, pose.translation};
            EXPECT_LT(photo::psnr(view.picture, room.view(robot, turned)), 25) << yawDeg << " " << pitchDeg;
        }
    }
}

TEST_F(PracticeEndToEnd, EachStationGetsItsOwnPhotoUnchangedButForItsTag) {
    begin(1024, 0.8);
    const int stations = static_cast<int>(store->stations().size());
    ASSERT_GE(stations, 4);
    const CaptureSurveyReport report = capture(0);
    EXPECT_EQ(report.taken, stations);
    EXPECT_EQ(report.remaining, 0);
    EXPECT_TRUE(report.missed.empty());
    EXPECT_TRUE(store->check(noProgress(), {}).isSound());
    std::map<std::string, practice::Truth> truthOf;
    for (const practice::Truth& truth : practice::readTruth(folder / "truth.jsonl")) {
        truthOf[truth.sha256] = truth;
    }
    for (const store::PhotoRecord& photo : store->photos()) {
        const practice::Truth& truth = truthOf.at(photo.cameraSha256);
        EXPECT_EQ(truth.nominalPositionM, store->station(photo.station).station.positionM);
        const Bytes stored = readFile(store->photoFolder() / photo.fileName);
        const Bytes onCamera = readFile(camera->storageFolder() / "100RICOH" / truth.file);
        EXPECT_EQ(jpeg::decode(stored, "x"), jpeg::decode(onCamera, "x"));
        EXPECT_EQ(photo::readPositionTag(stored, "x")->stationId, photo.station);
    }
}

TEST_F(PracticeEndToEnd, AClosedConnectionLeadsToOneTriggerAnAction) {
    begin(1024, 1.0);
    camera->arm({practice::FaultKind::DropBeforeExecuting, "camera.takePicture", 0, 1, 0});
    const CaptureSurveyReport none = capture(1);
    EXPECT_EQ(none.taken, 0);
    ASSERT_EQ(none.missed.size(), 1U);
    EXPECT_EQ(people->moves, 1);
    EXPECT_EQ(people->questions, 1);
    EXPECT_EQ(camera->stats().commands["camera.takePicture"], 1);

    camera->arm({practice::FaultKind::ExecuteThenDrop, "camera.takePicture", 0, 1, 0});
    EXPECT_EQ(capture(1).taken, 1);
    EXPECT_EQ(people->moves, 2);
    EXPECT_EQ(camera->stats().commands["camera.takePicture"], 2);
    EXPECT_EQ(camera->stats().exposures, 1);
}

TEST_F(PracticeEndToEnd, TakesStationsAgainInWalkingOrderWithTheMissingOnes) {
    begin(1024, 1.5);
    capture(3);
    const std::vector<store::StationRecord> stations = store->stations();
    ASSERT_GE(stations.size(), 4U);
    people->ended.clear();
    const CaptureSurveyReport report = capture(2, {stations[1].id});
    EXPECT_EQ(report.taken, 2);
    EXPECT_EQ(people->ended, std::vector<std::int64_t>({stations[1].id, stations[3].id}));
    EXPECT_EQ(people->readies, 2);
    EXPECT_EQ(store->photosAt(stations[1].id).size(), 2U);
}

TEST_F(PracticeEndToEnd, ACutDownloadIsRepeatedAndTheShotIsNot) {
    begin(1024, 1.0);
    camera->arm({practice::FaultKind::CutDownload, "/files", 0, 2, 1000});
    EXPECT_EQ(capture(1).taken, 1);
    EXPECT_EQ(camera->stats().commands["camera.takePicture"], 1);
    EXPECT_TRUE(store->check(noProgress(), {}).isSound());
}

} // namespace spherewalk::jobs
