// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/export/export_mode.h"
#include "ui/export/export_presenter.h"
#include "ui/frame/settings.h"

#include "spherewalk/render/dataset.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

class ExportTest : public testing::Test {
  protected:
    ExportTest() {
        mode.setOpener([this](const QUrl& url) {
            opened << url.toLocalFile();
            return true;
        });
        mode.setSession(session.get());
        widget<QComboBox>("scene").setCurrentIndex(0); // what is quick
        mode.resize(900, 700);
        mode.show();
    }

    ~ExportTest() override { mode.setSession(nullptr); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *mode.findChild<Widget*>(name);
    }

    /// Looks, and waits for what was found.
    void check() {
        mode.activated();
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return !tasks.hasRunning() && widget<QPushButton>("check").isEnabled(); }, 100'000));
    }

    void exportNow() {
        QTest::mouseClick(&widget<QPushButton>("export"), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        QCoreApplication::processEvents();
    }

    test::PhotographedSurvey survey{3};
    TaskList tasks;
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
    QStringList opened;
    ExportMode mode{tasks};
    fs::path usual = survey / "room.dataset";
};

} // namespace

TEST_F(ExportTest, ChecksBeforeAndThenExports) {
    EXPECT_EQ(widget<QLineEdit>("folder").text().toStdString(), usual.string());
    EXPECT_FALSE(widget<QPushButton>("export").isEnabled());
    check();
    EXPECT_TRUE(widget<QLabel>("amount").text().startsWith("3 photo"));
    EXPECT_TRUE(widget<QLabel>("findings").text().contains("have no photo"));
    exportNow();
    EXPECT_EQ(render::Dataset::open(usual).info().photos.size(), 3U);
    EXPECT_EQ(opened, QStringList{QString::fromStdString(usual.string())});
    EXPECT_TRUE(widget<QLabel>("result").isVisible());
}

TEST_F(ExportTest, SaysHowMuchWillBeBlurredAndOnlyThen) {
    check();
    EXPECT_FALSE(widget<QLabel>("findings").text().contains("private"));
    session->write(SurveySession::Photos, [](store::SurveyStore& store) {
        const std::int64_t photo = store.photos().front().id;
        store.markRegion(photo, {Degrees(0), Degrees(0), Degrees(10), Degrees(10)});
        store.markRegion(photo, {Degrees(90), Degrees(0), Degrees(10), Degrees(10)});
    });
    check();
    const QString words = widget<QLabel>("findings").text();
    EXPECT_TRUE(words.contains("2 private region(s) in 1 photo(s) will be blurred.")) << words.toStdString();
    EXPECT_TRUE(words.contains("spherewalk:review/regions"));
}

TEST_F(ExportTest, DoesNotOpenTheFolderUnlessWanted) {
    widget<QCheckBox>("opens").setChecked(false);
    check();
    exportNow();
    EXPECT_TRUE(opened.isEmpty());
    QTest::mouseClick(&widget<QPushButton>("open"), Qt::LeftButton);
    EXPECT_EQ(opened.size(), 1);
}

TEST_F(ExportTest, DoesNotExportOverWhatIsThere) {
    fs::create_directories(usual);
    check();
    EXPECT_FALSE(widget<QPushButton>("export").isEnabled());
    EXPECT_TRUE(widget<QLabel>("findings").text().contains("already"));
    auto& folder = widget<QLineEdit>("folder");
    folder.setFocus();
    QTest::keyClicks(&folder, "2");
    QTest::keyClick(&folder, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return widget<QPushButton>("export").isEnabled(); }, 100'000));
    exportNow();
    EXPECT_TRUE(fs::exists(usual.string() + "2"));
}

TEST_F(ExportTest, ForgetsWhatItFoundWhenTheSurveyChanges) {
    check();
    session->write(SurveySession::Reviews, [](store::SurveyStore& store) {
        store.setReview({store.photos().front().id, store::Decision::Rejected, ""});
    });
    EXPECT_FALSE(widget<QPushButton>("export").isEnabled());
    check();
    EXPECT_TRUE(widget<QLabel>("findings").text().contains("1 photo was rejected"));
}

