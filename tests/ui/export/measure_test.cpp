// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/export/export_mode.h"
#include "ui/export/measure_panel.h"
#include "ui/fields/camera_box.h"
#include "ui/frame/settings.h"
#include "ui/session/survey_session.h"

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/dataset.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QUrl>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

class MeasureTest : public testing::Test {
  protected:
    MeasureTest() { jobs::exportDataset(survey.open(), dataset.toStdString(), {}, noProgress(), {}); }

    static CameraIntrinsics camera() { return CameraIntrinsics::pinhole(160, 120, 1); }

    void waitForTasks() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        QCoreApplication::processEvents();
    }

    test::PhotographedSurvey survey{3};
    QString dataset = QString::fromStdString((survey / "room.dataset").string());
    TaskList tasks;
    MeasurePresenter presenter{tasks};
};

} // namespace

TEST_F(MeasureTest, StoresTheChoiceAndWritesTheReport) {
    presenter.measure(camera(), 4); // of no dataset
    EXPECT_FALSE(tasks.hasRunning());
    presenter.setDataset(dataset);
    EXPECT_TRUE(presenter.page().isEmpty());
    presenter.measure(camera(), 4);
    EXPECT_FALSE(presenter.canMeasure());
    waitForTasks();
    EXPECT_TRUE(presenter.told().text.contains("holds 4.00 px")) << presenter.told().text.toStdString();
    EXPECT_TRUE(presenter.isStored());
    const auto choice = render::Dataset::open(dataset.toStdString()).info().choice;
    ASSERT_TRUE(choice.has_value());
    EXPECT_EQ(choice->tolerancePx, 4);
    for (const char* file : {"report.html", "report.pdf", "report.json"}) {
        EXPECT_TRUE(fs::exists(fs::path(dataset.toStdString()) / "report" / file)) << file;
    }
    EXPECT_EQ(presenter.page(), dataset + "/report/report.html");
    EXPECT_EQ(Settings().measuredReport(QString::fromStdString(survey.open().info().uuid)),
              dataset + "/report/report.json");
}

TEST_F(MeasureTest, LeavesTheDatasetAsItWasWhenItIsStopped) {
    presenter.setDataset(dataset);
    presenter.measure(camera(), 4);
    presenter.task()->stop();
    waitForTasks();
    EXPECT_TRUE(presenter.told().text.startsWith("Stopped"));
    EXPECT_FALSE(render::Dataset::open(dataset.toStdString()).info().choice.has_value());
    EXPECT_TRUE(presenter.page().isEmpty());
}

TEST_F(MeasureTest, SaysWhatIsWrongWithADataset) {
    fs::remove(fs::path(dataset.toStdString()) / "dataset.json");
    presenter.setDataset(dataset);
    presenter.measure(camera(), 4);
    waitForTasks();
    EXPECT_TRUE(presenter.told().text.contains("dataset.json")) << presenter.told().text.toStdString();
}

TEST_F(MeasureTest, IsDoneOnTheExportPageAndOpensTheReport) {
    writeFile(survey / "small.yaml", bytesOf(render::cameraInfoYaml(camera(), "small")));
    const auto session = SurveySession::open(QString::fromStdString(survey.path().string()));
    QStringList opened;
    ExportMode mode(tasks);
    mode.setOpener([&](const QUrl& url) {
        opened << url.toLocalFile();
        return true;
    });
    auto& measure = *mode.findChild<QPushButton*>("measureNow");
    EXPECT_FALSE(measure.isEnabled());
    mode.setSession(session.get()); // whose usual folder has a dataset already
    mode.show();
    EXPECT_TRUE(measure.isEnabled());
    mode.findChild<CameraBox*>("measureCamera")
        ->readCamera(QString::fromStdString((survey / "small.yaml").string()));
    QTest::mouseClick(&measure, Qt::LeftButton);
    EXPECT_TRUE(mode.findChild<QPushButton*>("stopMeasuring")->isVisible());
    waitForTasks();
    const auto* words = mode.findChild<QLabel*>("measureWords");
    EXPECT_TRUE(words->text().endsWith("made so.")) << words->text().toStdString(); // no link behind it
    mode.resize(760, 420); // a small window scrolls; it cuts nothing off
    EXPECT_EQ(mode.size(), QSize(760, 420));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return words->height() >= words->heightForWidth(words->width()); }, 3000));
    QTest::mouseClick(mode.findChild<QPushButton*>("openReport"), Qt::LeftButton);
    EXPECT_EQ(opened, QStringList{dataset + "/report/report.html"});
    mode.setSession(nullptr);
}

} // namespace spherewalk::ui
