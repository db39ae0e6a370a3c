// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/session/photo_reviewer.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

/// Counts how often it reads.
class CountingPresenter : public SurveyPresenter {
  public:
    int reads = 0;

  private:
    void read() override { ++reads; }
};

class SessionTest : public testing::Test {
  protected:
    std::int64_t photo() const { return session->store().photos().front().id; }

    store::Review review() const { return session->store().review(photo()); }

    test::PhotographedSurvey survey{2};
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
};

} // namespace

TEST_F(SessionTest, APresenterReadsWhenTheSurveyChanges) {
    CountingPresenter presenter;
    presenter.setSession(session.get());
    EXPECT_EQ(presenter.reads, 1);
    session->noteChanged(SurveySession::Photos);
    EXPECT_EQ(presenter.reads, 2);
}

TEST_F(SessionTest, APresenterOfAHiddenPageReadsOnceItIsShown) {
    CountingPresenter presenter;
    presenter.setShown(false);
    presenter.setSession(session.get());
    session->noteChanged(SurveySession::Photos);
    session->noteChanged(SurveySession::Photos);
    EXPECT_EQ(presenter.reads, 0);
    presenter.setShown(true);
    EXPECT_EQ(presenter.reads, 1);
}

TEST_F(SessionTest, AHiddenPresenterForgetsAClosedSurveyAtOnce) {
    CountingPresenter presenter;
    presenter.setSession(session.get());
    presenter.setShown(false);
    presenter.setSession(nullptr);
    EXPECT_EQ(presenter.reads, 2);
    EXPECT_EQ(presenter.session(), nullptr);
}

TEST_F(SessionTest, TheSelectionTellsOnlyOfAnotherStation) {
    QSignalSpy changes(session->selection(), &StationSelection::currentChanged);
    session->selection()->setCurrent(7);
    session->selection()->setCurrent(7);
    EXPECT_EQ(changes.size(), 1);
}

TEST_F(SessionTest, ADecisionIsOneStepOfUndoAndKeepsTheNote) {
    PhotoReviewer reviewer;
    reviewer.setSession(session.get());
    reviewer.setNote(photo(), " too\nbright ");
    reviewer.decide({photo()}, store::Decision::Rejected);
    EXPECT_EQ(review().decision, store::Decision::Rejected);
    EXPECT_EQ(review().note, "too bright");
    session->undoStack()->undo();
    EXPECT_EQ(review().decision, store::Decision::Open);
    EXPECT_EQ(review().note, "too bright");
}

TEST_F(SessionTest, ADecisionThatChangesNothingIsNoStep) {
    PhotoReviewer reviewer;
    reviewer.setSession(session.get());
    reviewer.decide({photo()}, store::Decision::Open);
    EXPECT_EQ(session->undoStack()->count(), 0);
}

TEST_F(SessionTest, ADecisionIsRefusedWhileAnotherProgramWrites) {
    PhotoReviewer reviewer;
    reviewer.setSession(session.get());
    QSignalSpy refusals(&reviewer, &PhotoReviewer::refused);
    const auto other = survey.open(store::Access::Write);
    reviewer.decide({photo()}, store::Decision::Accepted);
    EXPECT_EQ(refusals.size(), 1);
    EXPECT_EQ(session->undoStack()->count(), 0);
}

} // namespace spherewalk::ui
