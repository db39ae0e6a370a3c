// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/person.h"
#include "ui/align/align_mode.h"
#include "ui/capture/operator_signals.h"
#include "ui/export/export_mode.h"
#include "ui/preview/drive_view.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"
#include "ui/review/review_mode.h"

#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/renderer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>

namespace spherewalk::ui {

namespace fs = std::filesystem;
using Eigen::Vector2d;
using State = CaptureDesk::State;

namespace {

const Polygon kOutline = {{0, 0}, {4.5, 0}, {4.5, 3.5}, {0, 3.5}};

/// Draws the room, and makes the survey of it. Returns its folder.
fs::path plan(Person& person) {
    person.press("newSurvey");
    person.draw(Qt::Key_O, kOutline);
    person.draw(Qt::Key_B, {{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}});
    person.type("step", "1.2");
    person.type("surveyName", "hall");
    person.press("createSurvey");
    return person.window().session()->path();
}

/// One key a photo.
void capture(Person& person) {
    person.choose("Capture");
    auto& page = person.page<CaptureMode>();
    person.press("practiceCamera");
    person.agree();
    person.waitFor(State::Ready);
    QTest::keyClick(&page, Qt::Key_Space); // starts
    const int stations = page.desk().stations();
    for (int photo = 1; photo <= stations; ++photo) {
        person.waitFor(State::AtStation);
        EXPECT_EQ(person.widget<BigText>("nextStation").text().toLower().toStdString(),
                  page.desk().next()->name);
        QTest::keyClick(&page, Qt::Key_PageDown);
        person.waitUntil([&] { return page.desk().stationsLeft() == stations - photo; });
    }
    person.waitFor(State::Ready);
}

/// Takes a station again that is clicked on the plan.
void retake(Person& person, const store::StationRecord& station) {
    auto& page = person.page<CaptureMode>();
    Person::click(*page.findChild<PlanCanvas*>(), station.station.positionM.head<2>());
    person.press("takeAgain");
    QTest::keyClick(&page, Qt::Key_Space);
    person.waitFor(State::AtStation);
    QTest::keyClick(&page, Qt::Key_Space);
    person.waitFor(State::Ready);
}

void align(Person& person) {
    person.choose("Align");
    auto& effort = person.widget<QComboBox>("effort");
    effort.setFocus();
    QTest::keyClick(&effort, Qt::Key_Home); // the quickest
    person.press("run");
    person.waitForTasks();
}

/// Accepts the first photo of the list, and rejects the second.
void review(Person& person) {
    person.choose("Review");
    auto& list = person.widget<QListView>("stations");
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Home);
    QTest::keyClick(&list, Qt::Key_A);
    QTest::keyClick(&list, Qt::Key_R);
}

/// Drives forward, and saves what the robot's camera saw on the way.
void preview(Person& person, const fs::path& frames) {
    person.choose("Preview");
    person.press("withDepth"); // not for this test
    person.press("make");
    PreviewPresenter& presenter = person.page<PreviewMode>().presenter();
    person.waitUntil([&] { return !presenter.views().empty(); });
    presenter.objects().lay(LaidObject::Shape::Ball, presenter.beforeRobot());
    person.press("record");
    auto& view = person.widget<DriveView>("view");
    view.setFocus();
    const Vector2d begin = presenter.robot().pInRoom;
    QTest::keyPress(&view, Qt::Key_W);
    person.waitUntil([&] { return (presenter.robot().pInRoom - begin).norm() > 0.1; });
    QTest::keyRelease(&view, Qt::Key_W);
    person.press("record");
    fs::create_directories(frames);
    person.answer(QString::fromStdString(frames.string()));
    person.press("save");
    person.waitForTasks();
}

void exportDataset(Person& person, const fs::path& folder) {
    person.choose("Export");
    person.press("opens"); // the folder is not to be opened
    auto& scene = person.widget<QComboBox>("scene");
    scene.setFocus();
    QTest::keyClick(&scene, Qt::Key_Home); // the quickest
    person.type("folder", QString::fromStdString(folder.string()));
    person.press("export");
    person.waitUntil([&] { return person.widget<QLabel>("result").isVisible(); });
}

} // namespace

TEST(WholeWay, APersonGetsFromAnEmptyWindowToADatasetThatRobotsSee) {
    Person person;
    const fs::path path = plan(person);
    const fs::path folder = path.parent_path();
    capture(person);
    const store::StationRecord again = person.window().session()->store().stations().back();
    retake(person, again);
    align(person);
    review(person);
    preview(person, folder / "frames");
    exportDataset(person, folder / "hall for robots");
    person.window().close();

    // The survey.
    const auto store = store::SurveyStore::open(path, store::Access::Read);
    EXPECT_EQ(store.info().name, "hall");
    EXPECT_EQ(store.room().outline, kOutline);
    EXPECT_EQ(store.room().obstacles.size(), 1U);
    const std::vector<store::StationRecord> stations = store.stations();
    EXPECT_EQ(store.photos().size(), stations.size() + 1);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    for (const store::PhotoRecord& photo : store.photos()) {
        EXPECT_LT((photo.positionM - store.station(photo.station).station.positionM).norm(), 1e-9);
        EXPECT_TRUE(fs::exists(store.photoFolder() / photo.fileName));
    }
    // The station that was taken again has two photos; the later one counts.
    const std::vector<store::PhotoRecord> taken = store.photosAt(again.id);
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(store.chosenPhoto(again.id)->id, std::max(taken[0].id, taken[1].id));
    // The alignment.
    const auto solution = store.activeSolution();
    ASSERT_TRUE(solution);
    EXPECT_EQ(solution->source, "align");
    // Photos of 512 pixels, the quickest effort: not every one can be tied to its neighbours.
    EXPECT_GT(2 * store.solvedPhotos(solution->id).size(), stations.size());
    // What was decided.
    EXPECT_EQ(store.review(store.photosAt(stations[0].id).front().id).decision, store::Decision::Accepted);
    EXPECT_EQ(store.review(store.photosAt(stations[1].id).front().id).decision, store::Decision::Rejected);
    // The drive.
    const std::vector<TimedPose> drive = readTum(folder / "frames" / "path.tum");
    EXPECT_GE(drive.size(), 2U);
    EXPECT_TRUE(fs::exists(folder / "frames" / "robot.yaml"));
    const QImage frame(QString::fromStdString((folder / "frames" / "000000.png").string()));
    EXPECT_EQ(frame.size(), QSize(640, 480));
    // The dataset.
    const auto dataset = std::make_shared<const render::Dataset>(
        render::Dataset::open(folder / "hall for robots", render::Verify::Hashes));
    EXPECT_EQ(dataset->info().photos.size(), stations.size() - 1); // without the rejected one
    const render::Renderer renderer(dataset);
    const render::View view =
        renderer.render(CameraModel(CameraIntrinsics::pinhole(320, 240, Radians(Degrees(80)).value())),
                        drive.front().roomFromCamera);
    EXPECT_EQ(view.picture.width(), 320);
    EXPECT_GT(view.report.trust, 0.25);
}

} // namespace spherewalk::ui
