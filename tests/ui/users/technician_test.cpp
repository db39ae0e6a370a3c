// SPDX-License-Identifier: GPL-3.0-or-later
// A technician scans a flat: from an empty window to a dataset with its measured error, with one trouble of
// the camera, one death of the program, and two stations mixed up.
#include "shell/person.h"
#include "temporary_folder.h"
#include "ui/align/align_mode.h"
#include "ui/export/export_mode.h"
#include "ui/export/export_presenter.h"
#include "ui/look/told_label.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/camera/http.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/render/dataset.h"

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProcess>
#include <QProcessEnvironment>
#include <QSettings>
#include <QTableView>

#include <csignal>
#include <cstdlib>
#include <map>

namespace spherewalk::ui {

namespace fs = std::filesystem;
using State = CaptureDesk::State;

namespace {

constexpr const char* kPlace = "SPHEREWALK_TECHNICIANS_CART"; ///< "FOLDER PORT", for the program that dies.
constexpr int kDiesAt = 6;  ///< The program dies while the camera takes this photo.
constexpr int kMixedUp = 8; ///< After so many photos, two stops of a rail are taken in the wrong order.
constexpr int kMostActions = 40;

practice::PracticeRoomOptions flat() {
    practice::PracticeRoomOptions options;
    options.style = practice::RoomStyle::Flat;
    options.sizeM = {7, 5.5, 2.5};
    return options;
}

/// The technician with the cart, on which the camera is.
class Technician {
  public:
    Technician(const fs::path& folder, int port) : m_http({"127.0.0.1", port}) {
        // What the program remembers is there when it is started again.
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                           QString::fromStdString(folder.string()));
        QSettings().setValue("surveysPlace", QString::fromStdString(folder.string()));
        m_person = std::make_unique<Person>();
    }

    Person& person() const { return *m_person; }

    CaptureMode& capturePage() const { return m_person->page<CaptureMode>(); }

    CaptureDesk& desk() const { return capturePage().desk(); }

    void plan() {
        const practice::RoomPlan plan = practice::PracticeRoom(flat()).plan();
        person().press("newSurvey");
        person().draw(Qt::Key_O, plan.outline);
        for (const Polygon& obstacle : plan.obstacles) {
            person().draw(Qt::Key_B, obstacle);
        }
        person().type("step", "1");
        person().type("surveyName", "flat");
        person().press("createSurvey");
    }

    /// Pastes the address, which the camera's label has.
    void connectToCamera() {
        auto& address = person().widget<QLineEdit>("cameraAddress");
        QApplication::clipboard()->setText(QString::fromStdString(m_http.endpoint().name()));
        address.setFocus();
        person().key(address, Qt::Key_A, Qt::ControlModifier);
        person().key(address, Qt::Key_V, Qt::ControlModifier);
        person().press("connectCamera");
        person().waitFor(State::Ready);
    }

    /// Brings the cart to the station that the page names, and shoots; again where the camera took no
    /// picture.
    void shoot() {
        person().waitFor(State::AtStation);
        moveTo(desk().next()->station.positionM);
        shootHere();
    }

    /// Whether the station after the one that the page names is on the same rail.
    bool isRailLonger() const {
        const auto [here, next] = nextTwo();
        return here.station.placement == next.station.placement;
    }

    /// Mixes the two stations up.
    void shootMixedUp() {
        person().waitFor(State::AtStation);
        const auto [here, next] = nextTwo();
        moveTo(next.station.positionM);
        shootHere();
        person().waitFor(State::AtStation);
        moveTo(here.station.positionM);
        shootHere();
    }

    void start() { QTest::keyClick(&capturePage(), Qt::Key_Space); }

    /// Takes the photos again that the alignment has called doubtful or failed.
    void takeFlaggedAgain() {
        person().press("onlyFlagged");
        auto& photos = person().widget<QTableView>("photos");
        photos.setFocus();
        person().key(photos, Qt::Key_A, Qt::ControlModifier);
        person().press("retake");
        person().choose("Capture");
        person().waitUntil([&] { return desk().stationsLeft() > 0; });
        start();
        while (desk().stationsLeft() > 0) {
            shoot();
        }
        person().waitFor(State::Ready);
    }

    void moveTo(const Eigen::Vector3d& place) {
        const Json pose = {{"x", place.x()}, {"y", place.y()}, {"z", place.z()}};
        ASSERT_EQ(m_http.post("/practice/pose", pose.dump(), {}).status, 200);
    }

    void shootHere() {
        const int left = desk().stationsLeft();
        QTest::keyClick(&capturePage(), Qt::Key_Space);
        person().waitUntil([&] { return desk().stationsLeft() < left || desk().state() == State::AskAgain; });
        if (desk().state() == State::AskAgain) {
            shootHere();
        }
    }

  private:
    std::pair<store::StationRecord, store::StationRecord> nextTwo() const {
        const std::vector<store::StationRecord> all = m_person->window().session()->store().stations();
        const auto here = std::ranges::find(all, desk().next()->id, &store::StationRecord::id);
        return {*here, here + 1 == all.end() ? *here : here[1]};
    }

