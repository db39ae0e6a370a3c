// SPDX-License-Identifier: GPL-3.0-or-later
#include "review_page.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/coverage_view.h"
#include "ui/review/review_model.h"

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/equirect.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace spherewalk::ui {

namespace {

class ReviewModeTest : public ReviewPage {
  protected:
    store::Review review(std::size_t station) const { return session->store().review(photo(station)); }

    void press(Qt::Key key) { QTest::keyClick(&widget<QListView>("stations"), key); }
};

} // namespace

TEST_F(ReviewModeTest, AcceptsAndRejectsWithKeys) {
    press(Qt::Key_A);
    press(Qt::Key_R);
    EXPECT_EQ(review(0).decision, store::Decision::Accepted);
    EXPECT_EQ(review(1).decision, store::Decision::Rejected);
    press(Qt::Key_K);
    press(Qt::Key_O);
    EXPECT_EQ(review(1).decision, store::Decision::Open);
}

TEST_F(ReviewModeTest, AcceptsWithTheButton) {
    QTest::mouseClick(&widget<QToolButton>("accept"), Qt::LeftButton);
    EXPECT_EQ(review(0).decision, store::Decision::Accepted);
}

TEST_F(ReviewModeTest, KeepsTheNoteWithThePhotoThatItWasWrittenFor) {
    press(Qt::Key_M);
    auto& note = widget<QLineEdit>("note");
    QTest::keyClicks(&note, "a raised arm"); // whose letters decide nothing
    QTest::mouseClick(&widget<QToolButton>("reject"), Qt::LeftButton);
    EXPECT_EQ(review(0).note, "a raised arm");
    EXPECT_EQ(review(0).decision, store::Decision::Rejected);
    EXPECT_EQ(review(1).note, "");
    EXPECT_EQ(note.text(), "");
}

TEST_F(ReviewModeTest, ListsWhatTheFilterAndTheSearchLeave) {
    auto& filter = widget<QComboBox>("filter");
    filter.setCurrentIndex(filter.findData(static_cast<int>(ReviewFilter::ToReview)));
    EXPECT_EQ(widget<QListView>("stations").model()->rowCount(), 3);
    QTest::keyClicks(&widget<QLineEdit>("search"), "stop 2");
    EXPECT_EQ(widget<QListView>("stations").model()->rowCount(), 1);
}

TEST_F(ReviewModeTest, ShowsTheStationThatIsChosenElsewhere) {
    const std::int64_t third = session->store().stations().at(2).id;
    session->selection()->setCurrent(third);
    EXPECT_EQ(widget<QListView>("stations").currentIndex().data(ReviewModel::StationRole).toLongLong(),
              third);
    auto* view = mode.findChild<PanoramaView*>();
    EXPECT_TRUE(view->presenter().photo()->name.contains("stop 3"));
}

TEST_F(ReviewModeTest, TellsTheOtherViewsWhatIsChosenInTheList) {
    widget<QListView>("stations").setCurrentIndex(widget<QListView>("stations").model()->index(1, 0));
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(1).id);
}

TEST_F(ReviewModeTest, ComparesWithTheNeighbourThatIsChosen) {
    auto* view = mode.findChild<PanoramaView*>();
    press(Qt::Key_C);
    EXPECT_EQ(view->presenter().comparison(), Comparison::Blink);
    press(Qt::Key_C);
    EXPECT_EQ(view->presenter().comparison(), Comparison::Slider);
    const QString nearest = view->presenter().other()->name;
    press(Qt::Key_N);
    EXPECT_NE(view->presenter().other()->name, nearest);
    press(Qt::Key_C);
    EXPECT_FALSE(view->presenter().other().has_value());
}

TEST_F(ReviewModeTest, ShowsOnThePlanWhatWasDecided) {
    press(Qt::Key_R);
    const auto& marks = widget<CoverageView>("coverage").stations();
    EXPECT_EQ(marks.at(0).standing, Standing::Rejected);
    EXPECT_EQ(marks.at(1).standing, Standing::Taken);
    EXPECT_EQ(marks.at(3).standing, Standing::Missing);
}

TEST_F(ReviewModeTest, ShowsNoPlaceThatNobodyKnows) {
    std::int64_t unknown = 0;
    session->write(SurveySession::Everything, [&](store::SurveyStore& store) {
        unknown = store.addStation({9, 0, 1.2}, "unknown place of R1.JPG", false);
    });
    const auto& coverage = widget<CoverageView>("coverage");
    EXPECT_EQ(coverage.stations().size(), session->state().stations.size() - 1);
    EXPECT_FALSE(std::ranges::count(coverage.stations(), unknown, &StationMark::id));
}

