// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/look/theme.h"
#include "ui/plan/plan_mode.h"
#include "ui/plan/plan_storage.h"
#include "ui/shell/application.h"

#include "spherewalk/base/file.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTranslator>
#include <gtest/gtest.h>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

struct Fixture : testing::Test {
    Fixture() : mode(tasks) {
        mode.resize(1100, 700);
        mode.show();
        mode.view().fitRoom();
        settle();
    }

    void settle() {
        QSignalSpy outcomes(&mode.editor(), &PlanEditor::outcomeChanged);
        while (!mode.editor().isSettled()) {
            ASSERT_TRUE(outcomes.wait(100'000));
        }
    }

    QPoint at(const Vector2d& pInRoom) {
        return mode.view().widgetFromRoom().map(QPointF(pInRoom.x(), pInRoom.y())).toPoint();
    }

    void click(const Vector2d& pInRoom) {
        QTest::mouseMove(&mode.view(), at(pInRoom));
        QTest::mouseClick(&mode.view(), Qt::LeftButton, {}, at(pInRoom));
    }

    /// Answers the next question for a name.
    void answer(const QString& name) {
        QTimer::singleShot(0, &mode, [this, name] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) { // not there yet
                return answer(name);
            }
            dialog->setTextValue(name);
            dialog->accept();
        });
    }

    test::TemporaryFolder folder;
    TaskList tasks;
    PlanMode mode;
};

using PlanModeTest = Fixture;

} // namespace

TEST_F(PlanModeTest, ARoomIsDrawnWithThePointerAndTheKeyboard) {
    mode.view().setTool(PlanEditorView::Tool::Outline);
    click({0.5, 0.5});
    click({4.5, 0.5});
    QTest::mouseMove(&mode.view(), at({4.5, 2}));
    QTest::keyClicks(&mode.view(), "3.5");
    QTest::keyClick(&mode.view(), Qt::Key_Return);
    click({0.5, 4});
    click({0.5, 0.5});
    EXPECT_EQ(mode.editor().draft().room.outline, Polygon({{0.5, 0.5}, {4.5, 0.5}, {4.5, 4}, {0.5, 4}}));
    EXPECT_EQ(mode.view().tool(), PlanEditorView::Tool::Select);
}

TEST_F(PlanModeTest, ADraggedCornerSnapsAndThePlanFollows) {
    const QString before = mode.findChild<QLabel*>("planCounts")->text();
    QTest::mousePress(&mode.view(), Qt::LeftButton, {}, at({5, 4}));
    QTest::mouseMove(&mode.view(), at({4.5, 3.9}));
    QTest::mouseMove(&mode.view(), at({3.52, 3.02}));
    QTest::mouseRelease(&mode.view(), Qt::LeftButton, {}, at({3.52, 3.02}));
    EXPECT_LT((mode.editor().draft().room.outline[2] - Vector2d(3.5, 3)).norm(), 1e-9);
    settle();
    EXPECT_NE(mode.findChild<QLabel*>("planCounts")->text(), before);
}

TEST_F(PlanModeTest, MakesTheSameSurveyAsTheCommandLine) {
    mode.findChild<QDoubleSpinBox*>("step")->setValue(0.5);
    mode.findChild<QDoubleSpinBox*>("clearance")->setValue(0.4);
    mode.findChild<QLineEdit*>("heights")->setText(QLocale().toString(0.6) + "; " + QLocale().toString(1.2));
    QTest::keyClick(mode.findChild<QLineEdit*>("heights"), Qt::Key_Return);
    QSignalSpy opens(&mode, &Mode::openRequested);
    const QString survey = QString::fromStdString((folder / "lab.spherewalk").string());
    mode.storage().create(survey);
    ASSERT_EQ(opens.size(), 1);
    EXPECT_EQ(opens[0][0].toString(), survey);
    const auto store = store::SurveyStore::open(survey.toStdString(), store::Access::Read);
    const survey::PlanOptions options = store.planOptions();
    EXPECT_EQ(options.stepM, 0.5);
    EXPECT_EQ(options.clearanceM, 0.4);
    EXPECT_EQ(options.heightsM, std::vector<double>({0.6, 1.2}));
    EXPECT_EQ(store.stations().size(), survey::plan(store.room(), options).stations.size());
}

