// SPDX-License-Identifier: GPL-3.0-or-later
// A robotics engineer has a dataset and wants to know what a robot's camera would see on its way.
#include "photographed_survey.h"
#include "shell/person.h"
#include "ui/preview/drive_view.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"

#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/export_dataset.h"

#include <QComboBox>

namespace spherewalk::ui {

namespace fs = std::filesystem;

TEST(EngineerTest, SavesFramesOfADriveInTenActions) {
    const test::PhotographedSurvey survey(8, 1024);
    jobs::exportDataset(survey.open(), survey / "d", {}, noProgress(), {});
    Person person;
    int actions = 1; // the dataset is pulled into the window
    ASSERT_TRUE(drop(person.window(), QString::fromStdString((survey / "d").string())));
    PreviewPresenter& presenter = person.page<PreviewMode>().presenter();
    person.waitUntil([&] { return !presenter.views().empty(); });

    auto& camera = person.widget<QComboBox>("camera");
    camera.setFocus();
    person.key(camera, Qt::Key_Home);
    person.waitUntil([&] { return presenter.views().front().picture.size() == QSize(1280, 720); });

    person.press("record");
    auto& view = person.widget<DriveView>("view");
    view.setFocus();
    for (const Qt::Key key : {Qt::Key_W, Qt::Key_A, Qt::Key_W}) { // drives, turns, and drives on
        const RobotPlace begin = presenter.robot();
        ++actions;
        QTest::keyPress(&view, key);
        person.waitUntil([&] {
            return (presenter.robot().pInRoom - begin.pInRoom).norm() > 0.2 ||
                   std::abs((presenter.robot().yaw - begin.yaw).value()) > 0.3;
        });
        QTest::keyRelease(&view, key);
    }
    person.press("record");
    fs::create_directories(survey / "frames");
    person.answer(QString::fromStdString((survey / "frames").string()));
    person.press("save");
    person.waitForTasks();
    actions += person.actions();
    RecordProperty("actions", actions);
    EXPECT_LE(actions, 10);

    const std::vector<TimedPose> drive = readTum(survey / "frames" / "path.tum");
    ASSERT_GE(drive.size(), 3U);
    EXPECT_TRUE(fs::exists(survey / "frames" / "robot.yaml"));
    const QImage frame(QString::fromStdString((survey / "frames" / "000000.png").string()));
    EXPECT_EQ(frame.size(), QSize(1280, 720));
    person.window().close();
}

} // namespace spherewalk::ui