TEST_F(ReviewModeTest, TheLegendTakesAsManyLinesAsItNeeds) {
    auto* legend = mode.findChild<CoverageLegend*>();
    const int line = legend->fontMetrics().height();
    EXPECT_LT(legend->heightForWidth(2000), 2 * line);
    EXPECT_GE(legend->heightForWidth(200), 2 * line);
    mode.resize(700, 600); // so narrow that one line cannot hold it
    const auto isWhole = [&] { return legend->height() >= legend->heightForWidth(legend->width()); };
    EXPECT_TRUE(QTest::qWaitFor(isWhole, 2000)) << legend->width() << " x " << legend->height() << ", needs "
                                                << legend->heightForWidth(legend->width());
    EXPECT_LT(legend->width(), 380);
}

TEST_F(ReviewModeTest, ShowsResidualsAsHeat) {
    jobs::AlignReport report;
    store::NewSolution solution{"align", "yaw", "{}", {}};
    for (const store::PhotoRecord& record : session->store().chosenPhotos()) {
        jobs::AlignedPhoto photo;
        photo.photo = record.id;
        photo.quality = survey::Quality::Good;
        photo.pose.isSolved = true;
        photo.pose.residualRad = 0.01 * static_cast<double>(report.photos.size() + 1);
        report.photos.push_back(photo);
    }
    solution.report = jobs::toJson(report).dump();
    session->write(SurveySession::Solutions,
                   [&](store::SurveyStore& store) { store.addSolution(solution, true); });
    widget<QComboBox>("measure").setCurrentIndex(1);
    const auto& marks = widget<CoverageView>("coverage").stations();
    EXPECT_NEAR(marks.at(0).heat.value(), 1.0 / 3, 1e-9);
    EXPECT_NEAR(marks.at(2).heat.value(), 1, 1e-9);
    EXPECT_FALSE(marks.at(3).heat.has_value());
}

TEST_F(ReviewModeTest, OnlyLooksOnWhileAnotherProgramWrites) {
    mode.setSession(nullptr);
    const auto capturing = survey.open(store::Access::Write);
    session = SurveySession::open(QString::fromStdString(survey.path().string()));
    mode.setSession(session.get());
    session->selection()->setCurrent(session->store().stations().at(0).id);
    EXPECT_FALSE(widget<QToolButton>("accept").isEnabled());
    EXPECT_FALSE(widget<QLineEdit>("note").isEnabled());
    EXPECT_TRUE(mode.findChild<PanoramaView*>()->presenter().photo().has_value());
}

TEST_F(ReviewModeTest, TurnsToWhatTheChecksFoundAndOutlinesIt) {
    const std::int64_t photo = session->store().chosenPhoto(session->store().stations().at(1).id)->id;
    const std::string sentence =
        "Something is in view that its neighbours do not show, 54 degrees to the left of the "
        "picture's middle (4.7 % of the sphere); if it is a person, step aside.";
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        store.setVerdict(
            {photo, survey::Quality::Doubtful,
             Json::array({{{"flaw", "foreign"}, {"quality", "doubtful"}, {"sentence", sentence}}}).dump()});
    });
    auto& viewer = mode.findChild<PanoramaView*>()->presenter();
    EXPECT_TRUE(viewer.outlines({640, 480}).empty());
    press(Qt::Key_J);
    ASSERT_TRUE(viewer.photo());
    const Eigen::Vector3d there =
        viewer.photo()->roomFromPhoto.rotation * direction(SphericalDirection{Degrees(54.0), Degrees(0.0)});
    EXPECT_NEAR(wrapped(viewer.look().yaw - sphericalDirection(there).azimuth).value(), 0, 0.05);
    const std::vector<QPolygonF> outlines = viewer.outlines({640, 480});
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_NEAR(outlines[0].boundingRect().center().x(), 320, 10);
    viewer.turn(Degrees(180.0), Degrees(0.0));
    EXPECT_TRUE(viewer.outlines({640, 480}).empty()); // it is behind
    const QModelIndex row = widget<QListView>("stations").model()->index(1, 0);
    EXPECT_EQ(row.data(ReviewModel::ReasonRole).toString(), "foreign, 4.7 %");
}

TEST_F(ReviewModeTest, WhatIsToBeTakenAgainLeadsToCapture) {
    const auto find = [&](const char* sentence) {
        session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
            store.setVerdict(
                {store.chosenPhotos().at(0).id, survey::Quality::Failed,
                 Json::array({{{"flaw", "blur"}, {"quality", "failed"}, {"sentence", sentence}}}).dump()});
        });
    };
    find("It is blurred: its edges are 3.1 times as wide as they should be; let the camera come to rest and "
         "take it again.");
    EXPECT_TRUE(widget<QLabel>("reasons").text().contains(linkTo(Cure::Capture).toString()));
    find("The camera leaned by 4 degrees; check its mount.");
    EXPECT_FALSE(widget<QLabel>("reasons").text().contains("href"));
}

