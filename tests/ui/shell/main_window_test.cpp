// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/capture/capture_mode.h"
#include "ui/frame/settings.h"
#include "ui/map/plan_view.h"
#include "ui/plan/plan_mode.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"
#include "ui/shell/help_window.h"
#include "ui/shell/main_window.h"

#include "spherewalk/jobs/export_dataset.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QTextBrowser>
#include <QToolBar>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::ui {

namespace {

constexpr PracticeSettings kFastPractice{
    .width = 1024, .timeScale = 0.001, .stepM = 1.2, .keepsPhotos = false};

QString surveyIn(const test::TemporaryFolder& folder, const std::string& name = "Küche") {
    return QString::fromStdString(test::makeSurvey(folder / (name + ".spherewalk")).string());
}

template <class Wanted>
Wanted* modeOf(const MainWindow& window) {
    for (Mode* mode : window.modes()) {
        if (auto* found = qobject_cast<Wanted*>(mode)) {
            return found;
        }
    }
    return nullptr;
}

} // namespace

TEST(MainWindow, ShowsARealSurveyWithItsNameAndCounts) {
    const test::TemporaryFolder folder;
    MainWindow window;
    ASSERT_TRUE(window.openSurvey(surveyIn(folder)));
    EXPECT_EQ(window.windowTitle(), "Küche - Spherewalk");
    EXPECT_TRUE(window.findChild<QLabel*>("counts")->text().startsWith("0 of "));
    EXPECT_EQ(window.mode(), window.modes().first());
}

