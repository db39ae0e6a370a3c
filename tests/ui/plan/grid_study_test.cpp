// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/fields/camera_box.h"
#include "ui/plan/grid_study.h"
#include "ui/plan/plan_mode.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/render/camera_info.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <optional>

namespace spherewalk::ui {

namespace {

using render::SceneKind;

CameraIntrinsics smallCamera() {
    return CameraIntrinsics::pinhole(160, 120, 1);
}

std::unique_ptr<SurveySession> opened(const std::filesystem::path& survey) {
    return SurveySession::open(QString::fromStdString(survey.string()));
}

jobs::GridRow rowOf(double stepM, SceneKind scene, std::optional<double> p95Px) {
    jobs::GridRow row;
    row.stepM = stepM;
    row.scene = scene;
    row.views = 8;
    row.p95Px = p95Px;
    return row;
}

/// Of steps of 40 and 80 cm with two scene models.
jobs::GridStudy madeStudy() {
    jobs::GridStudy study;
    study.tolerancePx = 2;
    study.rows = {rowOf(0.4, SceneKind::Sphere, 5), rowOf(0.4, SceneKind::Depth, 1.5),
                  rowOf(0.8, SceneKind::Sphere, 9), rowOf(0.8, SceneKind::Depth, {})};
    study.costs = {{0.4, 60, 20}, {0.8, 15, 6}};
    study.answers = {{SceneKind::Sphere, {}, false, {}},
                     {SceneKind::Depth, 0.53, false, jobs::GridCost{0.53, 38, 12}}};
    return study;
}

} // namespace

TEST(GridStudyModel, HasALineForEachStepAndAColumnForEachSceneModel) {
    GridStudyModel model;
    model.setStudy(madeStudy());
    ASSERT_EQ(model.rowCount(), 2);
    ASSERT_EQ(model.columnCount(), GridStudyModel::FirstSceneColumn + 2);
    const auto words = [&](int row, int column) {
        return model.index(row, column).data().toString().toStdString();
    };
    EXPECT_EQ(words(0, GridStudyModel::StepColumn), "40 cm");
    EXPECT_EQ(words(0, GridStudyModel::PhotosColumn), "60");
    EXPECT_EQ(words(1, GridStudyModel::TimeColumn), "6 min");
    EXPECT_EQ(words(0, GridStudyModel::FirstSceneColumn), "5.0 px");
    EXPECT_EQ(words(0, GridStudyModel::FirstSceneColumn + 1), "✓ 1.5 px"); // holds the tolerance
    EXPECT_EQ(words(1, GridStudyModel::FirstSceneColumn + 1), "–");
    EXPECT_EQ(answerWords(madeStudy().answers[1]).toStdString(), "53 cm with depth: 38 photo(s), 12 min");
}

TEST(GridStudyPresenter, SaysWhyTooFewPhotosCannotBeStudied) {
    const test::TemporaryFolder folder;
    TaskList tasks;
    GridStudyPresenter presenter(tasks);
    EXPECT_TRUE(presenter.obstacle().contains("Open a survey"));
    const auto session = opened(test::makeSurvey(folder / "room.spherewalk"));
    presenter.setSession(session.get());
    EXPECT_TRUE(presenter.obstacle().contains("5 x 5"));
    presenter.study({smallCamera(), 2, false});
    EXPECT_EQ(presenter.task(), nullptr);
    presenter.setSession(nullptr);
}

TEST(GridStudyPresenter, SaysThatAStudyWasStopped) {
    const test::PhotographedSurvey survey(12);
    const auto session = opened(survey.path());
    TaskList tasks;
    GridStudyPresenter presenter(tasks);
    presenter.setSession(session.get());
    presenter.study({smallCamera(), 2, true});
    ASSERT_NE(presenter.task(), nullptr);
    presenter.task()->stop();
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter.task() == nullptr; }, 100'000));
    EXPECT_TRUE(presenter.words().startsWith("Stopped"));
    EXPECT_FALSE(presenter.found());
    presenter.setSession(nullptr);
}

TEST(GridStudyPanel, IsDisabledWithAReasonWithoutPhotos) {
    TaskList tasks;
    PlanMode mode(tasks);
    mode.show();
    EXPECT_FALSE(mode.findChild<QPushButton*>("gridStudy")->isEnabled());
    EXPECT_TRUE(mode.findChild<QLabel*>("gridObstacle")->isVisible());
    EXPECT_FALSE(mode.findChild<QPushButton*>("gridUse")->isVisible());
}

TEST(GridStudyPanel, PlansTheNextSurveyWithTheStepThatWasFound) {
    const test::PhotographedSurvey survey(12);
    writeFile(survey / "small.yaml", bytesOf(render::cameraInfoYaml(smallCamera(), "small")));
    const auto session = opened(survey.path());
    TaskList tasks;
    PlanMode mode(tasks);
    QObject::connect(&mode, &Mode::newRequested, &mode, [&] { mode.setSession(nullptr); });
    mode.setSession(session.get());
    mode.show();
    mode.findChild<CameraBox*>("gridCamera")
        ->readCamera(QString::fromStdString((survey / "small.yaml").string()));
    mode.findChild<QCheckBox*>("gridDepth")->setChecked(false);
    QTest::mouseClick(mode.findChild<QPushButton*>("gridStudy"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return mode.study().task() == nullptr; }, 100'000));
    ASSERT_TRUE(mode.study().found()) << mode.study().words().toStdString();
    EXPECT_TRUE(mode.findChild<QLabel*>("gridWords")->text().contains("is enough"));
    EXPECT_GT(mode.findChild<QTableView*>("gridTable")->model()->rowCount(), 0);
    // Nothing is near in that world: turned photos of any grid will do.
    const double stepM = mode.study().found()->answers.front().stepM.value();
    const double plannedM = mode.editor().draft().options.stepM;
    EXPECT_GT(stepM, plannedM);
    QTest::mouseClick(mode.findChild<QPushButton*>("gridUse"), Qt::LeftButton);
    EXPECT_EQ(mode.storage().state(), PlanStorage::State::New); // photos stand on the old plan
    EXPECT_EQ(mode.editor().draft().options.stepM, stepM);
    EXPECT_EQ(mode.editor().draft().room.outline, survey.open().room().outline);
    mode.undoStack()->undo();
    EXPECT_EQ(mode.editor().draft().options.stepM, plannedM);
}

} // namespace spherewalk::ui