TEST_F(ReviewModeTest, SaysThatPhotosAreNotAlignedWhereTheyAreCompared) {
    press(Qt::Key_C);
    EXPECT_FALSE(widget<QPushButton>("toAlign").isVisible());
    session->write(SurveySession::Solutions, [](store::SurveyStore& store) {
        store.addSolution({"align", "yaw", "{}", {}}, true); // which knows no photo
    });
    EXPECT_TRUE(mode.findChild<PanoramaView*>()->presenter().isComparingUnaligned());
    ASSERT_TRUE(widget<QPushButton>("toAlign").isVisible());
    QSignalSpy wanted(&mode, &Mode::pageRequested);
    widget<QPushButton>("toAlign").click();
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_EQ(wanted[0][0].toString(), "align");
}

TEST_F(ReviewModeTest, DecidesOnAllThatAreSelectedAndUndoShowsThem) {
    auto& list = widget<QListView>("stations");
    const auto click = [&](int row, Qt::KeyboardModifiers modifiers) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, modifiers,
                          list.visualRect(list.model()->index(row, 0)).center());
    };
    click(0, {});
    click(2, Qt::ShiftModifier);
    press(Qt::Key_A);
    for (const std::size_t station : {0U, 1U, 2U}) {
        EXPECT_EQ(review(station).decision, store::Decision::Accepted) << station;
    }
    session->selection()->setCurrent(session->store().stations().at(1).id);
    session->undoStack()->undo();
    EXPECT_EQ(review(2).decision, store::Decision::Open);
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(0).id);
}

TEST_F(ReviewModeTest, AcceptsAllThatTheChecksCallGood) {
    auto& accept = widget<QPushButton>("acceptGood");
    EXPECT_FALSE(accept.isEnabled()); // no check has graded them
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        const auto photos = store.chosenPhotos();
        store.setVerdict({photos.at(0).id, survey::Quality::Good, "[]"});
        store.setVerdict({photos.at(1).id, survey::Quality::Doubtful, "[]"});
    });
    const std::int64_t doubtful = session->store().chosenPhotos().at(1).id;
    ASSERT_TRUE(accept.isEnabled());
    accept.click();
    EXPECT_EQ(review(0).decision, store::Decision::Accepted);
    EXPECT_EQ(session->store().review(doubtful).decision, store::Decision::Open);
    EXPECT_FALSE(accept.isEnabled());
}

TEST_F(ReviewModeTest, ChecksPhotosThatNoCheckHasSeen) {
    session->write(SurveySession::Solutions, [](store::SurveyStore& store) {
        store.addSolution({"align", "yaw", "{}", {}}, true); // which grades no photo
    });
    auto& check = widget<QPushButton>("checkPhotos");
    ASSERT_TRUE(check.isVisible());
    check.click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !check.isVisible(); }, 100'000));
    EXPECT_EQ(session->store().verdicts().size(), 3U);
}

TEST_F(ReviewModeTest, ListsTheDoubtfulForAnotherPage) {
    const std::int64_t second = session->store().stations().at(1).id;
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        store.setVerdict({store.chosenPhoto(second)->id, survey::Quality::Doubtful, "[]"});
    });
    mode.showPart("doubtful");
    EXPECT_EQ(widget<QListView>("stations").model()->rowCount(), 1);
    EXPECT_EQ(session->selection()->current(), second);
}

TEST_F(ReviewModeTest, ShowsAllPhotosOnAContactSheet) {
    auto& list = widget<QListView>("stations");
    const auto rowOf = [&](int row) { return list.visualRect(list.model()->index(row, 0)); };
    EXPECT_EQ(rowOf(0).x(), rowOf(1).x());
    press(Qt::Key_G);
    ASSERT_TRUE(QTest::qWaitFor([&] { return rowOf(1).x() > rowOf(0).x(); }));
    EXPECT_EQ(rowOf(0).y(), rowOf(1).y());
    EXPECT_GT(list.width(), mode.width() * 3 / 4);
    EXPECT_FALSE(widget<CoverageView>("coverage").isVisible());
    press(Qt::Key_Right); // its photos are walked through and decided on as in the list
    press(Qt::Key_R);
    EXPECT_EQ(review(1).decision, store::Decision::Rejected);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, rowOf(2).center());
    press(Qt::Key_Return); // shows the photo
    EXPECT_TRUE(widget<CoverageView>("coverage").isVisible());
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(2).id);
}

TEST_F(ReviewModeTest, TellsTheStoryOfAPhoto) {
    auto& story = widget<QLabel>("story");
    EXPECT_FALSE(story.isVisible());
    press(Qt::Key_Home);
    press(Qt::Key_I);
    ASSERT_TRUE(story.isVisible());
    for (const char* words : {"Taken as R1001.JPG", "stored", "No check has judged it.",
                              "it looks along 0.0 degrees", "Nobody has decided on it yet."}) {
        EXPECT_TRUE(story.text().contains(words)) << words << " in " << story.text().toStdString();
    }
    press(Qt::Key_A); // and goes on
    press(Qt::Key_K);
    EXPECT_TRUE(story.text().contains("Somebody has accepted it.")) << story.text().toStdString();
    press(Qt::Key_I);
    EXPECT_FALSE(story.isVisible());
}

} // namespace spherewalk::ui