TEST(MainWindow, SpeaksOfTheDatasetWhereOneIsShown) {
    const test::PhotographedSurvey other(4);
    jobs::exportDataset(other.open(), other / "d", {}, noProgress(), {});
    const test::TemporaryFolder folder;
    MainWindow window;
    ASSERT_TRUE(window.openSurvey(surveyIn(folder)));
    auto* preview = modeOf<PreviewMode>(window);
    window.showMode(preview);
    EXPECT_EQ(window.windowTitle(), "Küche - Spherewalk");
    preview->showPart(QString::fromStdString((other / "d").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview->presenter().dataset() != nullptr; }, 100'000));
    EXPECT_EQ(window.windowTitle(), "room (dataset) - Spherewalk");
    EXPECT_TRUE(window.findChild<QLabel*>("counts")->text().startsWith("4 photo"));
    window.showMode(window.modes().first());
    EXPECT_EQ(window.windowTitle(), "Küche - Spherewalk");
    EXPECT_TRUE(window.findChild<QLabel*>("counts")->text().startsWith("0 of "));
    window.closeSurvey();
    EXPECT_EQ(window.windowTitle(), "Spherewalk");
    EXPECT_TRUE(window.findChild<QLabel*>("counts")->text().isEmpty());
}

TEST(MainWindow, LeadsThroughThePagesInFiveSteps) {
    const test::TemporaryFolder folder;
    QSettings().setValue("surveysPlace", QString::fromStdString(folder.path().string()));
    MainWindow window;
    window.show();
    modeOf<CaptureMode>(window)->desk().setPracticeSettings(kFastPractice);
    auto* tour = window.findChild<QWidget*>("tour");
    EXPECT_FALSE(tour->isVisible());
    window.findChild<QPushButton*>("tourButton")->click();
    ASSERT_TRUE(tour->isVisible());
    auto* words = window.findChild<QLabel*>("tourWords");
    auto* next = window.findChild<QPushButton*>("tourNext");
    QStringList pages;
    for (int step = 1; step <= 5; ++step) {
        EXPECT_TRUE(words->text().contains(QString("%1 of 5").arg(step))) << words->text().toStdString();
        pages << window.mode()->objectName();
        if (pages.last() == "capture") { // the photos come by themselves
            CaptureDesk& desk = modeOf<CaptureMode>(window)->desk();
            EXPECT_TRUE(QTest::qWaitFor([&] { return desk.isComplete(); }, 100'000));
        }
        next->click();
    }
    EXPECT_EQ(pages, QStringList({"plan", "capture", "review", "align", "preview"}));
    EXPECT_FALSE(tour->isVisible());
    window.findChild<QPushButton*>("tourButton")->click();
    window.closeSurvey();
    EXPECT_FALSE(tour->isVisible()); // it was of that survey
    QSettings().remove("surveysPlace");
}

TEST(MainWindow, SaysInTheStatusLineWhyItCannotOpen) {
    const test::TemporaryFolder folder;
    MainWindow window;
    EXPECT_FALSE(window.openSurvey(QString::fromStdString((folder / "absent").string())));
    EXPECT_FALSE(window.statusBar()->currentMessage().isEmpty());
    EXPECT_TRUE(window.statusBar()->toolTip().contains("absent")); // the line may be too short for all of it
}

TEST(MainWindow, OffersOnlyWhatCanBeDoneWithoutASurvey) {
    MainWindow window;
    const QList<QAction*> actions =
        window.findChild<QToolBar*>("modes")->actions().mid(1); // without the first page
    ASSERT_EQ(actions.size(), window.modes().size());
    for (qsizetype i = 0; i < actions.size(); ++i) {
        EXPECT_EQ(actions[i]->isEnabled(), window.modes()[i]->worksWithoutSurvey())
            << actions[i]->text().toStdString();
    }
    EXPECT_FALSE(modeOf<CaptureMode>(window)->worksWithoutSurvey());
}

TEST(MainWindow, RemembersSurveysThatStillExist) {
    const test::TemporaryFolder folder;
    const QString gone = surveyIn(folder, "gone");
    const QString kept = surveyIn(folder, "kept");
    MainWindow window;
    window.openSurvey(kept);
    window.openSurvey(gone);
    EXPECT_EQ(Settings().recentSurveys().first(), gone);
    window.closeSurvey();
    std::filesystem::remove_all(gone.toStdString());
    window.showMode(nullptr);
    auto* recent = window.findChild<QListWidget*>("recentSurveys");
    ASSERT_GE(recent->count(), 1);
    EXPECT_EQ(recent->item(0)->data(Qt::UserRole).toString(), kept);
}

TEST(MainWindow, OpensARecentSurveyFromTheFileMenu) {
    const test::TemporaryFolder folder;
    const QString first = surveyIn(folder, "R&D lab");
    const QString second = surveyIn(folder, "second");
    MainWindow window;
    window.openSurvey(first);
    window.openSurvey(second);
    window.show();
    test::activate(window);
    QTest::keyClick(&window, Qt::Key_F, Qt::AltModifier);
    auto* recent = window.findChild<QMenu*>("recentMenu");
    ASSERT_GE(recent->actions().size(), 2);
    EXPECT_EQ(recent->actions()[0]->text(), "&1  second");
    EXPECT_EQ(recent->actions()[1]->text(), "&2  R&&D lab");
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_R);
    ASSERT_EQ(QApplication::activePopupWidget(), recent);
    QTest::keyClick(recent, Qt::Key_2);
    ASSERT_NE(window.session(), nullptr);
    EXPECT_EQ(window.session()->folder(), first);
}

TEST(MainWindow, ANewSurveyIsTheMainButtonForWhomTriedTheRoom) {
    const test::TemporaryFolder folder;
    QSettings().clear();
    MainWindow window;
    const auto isMain = [&](const char* button) {
        return !window.findChild<QPushButton*>(button)->styleSheet().isEmpty();
    };
    EXPECT_TRUE(isMain("practiceRoom"));
    EXPECT_FALSE(isMain("newSurvey"));
    window.openSurvey(surveyIn(folder));
    window.showMode(nullptr);
    EXPECT_FALSE(isMain("practiceRoom"));
    EXPECT_TRUE(isMain("newSurvey"));
}

TEST(MainWindow, UndoBelongsToTheModeInSight) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    auto* plan = modeOf<PlanMode>(window);
    window.showMode(plan);
    plan->editor().addObstacle({{2, 2}, {2.5, 2}, {2.5, 2.5}, {2, 2.5}});
    QAction* undo = nullptr;
    for (QAction* action : window.menuBar()->actions()[1]->menu()->actions()) {
        undo = action->shortcut() == QKeySequence(QKeySequence::Undo) ? action : undo;
    }
    ASSERT_NE(undo, nullptr);
    ASSERT_TRUE(undo->isEnabled());
    window.showMode(modeOf<CaptureMode>(window));
    EXPECT_FALSE(undo->isEnabled());
    window.showMode(plan);
    undo->trigger();
    EXPECT_EQ(plan->editor().draft().room.obstacles.size(), 1U);
}

TEST(MainWindow, ANewSurveyCanBeginWithTheRoomOfAnother) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    auto* plan = modeOf<PlanMode>(window);
    const Polygon outline = plan->editor().draft().room.outline;
    plan->findChild<QPushButton*>("newWithThisRoom")->click();
    EXPECT_EQ(window.session(), nullptr);
    EXPECT_EQ(window.mode(), plan);
    EXPECT_EQ(plan->storage().state(), PlanStorage::State::New);
    EXPECT_EQ(plan->editor().draft().room.outline, outline);
}

