// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/review/review_model.h"

#include <QSignalSpy>

namespace spherewalk::ui {

namespace {

class ReviewModelTest : public testing::Test {
  protected:
    ReviewModelTest() { model.setRows(reviewRows(store, jobs::activeFindings(store))); }

    void decide(std::size_t station, store::Decision decision, const std::string& note = {}) {
        const auto photo = store.chosenPhoto(store.stations().at(station).id);
        store.setReview({photo->id, decision, note});
        model.setRows(reviewRows(store, jobs::activeFindings(store)));
    }

    int shown(ReviewFilter filter) {
        proxy.setFilter(filter);
        return proxy.rowCount();
    }

    test::PhotographedSurvey survey{3};
    store::SurveyStore store = survey.open(store::Access::Write);
    int stations = store.counts().stations;
    ThumbnailCache thumbnails{survey / "cache"};
    ReviewModel model{thumbnails};
    ReviewProxy proxy{model};
};

} // namespace

TEST_F(ReviewModelTest, HasARowForEachStationInWalkingOrder) {
    ASSERT_EQ(model.rowCount(), stations);
    EXPECT_EQ(model.rows().at(0).standing, Standing::Taken);
    EXPECT_EQ(model.rows().at(3).standing, Standing::Missing);
    EXPECT_TRUE(model.rows().at(0).roomFromPhoto.has_value());
    EXPECT_EQ(model.index(0).data(Qt::DisplayRole).toString(), "Rail 1, stop 1");
}

TEST_F(ReviewModelTest, KnowsHowFarApartPhotosAreWhereItKnowsTheirPlaces) {
    store.addStation({9, 0, 1.2}, "unknown place of R1.JPG", false);
    const std::vector<ReviewRow> rows = reviewRows(store, {});
    EXPECT_NEAR(apartM(rows.at(0), rows.at(1)).value(), (rows[0].positionM - rows[1].positionM).norm(),
                1e-12);
    EXPECT_FALSE(apartM(rows.at(0), rows.back()));
}

TEST_F(ReviewModelTest, PutsWhatPeopleDecideBeforeWhatTheChecksSay) {
    decide(0, store::Decision::Rejected, "blurred");
    decide(1, store::Decision::Accepted);
    EXPECT_EQ(model.rows().at(0).standing, Standing::Rejected);
    EXPECT_EQ(model.rows().at(0).note, "blurred");
    EXPECT_EQ(model.rows().at(1).standing, Standing::Accepted);
}

TEST_F(ReviewModelTest, ShowsWhatTheChecksOfThePictureSay) {
    const auto photo = store.chosenPhoto(store.stations().at(0).id);
    store.setVerdict({photo->id, survey::Quality::Failed,
                      R"([{"flaw":"blur","quality":"failed","sentence":"It is blurred."}])"});
    model.setRows(reviewRows(store, jobs::activeFindings(store)));
    EXPECT_EQ(model.rows().at(0).standing, Standing::Failed);
    EXPECT_TRUE(model.rows().at(0).flags.contains("It is blurred."));
    decide(0, store::Decision::Accepted);
    EXPECT_EQ(model.rows().at(0).standing, Standing::Accepted);
}

TEST_F(ReviewModelTest, FiltersWhatIsListed) {
    decide(0, store::Decision::Rejected, "blurred");
    EXPECT_EQ(shown(ReviewFilter::All), stations);
    EXPECT_EQ(shown(ReviewFilter::ToReview), 2);
    EXPECT_EQ(shown(ReviewFilter::Rejected), 1);
    EXPECT_EQ(shown(ReviewFilter::Missing), stations - 3);
    EXPECT_EQ(shown(ReviewFilter::WithNote), 1);
    EXPECT_EQ(shown(ReviewFilter::Doubtful), 0);
    EXPECT_EQ(shown(ReviewFilter::Failed), 0);
}

TEST_F(ReviewModelTest, FindsStationsFilesAndNotes) {
    decide(2, store::Decision::Open, "chair moved");
    for (const char* text : {"CHAIR", "R1003", "Rail 1, stop 3"}) {
        proxy.setText(text);
        ASSERT_EQ(proxy.rowCount(), 1) << text;
        EXPECT_EQ(proxy.index(0, 0).data(ReviewModel::StationRole).toLongLong(), store.stations().at(2).id);
    }
}

TEST_F(ReviewModelTest, TellsOnlyOfRowsThatChanged) {
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    decide(1, store::Decision::Accepted);
    ASSERT_EQ(changed.count(), 1);
    EXPECT_EQ(changed.first().first().toModelIndex().row(), 1);
    EXPECT_EQ(reset.count(), 0);
}

TEST_F(ReviewModelTest, ShowsAThumbnailOnceItIsThere) {
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    EXPECT_TRUE(model.index(0).data(Qt::DecorationRole).value<QImage>().isNull());
    ASSERT_TRUE(changed.wait());
    EXPECT_EQ(changed.first().first().toModelIndex().row(), 0);
    EXPECT_FALSE(model.index(0).data(Qt::DecorationRole).value<QImage>().isNull());
}

} // namespace spherewalk::ui