TEST_F(ExportTest, ChoosesTheSceneModelThatHoldsATolerance) {
    auto& scene = widget<QComboBox>("scene");
    auto& tolerance = widget<QDoubleSpinBox>("sceneTolerance");
    EXPECT_FALSE(tolerance.isVisible());
    scene.setCurrentIndex(scene.count() - 1);
    EXPECT_TRUE(tolerance.isVisible());
    tolerance.setValue(50);
    check();
    EXPECT_TRUE(widget<QLabel>("amount").text().endsWith("comes on top of that."));
    exportNow();
    const auto choice = render::Dataset::open(usual).info().choice;
    ASSERT_TRUE(choice.has_value());
    EXPECT_EQ(choice->tolerancePx, 50);
    const QString words = widget<QLabel>("result").text();
    EXPECT_TRUE(words.contains("holds 50.0 px")) << words.toStdString();
    scene.setCurrentIndex(0);
    EXPECT_FALSE(tolerance.isVisible());
}

TEST_F(ExportTest, LeavesAReportOfWhatItMeasured) {
    auto& scene = widget<QComboBox>("scene");
    scene.setCurrentIndex(scene.count() - 1);
    check();
    QElapsedTimer time;
    time.start();
    exportNow();
    EXPECT_GT(2000 * mode.findChild<ExportPresenter*>()->seconds(), time.elapsed()); // with all measuring
    EXPECT_TRUE(fs::exists(usual / "report" / "report.html"));
    EXPECT_TRUE(fs::exists(usual / "report" / "report.json"));
    EXPECT_TRUE(widget<QPushButton>("openReport").isVisible());
    const QString id = QString::fromStdString(session->store().info().uuid);
    EXPECT_TRUE(Settings().measuredReport(id).endsWith("room.dataset/report/report.json"));
}

TEST_F(ExportTest, StopsAndLeavesNothing) {
    check();
    QTest::mouseClick(&widget<QPushButton>("export"), Qt::LeftButton);
    QTest::mouseClick(&widget<QPushButton>("stop"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    const bool isDone = tasks.tasks().last()->state() == Task::State::Done; // it was quicker
    EXPECT_EQ(fs::exists(usual), isDone);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !widget<QPushButton>("stop").isVisible(); }));
}

TEST_F(ExportTest, ListsDoubtfulPhotosWithTheWayToThem) {
    auto& toReview = widget<QPushButton>("toReview");
    check();
    EXPECT_FALSE(toReview.isVisible());
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        store.setVerdict({store.chosenPhotos().at(0).id, survey::Quality::Doubtful, "[]"});
        store.setVerdict({store.chosenPhotos().at(1).id, survey::Quality::Failed, "[]"});
    });
    check();
    EXPECT_TRUE(widget<QLabel>("findings").text().contains("2 photo(s) are doubtful or failed"));
    ASSERT_TRUE(toReview.isVisible());
    QSignalSpy wanted(&mode, &Mode::pageRequested);
    toReview.click();
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_EQ(wanted[0][0].toString(), "review");
}

TEST_F(ExportTest, ProposesToMeasureWhereThereIsEnoughToCompare) {
    const test::PhotographedSurvey pair(2);
    const auto small = SurveySession::open(QString::fromStdString(pair.path().string()));
    ExportMode unasked(tasks);
    auto& scene = *unasked.findChild<QComboBox*>("scene");
    unasked.setSession(small.get());
    EXPECT_EQ(scene.currentIndex(), 0);
    unasked.setSession(session.get());           // three photos
    EXPECT_FALSE(scene.currentData().isValid()); // the cheapest that holds a tolerance
    scene.setCurrentIndex(1);
    unasked.activated();
    EXPECT_EQ(scene.currentIndex(), 1); // who has chosen is not asked again
    unasked.setSession(nullptr);
}

} // namespace spherewalk::ui