TEST(MainWindow, TheMainButtonOfTheFirstPagePhotographsThePracticeRoom) {
    MainWindow window;
    window.show();
    CaptureDesk& desk = modeOf<CaptureMode>(window)->desk();
    desk.setPracticeSettings(kFastPractice);
    window.findChild<QPushButton*>("practiceRoom")->click();
    EXPECT_EQ(window.mode(), modeOf<CaptureMode>(window));
    QSignalSpy ends(&desk, &CaptureDesk::runEnded);
    ASSERT_TRUE(ends.wait(100'000));
    EXPECT_TRUE(ends[0][0].toBool()) << desk.sentence().toStdString();
    const store::Counts counts = window.session()->store().counts();
    EXPECT_EQ(counts.stationsWithPhoto, counts.stations);
}

TEST(MainWindow, ASurveyByHandBeginsWhereItsPhotosAreTaken) {
    const test::TemporaryFolder folder;
    QSettings().setValue("surveysPlace", QString::fromStdString(folder.path().string()));
    MainWindow window;
    for (const char* name : {"walk", "walk-2"}) {
        window.findChild<QAction*>("newByHand")->trigger();
        ASSERT_NE(window.session(), nullptr);
        EXPECT_EQ(window.session()->name(), name);
        EXPECT_EQ(window.mode(), modeOf<CaptureMode>(window));
        EXPECT_TRUE(modeOf<CaptureMode>(window)->desk().isByHand());
    }
    QSettings().remove("surveysPlace");
}

TEST(MainWindow, F1OpensTheGuideAtThePageInSight) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    window.show();
    for (Mode* mode : window.modes()) {
        test::activate(window);
        window.showMode(mode);
        QTest::keyClick(&window, Qt::Key_F1);
        auto* help = window.findChild<HelpWindow*>("help");
        ASSERT_NE(help, nullptr) << mode->title().toStdString();
        EXPECT_TRUE(help->isVisible());
        EXPECT_EQ(help->heading(), mode->title());
    }
}

TEST(MainWindow, ListsItsKeys) {
    MainWindow window;
    window.show();
    test::activate(window);
    QTest::keyClick(&window, Qt::Key_Slash, Qt::ControlModifier);
    auto* words = window.findChild<QTextBrowser*>("helpText");
    ASSERT_NE(words, nullptr);
    for (const char* wanted : {"F1", "F11", "Ctrl+Z", "Ctrl+2", "Space, Return", "Accept", "Reject"}) {
        EXPECT_TRUE(words->toPlainText().contains(wanted)) << wanted;
    }
}

TEST(MainWindow, NoLetterOpensBothAMenuAndSomethingOfAPage) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    const auto letterOf = [](const QString& text) { return QKeySequence::mnemonic(text).toString(); };
    std::set<QString> menus;
    for (const QAction* action : window.menuBar()->actions()) {
        EXPECT_TRUE(menus.insert(letterOf(action->text())).second) << action->text().toStdString();
    }
    for (Mode* mode : window.modes()) {
        window.showMode(mode);
        for (const QWidget* widget : mode->findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const QString letter = label != nullptr && label->buddy() != nullptr ? letterOf(label->text())
                                   : button != nullptr                           ? letterOf(button->text())
                                                                                 : QString();
            EXPECT_FALSE(!letter.isEmpty() && menus.contains(letter))
                << mode->title().toStdString() << ": " << letter.toStdString() << " of "
                << widget->objectName().toStdString();
        }
    }
}

TEST(MainWindow, TheCartsViewHasTheWholeScreen) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    window.show();
    window.showMode(modeOf<CaptureMode>(window));
    test::activate(window);
    QTest::keyClick(&window, Qt::Key_F11);
    EXPECT_FALSE(window.menuBar()->isVisible());
    EXPECT_FALSE(window.findChild<QToolBar*>("modes")->isVisible());
    window.showMode(modeOf<PlanMode>(window)); // as Ctrl+1 does
    EXPECT_TRUE(window.menuBar()->isVisible());
    window.showMode(modeOf<CaptureMode>(window));
    QTest::keyClick(&window, Qt::Key_F11);
    EXPECT_TRUE(window.menuBar()->isVisible());
}

TEST(MainWindow, ImportsPhotosIntoTheOpenSurvey) {
    const test::TemporaryFolder folder;
    const test::PhotographedSurvey other(3);
    MainWindow window;
    EXPECT_FALSE(window.findChild<QAction*>("importPhotos")->isEnabled());
    window.openSurvey(surveyIn(folder));
    EXPECT_TRUE(window.findChild<QAction*>("importPhotos")->isEnabled());
    window.importPhotos(QString::fromStdString((other / "p.csv").string()),
                        QString::fromStdString((other / "in").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.tasks().hasRunning(); }, 100'000));
    EXPECT_EQ(window.session()->state().counts.photos, 3);
}

TEST(MainWindow, LeadsFromPageToPage) {
    const test::TemporaryFolder folder;
    MainWindow window;
    window.openSurvey(surveyIn(folder));
    window.showMode(modeOf<CaptureMode>(window));
    emit modeOf<CaptureMode>(window)->pageRequested("align");
    EXPECT_EQ(window.mode()->objectName(), "align");
}

} // namespace spherewalk::ui