    camera::HttpClient m_http;
    std::unique_ptr<Person> m_person;
};

/// The first half of the work, in a program of its own, which dies in a shot.
void workUntilTheEnd() {
    std::istringstream place(qEnvironmentVariable(kPlace).toStdString());
    fs::path folder;
    int port = 0;
    place >> folder >> port;
    ASSERT_GT(port, 0);
    Technician technician(folder, port);
    technician.plan();
    technician.person().choose("Capture");
    technician.connectToCamera();
    technician.start();
    while (technician.desk().stations() - technician.desk().stationsLeft() < kDiesAt) {
        technician.shoot();
    }
    technician.person().waitFor(State::AtStation);
    technician.moveTo(technician.desk().next()->station.positionM);
    writeFile(folder / "actions", bytesOf(std::to_string(technician.person().actions())));
    QTest::keyClick(&technician.capturePage(), Qt::Key_Space);
    technician.person().waitFor(State::Shooting);
    fs::remove_all(qEnvironmentVariable("HOME").toStdString());
    std::raise(SIGKILL);
}

} // namespace

TEST(TechnicianTest, ScansAFlat) {
    if (qEnvironmentVariableIsSet(kPlace)) {
        return workUntilTheEnd();
    }
    const test::TemporaryFolder folder;
    practice::PracticeCameraOptions options;
    options.room = flat();
    options.width = 1024;
    options.timeScale = 0.05;
    practice::PracticeCamera camera(options);
    camera.start();
    // The camera's trouble: it obeys and drops the connection, so that nobody knows whether there is a photo.
    camera.arm({practice::FaultKind::ExecuteThenDrop, "camera.takePicture", 2, 1, 0, 0});

    QProcess dying;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(
        kPlace, QString("%1 %2").arg(QString::fromStdString(folder.path().string())).arg(camera.port()));
    dying.setProcessEnvironment(environment);
    dying.setProcessChannelMode(QProcess::ForwardedChannels);
    dying.start(QCoreApplication::applicationFilePath(), {"--gtest_filter=TechnicianTest.ScansAFlat"});
    ASSERT_TRUE(dying.waitForFinished(120'000));
    ASSERT_EQ(dying.exitStatus(), QProcess::CrashExit);

    // The technician starts it again and goes on.
    Technician technician(folder.path(), camera.port());
    Person& person = technician.person();
    auto& recent = *person.window().findChild<QListWidget*>("recentSurveys");
    recent.setFocus();
    person.key(recent, Qt::Key_Return);
    ASSERT_NE(person.window().session(), nullptr);
    const fs::path path = person.window().session()->path();
    person.choose("Capture");
    technician.connectToCamera();
    const int stations = technician.desk().stations();
    EXPECT_GE(stations - technician.desk().stationsLeft(), kDiesAt);
    technician.start();
    for (bool isMixedUp = false; technician.desk().stationsLeft() > 0;) {
        const int taken = stations - technician.desk().stationsLeft();
        if (taken >= kMixedUp && !isMixedUp && technician.isRailLonger()) {
            technician.shootMixedUp();
            isMixedUp = true;
        } else {
            technician.shoot();
        }
    }
    person.waitFor(State::Ready);
    person.key(technician.capturePage(), Qt::Key_A); // align
    person.press("run");
    person.waitForTasks();
    if (person.widget<QAbstractButton>("retagAll").isEnabled()) {
        person.press("retagAll");
        person.waitForTasks();
    } else {
        technician.takeFlaggedAgain();
        person.key(technician.capturePage(), Qt::Key_A);
    }
    person.press("run");
    person.waitForTasks();
    person.choose("Export");
    person.press("opens");
    // What it is by default, the scene model that measuring chooses, takes minutes.
    const bool isMeasured = std::getenv("SPHEREWALK_TECHNICIAN") != nullptr;
    if (!isMeasured) {
        auto& scene = person.widget<QComboBox>("scene");
        scene.setFocus();
        person.key(scene, Qt::Key_Home);
    }
    person.press("export");
    person.waitForTasks();
    ASSERT_TRUE(person.widget<QLabel>("result").isVisible());
    const int actions = person.actions() + std::stoi(readTextFile(folder / "actions"));
    RecordProperty("actions", actions);
    EXPECT_LE(actions, kMostActions);
    const fs::path dataset =
        person.page<ExportMode>().findChild<ExportPresenter*>()->exported().toStdString();
    person.window().close();

    const auto store = store::SurveyStore::open(path, store::Access::Read);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    std::map<std::string, practice::Truth> truthOf;
    for (const practice::Truth& truth : practice::readTruth(camera.truthFile())) {
        truthOf[truth.sha256] = truth;
    }
    for (const store::StationRecord& station : store.stations()) {
        const auto photo = store.chosenPhoto(station.id);
        ASSERT_TRUE(photo) << station.name;
        EXPECT_LT((truthOf.at(photo->cameraSha256).nominalPositionM - station.station.positionM).norm(), 1e-6)
            << station.name;
    }
    const render::Dataset exported = render::Dataset::open(dataset, render::Verify::Hashes);
    EXPECT_EQ(exported.info().photos.size(), store.stations().size());
    EXPECT_EQ(exported.info().choice.has_value(), isMeasured);
}

} // namespace spherewalk::ui