TEST_F(PlanModeTest, StoresEditsOfAnOpenSurveyByItself) {
    const auto path = test::makeSurvey(folder / "room.spherewalk");
    const auto session = SurveySession::open(QString::fromStdString(path.string()));
    mode.setSession(session.get());
    QSignalSpy changes(session.get(), &SurveySession::changed);
    mode.editor().addObstacle({{2, 2}, {2.5, 2}, {2.5, 2.5}, {2, 2.5}});
    ASSERT_TRUE(changes.wait(100'000));
    EXPECT_EQ(session->store().room().obstacles.size(), 2U);
    EXPECT_EQ(mode.storage().state(), PlanStorage::State::Stored);
    mode.setSession(nullptr);
}

TEST_F(PlanModeTest, AnEditIsNotLostWhenTheSurveyIsClosedAtOnce) {
    const auto path = test::makeSurvey(folder / "room.spherewalk");
    auto session = SurveySession::open(QString::fromStdString(path.string()));
    mode.setSession(session.get());
    mode.editor().addObstacle({{2, 2}, {2.5, 2}, {2.5, 2.5}, {2, 2.5}});
    mode.setSession(nullptr);
    session.reset();
    EXPECT_EQ(store::SurveyStore::open(path, store::Access::Read).room().obstacles.size(), 2U);
}

TEST_F(PlanModeTest, APlanWithPhotosIsLocked) {
    const auto path = test::makeSurvey(folder / "room.spherewalk");
    const auto session = SurveySession::open(QString::fromStdString(path.string()));
    mode.setSession(session.get());
    session->write(SurveySession::Photos, [](store::SurveyStore& store) {
        store.beginShot(store.stations().front().id, "serial", {"", 0});
    });
    EXPECT_EQ(mode.storage().state(), PlanStorage::State::Locked);
    EXPECT_FALSE(mode.findChild<QDoubleSpinBox*>("step")->isEnabled());
    mode.setSession(nullptr);
}

TEST_F(PlanModeTest, WritesTheMarkingOutSheet) {
    const auto file = folder / "sheet.pdf";
    QSignalSpy ended(&tasks, &TaskList::ended);
    mode.writeSheet(QString::fromStdString(file.string()));
    ASSERT_TRUE(ended.wait(100'000));
    EXPECT_EQ(readTextFile(file).substr(0, 5), "%PDF-");
}

TEST_F(PlanModeTest, WhatIsWrongWithAnOutlineIsSaidByTheLettersOfItsCorners) {
    QTranslator german;
    for (const char* named : {"corner B crosses the wall after corner D", "nach Ecke B"}) {
        mode.view().setTool(PlanEditorView::Tool::Outline);
        for (const Vector2d& corner : Polygon{{0.5, 0.5}, {4.5, 0.5}, {0.5, 3.5}, {4.5, 3.5}, {0.5, 0.5}}) {
            click(corner);
        }
        settle();
        const QString problem = mode.findChild<QLabel*>("planProblem")->text();
        EXPECT_TRUE(problem.contains(named)) << problem.toStdString();
        mode.editor().undoStack()->undo();
        ASSERT_TRUE(loadWords(german, QLocale("de")));
        QCoreApplication::installTranslator(&german); // for the second time
    }
    QCoreApplication::removeTranslator(&german);
}

TEST_F(PlanModeTest, AFixedPlanIsLeftWithTheToolThatMoves) {
    const test::PhotographedSurvey photographed(3);
    mode.view().setTool(PlanEditorView::Tool::Rails);
    auto* hint = mode.findChild<QLabel*>("planHint");
    EXPECT_FALSE(hint->text().isEmpty());
    const auto session = SurveySession::open(QString::fromStdString(photographed.path().string()));
    mode.setSession(session.get());
    EXPECT_EQ(mode.view().tool(), PlanEditorView::Tool::Select);
    EXPECT_TRUE(hint->text().isEmpty()) << hint->text().toStdString();
    mode.setSession(nullptr);
}

TEST_F(PlanModeTest, WhatTheToolBarHasNoRoomForIsBehindAButtonThatIsSeenInTheDark) {
    applyTheme(Theme::Dark);
    mode.resize(700, 600);
    auto* bar = mode.findChild<QToolBar*>();
    auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
    ASSERT_TRUE(QTest::qWaitFor([&] { return more->isVisible(); }));
    const QImage shown = more->grab().toImage();
    int lightest = 0;
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
            lightest = std::max(lightest, shown.pixelColor(x, y).lightness());
        }
    }
    EXPECT_GT(lightest, 150);
    applyTheme(Theme::Light);
}

TEST_F(PlanModeTest, NamesTheRoomsOfAFlat) {
    const auto names = [&] { return mode.editor().draft().room.names; };
    mode.view().setTool(PlanEditorView::Tool::Name);
    const QImage unnamed = mode.view().grab().toImage();
    answer("kitchen");
    click({2, 2});
    ASSERT_EQ(names().size(), 1U);
    EXPECT_EQ(names().front().name, "kitchen");
    EXPECT_LT((names().front().at - Vector2d(2, 2)).norm(), 0.05);
    EXPECT_NE(mode.view().grab().toImage(), unnamed);
    answer("  ");
    click({4, 3}); // nothing is named
    EXPECT_EQ(names().size(), 1U);
    answer("hall");
    click({2, 2});
    ASSERT_EQ(names().size(), 1U);
    EXPECT_EQ(names().front().name, "hall");
    mode.editor().undoStack()->undo();
    EXPECT_EQ(names().front().name, "kitchen");
    answer({});
    click({2, 2});
    EXPECT_TRUE(names().empty());
    mode.editor().undoStack()->undo();
    EXPECT_EQ(names().size(), 1U);
    settle();
    EXPECT_TRUE(mode.editor().outcome().problem.isEmpty());
    mode.editor().setOutline({{3, 0}, {5, 0}, {5, 4}, {3, 4}}); // without the kitchen
    EXPECT_TRUE(names().empty());
}

TEST_F(PlanModeTest, RefusesANameThatIsTaken) {
    auto* form = mode.findChild<NewSurveyForm*>();
    auto* create = mode.findChild<QPushButton*>("createSurvey");
    EXPECT_TRUE(create->isEnabled());
    std::filesystem::create_directories(form->folder().toStdString());
    mode.findChild<QLineEdit*>("surveyName")->setText(mode.findChild<QLineEdit*>("surveyName")->text() + " ");
    EXPECT_FALSE(create->isEnabled());
    std::filesystem::remove(form->folder().toStdString());
}

TEST_F(PlanModeTest, ReturnInTheLengthSetsTheScaleOfThePicture) {
    QImage picture(100, 80, QImage::Format_RGB32);
    picture.fill(Qt::white);
    const QString file = QString::fromStdString((folder / "floor.png").string());
    ASSERT_TRUE(picture.save(file));
    mode.view().picture().load(file);
    const double before = mode.view().picture().metresPerPixel();
    emit mode.view().scaleDrawn(QLineF(0, 0, 2, 0));
    auto* length = mode.findChild<QDoubleSpinBox*>("scaleLength");
    length->setValue(4);
    QTest::keyClick(length, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(mode.view().picture().metresPerPixel(), 2 * before);
}

TEST_F(PlanModeTest, TheButtonThatMakesTheSurveyIsAlwaysInSight) {
    mode.setSession(nullptr);
    mode.resize(1000, 560);
    mode.show();
    QCoreApplication::processEvents();
    auto* create = mode.findChild<QPushButton*>("createSurvey");
    ASSERT_TRUE(create->isVisible());
    EXPECT_EQ(create->visibleRegion().boundingRect(), create->rect());
}

TEST_F(PlanModeTest, SaysWhyAPictureCannotBeLaid) {
    QStringList said;
    QObject::connect(&mode, &Mode::message, [&](const Told& told) { said << told.text; });
    mode.layPicture(QString::fromStdString((folder / "none.png").string()));
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said.first().contains("none.png"));
}

} // namespace spherewalk::ui
