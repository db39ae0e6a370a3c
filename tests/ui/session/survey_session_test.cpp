// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/map/plan_view.h"
#include "ui/review/review_model.h"
#include "ui/session/survey_session.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

QString surveyIn(const test::TemporaryFolder& folder) {
    return QString::fromStdString(test::makeSurvey(folder / "room.spherewalk").string());
}

} // namespace

TEST(SurveySession, ShowsItsOwnWritesToReaders) {
    const test::TemporaryFolder folder;
    const auto session = SurveySession::open(surveyIn(folder));
    const std::size_t before = session->store().stations().size();
    session->write(SurveySession::Plan, [](store::SurveyStore& store) { store.addStation({1, 1, 1.2}); });
    EXPECT_EQ(session->store().stations().size(), before + 1);
}

TEST(SurveySession, TellsWhatChanged) {
    const test::TemporaryFolder folder;
    const auto session = SurveySession::open(surveyIn(folder));
    QSignalSpy changes(session.get(), &SurveySession::changed);
    session->write(SurveySession::Plan, [](store::SurveyStore& store) { store.addStation({1, 1, 1.2}); });
    ASSERT_EQ(changes.size(), 1);
    EXPECT_EQ(changes[0][0].value<SurveySession::Changes>(), SurveySession::Plan);
}

TEST(SurveySession, ReadsInTheBackgroundWhatAnotherWrites) {
    const test::TemporaryFolder folder;
    const QString survey = surveyIn(folder);
    const auto session = SurveySession::open(survey);
    const std::size_t before = session->state().stations.size();
    QSignalSpy changes(session.get(), &SurveySession::changed);
    auto writer = store::SurveyStore::open(survey.toStdString(), store::Access::Write);
    writer.addStation({1, 1, 1.2});
    session->noteChangedSoon(SurveySession::Plan);
    ASSERT_TRUE(changes.wait());
    EXPECT_EQ(changes[0][0].value<SurveySession::Changes>(), SurveySession::Plan);
    EXPECT_EQ(session->state().stations.size(), before + 1);
}

TEST(SurveySession, DropsWhatTheBackgroundReadBeforeANewerChange) {
    const test::TemporaryFolder folder;
    const auto session = SurveySession::open(surveyIn(folder));
    const std::size_t before = session->state().stations.size();
    QSignalSpy changes(session.get(), &SurveySession::changed);
    session->noteChangedSoon(SurveySession::Photos);
    session->write(SurveySession::Plan, [](store::SurveyStore& store) { store.addStation({1, 1, 1.2}); });
    EXPECT_EQ(changes.size(), 1); // with what was to be told soon
    session->noteChangedSoon(SurveySession::Plan);
    ASSERT_TRUE(changes.wait());
    EXPECT_EQ(changes.size(), 2);
    EXPECT_EQ(session->state().stations.size(), before + 1);
}

TEST(SurveySession, CanBeReadWhileAnotherWrites) {
    const test::TemporaryFolder folder;
    const QString survey = surveyIn(folder);
    const auto writer = store::SurveyStore::open(survey.toStdString(), store::Access::Write);
    const auto session = SurveySession::open(survey);
    EXPECT_TRUE(session->isReadOnly());
    EXPECT_EQ(session->name(), "room");
    test::expectError(ErrorKind::Busy, "", [&] { session->write(SurveySession::Plan, [](auto&) {}); });
}

TEST(SurveySession, TellsNothingIfAChangeFails) {
    const test::TemporaryFolder folder;
    const auto session = SurveySession::open(surveyIn(folder));
    QSignalSpy changes(session.get(), &SurveySession::changed);
    test::expectError(ErrorKind::NotFound, "", [&] {
        session->write(SurveySession::Photos, [](store::SurveyStore& store) { store.choosePhoto(99); });
    });
    EXPECT_TRUE(changes.isEmpty());
}

TEST(SurveySession, TellsOneStandingOfEachPhoto) {
    const test::PhotographedSurvey survey(4);
    const auto session = SurveySession::open(QString::fromStdString(survey.path().string()));
    const auto stationAt = [&](std::size_t i) { return session->store().stations().at(i).id; };
    const auto photoAt = [&](std::size_t i) { return session->store().chosenPhoto(stationAt(i))->id; };
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        store.setVerdict({photoAt(0), survey::Quality::Good, "[]"});
        store.setVerdict({photoAt(1), survey::Quality::Doubtful, "[]"});
        store.setVerdict({photoAt(2), survey::Quality::Failed, "[]"});
        store.setVerdict({photoAt(3), survey::Quality::Failed, "[]"});
        store.setReview({photoAt(3), store::Decision::Accepted, ""});
    });
    const auto& standings = session->state().standings;
    EXPECT_EQ(standings.at(stationAt(0)), Standing::Taken);
    EXPECT_EQ(standings.at(stationAt(1)), Standing::Doubtful);
    EXPECT_EQ(standings.at(stationAt(2)), Standing::Failed);
    EXPECT_EQ(standings.at(stationAt(3)), Standing::Accepted);
    EXPECT_EQ(standings.at(stationAt(4)), Standing::Missing);
    EXPECT_EQ(session->state().count(Standing::Doubtful), 1);
    SurveyPlanView plan;
    plan.setSession(session.get());
    const std::vector<ReviewRow> rows = reviewRows(session->store(), session->state().findings);
    ASSERT_EQ(plan.stations().size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(plan.stations()[i].standing, rows[i].standing) << i;
    }
    plan.setSession(nullptr);
}

} // namespace spherewalk::ui
