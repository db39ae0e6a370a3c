// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "person.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/frame/mode.h"
#include "ui/plan/plan_mode.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"
#include "ui/shell/dropped_files.h"
#include "ui/shell/main_window.h"
#include "ui/shell/recent_surveys.h"

#include "spherewalk/jobs/export_dataset.h"

#include <QListWidget>
#include <QSettings>
#include <QTest>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

QString textOf(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

} // namespace

TEST(Dropping, ASurveyIsOpened) {
    const test::TemporaryFolder folder;
    const std::filesystem::path survey = test::makeSurvey(folder / "flat.spherewalk");
    MainWindow window;
    EXPECT_TRUE(drop(window, textOf(survey)));
    ASSERT_NE(window.session(), nullptr);
    EXPECT_EQ(window.session()->name(), "flat");
}

TEST(Dropping, ADatasetIsPreviewed) {
    const test::PhotographedSurvey survey(3);
    jobs::exportDataset(survey.open(), survey / "d", {}, noProgress(), {});
    MainWindow window;
    EXPECT_TRUE(drop(window, textOf(survey / "d" / "dataset.json")));
    ASSERT_NE(window.mode(), nullptr);
    EXPECT_EQ(window.mode()->objectName(), "preview");
    auto* preview = qobject_cast<PreviewMode*>(window.mode());
    EXPECT_TRUE(QTest::qWaitFor([&] { return preview->presenter().dataset() != nullptr; }, 100'000));
}

TEST(Dropping, PhotosWithTheirPositionsAreImported) {
    const test::TemporaryFolder folder;
    const test::PhotographedSurvey other(3);
    MainWindow window;
    window.openSurvey(textOf(test::makeSurvey(folder / "flat.spherewalk")));
    std::filesystem::copy_file(other / "p.csv", other / "in" / "p.csv");
    EXPECT_TRUE(drop(window, textOf(other / "in")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.tasks().hasRunning(); }, 100'000));
    EXPECT_EQ(window.session()->state().counts.photos, 3);
}

TEST(Dropping, PhotosWithoutPositionsAreImported) {
    const test::TemporaryFolder folder;
    const test::PhotographedSurvey other(3);
    MainWindow window;
    window.openSurvey(textOf(test::makeSurvey(folder / "flat.spherewalk")));
    EXPECT_TRUE(drop(window, textOf(other / "in")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.tasks().hasRunning(); }, 100'000));
    EXPECT_EQ(window.session()->state().counts.photos, 3);
    EXPECT_TRUE(window.session()->state().hasUnknownPlaces());
}

TEST(Dropping, PhotosWithoutPositionsMakeASurveyWhereNoneIsOpen) {
    const test::TemporaryFolder folder;
    const test::PhotographedSurvey other(3);
    QSettings().setValue("surveysPlace", textOf(folder.path()));
    std::filesystem::rename(other / "in", other / "kitchen");
    MainWindow window;
    EXPECT_TRUE(drop(window, textOf(other / "kitchen")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.tasks().hasRunning(); }, 100'000));
    ASSERT_NE(window.session(), nullptr);
    EXPECT_EQ(window.session()->name(), "kitchen");
    EXPECT_EQ(window.session()->state().counts.photos, 3);
    EXPECT_EQ(window.session()->folder(), textOf(folder / "kitchen.spherewalk"));
    QSettings().remove("surveysPlace");
}

TEST(Dropping, AFloorPlanLiesUnderTheDrawing) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(QImage(50, 20, QImage::Format_RGB32).save(textOf(folder / "plan.png")));
    MainWindow window;
    EXPECT_TRUE(drop(window, textOf(folder / "plan.png")));
    ASSERT_EQ(window.mode()->objectName(), "plan");
    EXPECT_FALSE(qobject_cast<PlanMode*>(window.mode())->view().picture().isEmpty());
}

TEST(Dropping, NothingElseIsTaken) {
    const test::TemporaryFolder folder;
    writeFile(folder / "letter.odt", bytesOf("words"));
    MainWindow window;
    EXPECT_FALSE(drop(window, textOf(folder / "letter.odt")));
    EXPECT_EQ(droppedAs({"/no/such/file"}).kind, Dropped::Kind::Nothing);
}

TEST(RecentSurveys, TellFolderAndProgressWithAPicture) {
    const test::PhotographedSurvey survey(4);
    const QString folder = textOf(survey.path());
    RecentSurveys recent;
    recent.list({folder});
    ASSERT_EQ(recent.count(), 1);
    const QString parent = QFileInfo(folder).path();
    EXPECT_TRUE(recent.item(0)->text().contains(parent)) << recent.item(0)->text().toStdString();
    const auto counts = survey.open().counts();
    const QString progress = QString("%1 of %2 photos").arg(counts.stationsWithPhoto).arg(counts.stations);
    EXPECT_TRUE(QTest::qWaitFor([&] { return recent.item(0)->text().contains(progress); }, 100'000))
        << recent.item(0)->text().toStdString();
    const QImage picture = summaryOf(folder).picture;
    QImage empty(picture.size(), picture.format());
    empty.fill(Qt::transparent);
    EXPECT_NE(picture, empty);
    EXPECT_EQ(recent.item(0)->data(Qt::UserRole).toString(), folder);
}

} // namespace spherewalk::ui
