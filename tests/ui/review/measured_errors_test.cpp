// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/frame/settings.h"
#include "ui/review/coverage_view.h"
#include "ui/review/review_mode.h"
#include "ui/review/review_presenter.h"

#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/render/dataset_format.h"

#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>

namespace spherewalk::ui {

namespace {

/// A survey of three photos, of which a report says 3, nothing, and 6 pixels.
class MeasuredErrorsTest : public testing::Test {
  protected:
    ~MeasuredErrorsTest() override { Settings().setMeasuredReport(surveyId(), {}); }

    QString surveyId() const { return QString::fromStdString(session->store().info().uuid); }

    QString writeReport(const std::string& ofSurvey, std::size_t placesOfSecond = 0) {
        render::DatasetInfo info;
        info.surveyId = ofSurvey;
        info.name = "room";
        for (const store::PhotoRecord& photo : session->store().chosenPhotos()) {
            render::DatasetPhoto& entry = info.photos.emplace_back();
            entry.file = "photos/" + std::filesystem::path(photo.fileName).stem().string() + ".jpg";
            entry.roomFromPhoto.translation = photo.positionM;
        }
        jobs::MeasureReport report;
        report.photos = info.photos.size();
        report.directions = 4;
        report.scenes.resize(1);
        report.scenes[0].scene = render::SceneKind::Sphere;
        report.scenes[0].photos = {{0, 3, 9}, {1, {}, placesOfSecond}, {2, 6, 9}};
        report.rungs = {{render::SceneKind::Sphere, {}, 6, 1, 1}};
        report.choice.tolerancePx = 4;
        report.choice.rung = 0;
        jobs::writeReport({&info, &report, nullptr}, survey / "report");
        return QString::fromStdString((survey / "report" / "report.json").string());
    }

    test::PhotographedSurvey survey{3};
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
};

} // namespace

TEST_F(MeasuredErrorsTest, BelongToThePhotosThatTheDatasetWasMadeOf) {
    PanoramaPresenter viewer;
    TaskList tasks;
    ReviewPresenter presenter(tasks, survey / "cache", viewer);
    presenter.setSession(session.get());
    EXPECT_TRUE(presenter.errorWords().startsWith("No dataset"));
    presenter.readErrors(writeReport(session->store().info().uuid));
    const std::vector<ReviewRow>& rows = presenter.model().rows();
    EXPECT_EQ(rows.at(0).errorPx, 3);
    EXPECT_EQ(rows.at(1).errorPx, std::nullopt);
    EXPECT_EQ(rows.at(2).errorPx, 6);
    EXPECT_EQ(rows.at(3).errorPx, std::nullopt); // no photo
    EXPECT_TRUE(presenter.errorWords().contains("scene model sphere, tolerance 4.0 px"));
    const QModelIndex first = presenter.model().index(0);
    EXPECT_EQ(first.data(ReviewModel::ErrorRole).toString(), "3.0 px");
    EXPECT_TRUE(first.data(Qt::ToolTipRole).toString().contains("3.0 px"));
    presenter.setSession(nullptr);
}

TEST_F(MeasuredErrorsTest, OfAnotherSurveyAreRefused) {
    PanoramaPresenter viewer;
    TaskList tasks;
    ReviewPresenter presenter(tasks, survey / "cache", viewer);
    presenter.setSession(session.get());
    QSignalSpy messages(&presenter, &SurveyPresenter::message);
    presenter.readErrors(writeReport("another"));
    ASSERT_EQ(messages.size(), 1);
    EXPECT_TRUE(messages[0][0].value<Told>().text.contains("another survey"));
    EXPECT_EQ(presenter.model().rows().at(0).errorPx, std::nullopt);
    EXPECT_TRUE(Settings().measuredReport(surveyId()).isEmpty());
    presenter.setSession(nullptr);
}

TEST_F(MeasuredErrorsTest, AreHeatOnThePlanOnceADatasetWasMeasured) {
    TaskList tasks;
    ReviewMode mode(tasks, survey / "cache", nullptr);
    mode.setSession(session.get());
    mode.show();
    mode.activated();
    auto& measure = *mode.findChild<QComboBox*>("measure");
    auto& words = *mode.findChild<QLabel*>("errorWords");
    EXPECT_FALSE(words.isVisible());
    measure.setCurrentIndex(measure.findData(static_cast<int>(CoverageMeasure::Error)));
    EXPECT_TRUE(words.isVisible());
    EXPECT_TRUE(words.text().startsWith("No dataset"));
    EXPECT_TRUE(mode.findChild<QPushButton*>("report")->isVisible());
    Settings().setMeasuredReport(surveyId(), writeReport(session->store().info().uuid));
    mode.activated(); // back from the page where it was measured
    const auto& plan = *mode.findChild<CoverageView*>("coverage");
    EXPECT_NEAR(plan.stations().at(0).heat.value(), 0.5, 1e-9);
    EXPECT_EQ(plan.stations().at(0).note, "3.0 px");
    EXPECT_FALSE(plan.stations().at(1).heat.has_value());
    EXPECT_NEAR(plan.stations().at(2).heat.value(), 1, 1e-9);
    EXPECT_EQ(plan.hottest(), "6.0 px");
    EXPECT_TRUE(words.text().contains("left out of room"));
    mode.setSession(nullptr);
}

TEST_F(MeasuredErrorsTest, PlacesThatWereNotFoundAreTheHottest) {
    TaskList tasks;
    ReviewMode mode(tasks, survey / "cache", nullptr);
    mode.setSession(session.get());
    auto& measure = *mode.findChild<QComboBox*>("measure");
    measure.setCurrentIndex(measure.findData(static_cast<int>(CoverageMeasure::Error)));
    Settings().setMeasuredReport(surveyId(), writeReport(session->store().info().uuid, 9));
    mode.activated();
    const auto& plan = *mode.findChild<CoverageView*>("coverage");
    EXPECT_NEAR(plan.stations().at(0).heat.value(), 0.5, 1e-9);
    EXPECT_EQ(plan.stations().at(1).heat, 1);
    EXPECT_EQ(plan.stations().at(1).note, "not found");
    EXPECT_EQ(plan.hottest(), "6.0 px and more");
    const QModelIndex second = mode.findChild<QListView*>("stations")->model()->index(1, 0);
    EXPECT_EQ(second.data(ReviewModel::ErrorRole).toString(), "not found");
    mode.setSession(nullptr);
}

} // namespace spherewalk::ui
