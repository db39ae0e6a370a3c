// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/review/review_presenter.h"

#include <QSignalSpy>
#include <QTest>

namespace spherewalk::ui {

namespace {

/// Without a window.
class ReviewPresenterTest : public testing::Test {
  protected:
    ReviewPresenterTest() {
        presenter.setSession(session.get());
        presenter.step(1);
    }

    ~ReviewPresenterTest() override { presenter.setSession(nullptr); }

    store::Review review(std::size_t station) const {
        const store::SurveyStore& store = session->store();
        return store.review(store.chosenPhoto(store.stations().at(station).id)->id);
    }

    QString currentName() const {
        return presenter.current() != nullptr ? presenter.current()->stationName : "";
    }

    test::PhotographedSurvey survey{3};
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
    PanoramaPresenter viewer;
    TaskList tasks;
    ReviewPresenter presenter{tasks, survey / "cache", viewer};
};

} // namespace

TEST_F(ReviewPresenterTest, GoesFromPhotoToPhoto) {
    EXPECT_EQ(currentName(), "Rail 1, stop 1");
    presenter.step(1);
    EXPECT_EQ(currentName(), "Rail 1, stop 2");
    presenter.step(1);
    presenter.step(1); // there is no fourth photo
    EXPECT_EQ(currentName(), "Rail 1, stop 3");
    presenter.step(-1);
    EXPECT_EQ(currentName(), "Rail 1, stop 2");
    EXPECT_EQ(viewer.photo()->name, presenter.current()->shown().name);
}

TEST_F(ReviewPresenterTest, RecordsDecisionsAndGoesOn) {
    presenter.decide(store::Decision::Accepted);
    presenter.decide(store::Decision::Rejected);
    EXPECT_EQ(review(0).decision, store::Decision::Accepted);
    EXPECT_EQ(review(1).decision, store::Decision::Rejected);
    EXPECT_EQ(currentName(), "Rail 1, stop 3");
}

TEST_F(ReviewPresenterTest, GoesOnInAListThatTheDecidedPhotoLeaves) {
    presenter.list().setFilter(ReviewFilter::ToReview);
    presenter.decide(store::Decision::Accepted);
    EXPECT_EQ(currentName(), "Rail 1, stop 2");
    EXPECT_EQ(presenter.list().rowCount(), 2);
}

TEST_F(ReviewPresenterTest, UndoesAndRedoesDecisionsAndNotes) {
    presenter.setNote(*presenter.current()->photo, "look again");
    presenter.decide(store::Decision::Rejected);
    session->undoStack()->undo();
    EXPECT_EQ(review(0).decision, store::Decision::Open);
    EXPECT_EQ(review(0).note, "look again");
    session->undoStack()->undo();
    EXPECT_EQ(review(0).note, "");
    session->undoStack()->redo();
    session->undoStack()->redo();
    EXPECT_EQ(review(0).decision, store::Decision::Rejected);
}

TEST_F(ReviewPresenterTest, SaysWhenAnotherProgramWrites) {
    const auto other = survey.open(store::Access::Write);
    QSignalSpy message(&presenter, &ReviewPresenter::message);
    presenter.decide(store::Decision::Accepted);
    ASSERT_EQ(message.count(), 1);
    EXPECT_TRUE(message.first().first().value<Told>().text.contains("another program"));
    EXPECT_FALSE(presenter.canDecide());
    EXPECT_EQ(review(0).decision, store::Decision::Open);
    EXPECT_EQ(session->undoStack()->count(), 0);
}

TEST_F(ReviewPresenterTest, SeesWhatAnotherProgramWrites) {
    auto other = survey.open(store::Access::Write);
    other.setReview({*presenter.current()->photo, store::Decision::Accepted, "from elsewhere"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter.current()->note == "from elsewhere"; }));
}

TEST_F(ReviewPresenterTest, ComparesWithTheNearestPhotos) {
    ASSERT_EQ(presenter.neighbours().size(), 2U);
    EXPECT_EQ(presenter.neighbours().front()->stationName, "Rail 1, stop 2");
    presenter.compareWith(0);
    EXPECT_EQ(viewer.other()->name, presenter.neighbours().front()->shown().name);
    presenter.compareWith(std::nullopt);
    EXPECT_FALSE(viewer.other().has_value());
}

TEST_F(ReviewPresenterTest, CountsWhatIsLeft) {
    presenter.decide(store::Decision::Accepted);
    presenter.decide(store::Decision::Rejected);
    EXPECT_TRUE(presenter.summary().startsWith("1 accepted, 1 rejected, 1 to be reviewed"));
}

} // namespace spherewalk::ui
