// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_survey.h"
#include "photographed_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/map/plan_view.h"
#include "ui/plan/plan_storage.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

using State = PlanStorage::State;

/// An editor whose plan is stored in a survey.
class PlanStorageTest : public testing::Test {
  protected:
    ~PlanStorageTest() override { storage.setSession(nullptr); }

    void openSurvey() {
        session = SurveySession::open(QString::fromStdString(test::makeSurvey(path).string()));
        storage.setSession(session.get());
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder / "room.spherewalk";
    std::unique_ptr<SurveySession> session;
    PlanEditor editor;
    PlanStorage storage{editor};
};

} // namespace

TEST_F(PlanStorageTest, TakesThePlanOfTheSurveyWithoutAnEdit) {
    openSurvey();
    EXPECT_EQ(editor.draft().room.outline, session->state().room.outline);
    EXPECT_EQ(storage.state(), State::Stored);
    EXPECT_FALSE(editor.undoStack()->canUndo());
}

TEST_F(PlanStorageTest, FlushStoresAtOnce) {
    openSurvey();
    editor.change("edit", [](PlanDraft& draft) { draft.options.stepM = 1; });
    EXPECT_EQ(storage.state(), State::Edited);
    storage.flush();
    EXPECT_EQ(storage.state(), State::Stored);
    EXPECT_EQ(session->store().planOptions().stepM, 1);
}

TEST_F(PlanStorageTest, APlanWithAProblemIsNotStored) {
    openSurvey();
    QSignalSpy problems(&storage, &PlanStorage::problem);
    editor.setOutline({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    storage.flush();
    ASSERT_EQ(problems.size(), 1);
    EXPECT_TRUE(problems[0][0].value<Told>().text.startsWith("The plan is not stored: "));
    EXPECT_EQ(session->store().room().outline.size(), 4U);
    EXPECT_EQ(session->store().room().outline[1], Eigen::Vector2d(4, 0));
}

TEST_F(PlanStorageTest, SaysThatAnotherProgramWrites) {
    openSurvey();
    const auto other = store::SurveyStore::open(path, store::Access::Write);
    QSignalSpy problems(&storage, &PlanStorage::problem);
    editor.change("edit", [](PlanDraft& draft) { draft.options.stepM = 1; });
    storage.flush();
    EXPECT_EQ(problems.size(), 1);
}

TEST_F(PlanStorageTest, FollowsAPlanThatAnotherProgramHasChanged) {
    openSurvey();
    {
        auto other = store::SurveyStore::open(path, store::Access::Write);
        survey::PlanOptions options = other.planOptions();
        options.stepM = 0.8;
        other.replacePlan(other.room(), options, survey::plan(other.room(), options));
    }
    session->noteChanged(SurveySession::Plan);
    EXPECT_EQ(editor.draft().options.stepM, 0.8);
    EXPECT_EQ(storage.state(), State::Stored);
}

TEST_F(PlanStorageTest, PhotosByHandNeedNoRailsAndTheRoomFollowsThem) {
    const test::PhotographedSurvey other(2);
    {
        auto store = store::SurveyStore::create(path, "room", survey::unknownRoom(), {}, {});
        jobs::importPhotos(store, {other / "in", {}}, noProgress(), {});
    }
    session = SurveySession::open(QString::fromStdString(path.string()));
    storage.setSession(session.get());
    EXPECT_EQ(storage.state(), State::Locked);
    EXPECT_TRUE(planOf(editor.draft()).stations.empty());
    survey::Room room = survey::unknownRoom();
    room.outline[0].x() -= 1;
    session->write(SurveySession::Everything,
                   [&](store::SurveyStore& store) { store.replaceRoom(room, store::RoomOrigin::Solved); });
    EXPECT_EQ(editor.draft().room.outline, room.outline);
}

TEST_F(PlanStorageTest, TheRoomOfPhotosByHandIsDrawnOnceTheirPlacesAreKnown) {
    const test::PhotographedSurvey other(2);
    {
        auto store = store::SurveyStore::create(path, "room", survey::unknownRoom(), {}, {});
        jobs::importPhotos(store, {other / "in", {}}, noProgress(), {});
        for (const store::StationRecord& station : store.stations()) {
            store.placeStations({{station.id, station.station.positionM, {}, true}});
        }
    }
    session = SurveySession::open(QString::fromStdString(path.string()));
    storage.setSession(session.get());
    EXPECT_EQ(storage.state(), State::Stored);
    EXPECT_FALSE(storage.isRoomDrawn());
    EXPECT_EQ(planOf(editor.draft()).stations.size(), 2U);
    const Polygon begun = editor.draft().room.outline;
    Polygon drawn = begun;
    drawn[1].x() += 0.4;
    drawn[2].x() += 0.4;
    editor.setOutline(drawn);
    EXPECT_EQ(storage.state(), State::Edited);
    storage.flush();
    EXPECT_EQ(storage.state(), State::Stored);
    EXPECT_TRUE(storage.isRoomDrawn());
    EXPECT_EQ(session->store().room().outline, drawn);
    EXPECT_EQ(session->store().photos().size(), 2U);
    EXPECT_TRUE(session->store().plan().placements.empty());
    session->noteChanged(SurveySession::Photos); // somebody reviews them
    editor.undoStack()->undo();
    EXPECT_EQ(editor.draft().room.outline, begun);
}

TEST_F(PlanStorageTest, PhotosOfUnknownPlaceLeaveTheRoomOfTheOthersToBeDrawn) {
    const test::PhotographedSurvey other(2);
    {
        auto store = store::SurveyStore::create(path, "room", survey::unknownRoom(), {}, {});
        jobs::importPhotos(store, {other / "in", {}}, noProgress(), {});
        store.placeStations({{store.stations().back().id, {3, 4, 1.2}, {}, true}});
    }
    session = SurveySession::open(QString::fromStdString(path.string()));
    storage.setSession(session.get());
    EXPECT_EQ(storage.state(), State::Stored);
    ASSERT_EQ(editor.draft().byHand.size(), 1U);
    EXPECT_EQ(editor.draft().byHand.front().positionM, Eigen::Vector3d(3, 4, 1.2));
    const survey::PlanReport report = outcomeOf(editor.draft()).report;
    EXPECT_EQ(report.stations, 1);
    EXPECT_EQ(report.floorM2, 0) << "nobody knows the room";
}

TEST_F(PlanStorageTest, ARoomThatNobodyDrewBeginsAsARectangleAroundThePhotos) {
    const test::PhotographedSurvey other(2);
    {
        auto store = store::SurveyStore::create(path, "room", survey::unknownRoom(), {}, {});
        jobs::importPhotos(store, {other / "in", {}}, noProgress(), {});
        store.placeStations({{store.stations().front().id, {100, 200, 1.2}, {}, true},
                             {store.stations().back().id, {104, 201, 1.2}, {}, true}});
    }
    session = SurveySession::open(QString::fromStdString(path.string()));
    EXPECT_TRUE(session->state().room.outline.empty());
    storage.setSession(session.get());
    EXPECT_FALSE(editor.draft().isRoomKnown);
    for (const survey::Station& photo : planOf(editor.draft()).stations) {
        EXPECT_TRUE(contains(editor.draft().room.outline, photo.positionM.head<2>()));
    }
    storage.flush();
    EXPECT_TRUE(session->store().knownRoom().outline.empty()) << "nobody has edited it";
    session->write(SurveySession::Plan, [&](store::SurveyStore& store) { // as Align does
        store.replaceRoom(editor.draft().room, store::RoomOrigin::Solved);
    });
    SurveyPlanView plan;
    plan.setSession(session.get());
    EXPECT_EQ(plan.walls(), Qt::DashLine) << "nobody has drawn it";
    session->write(SurveySession::Plan, [&](store::SurveyStore& store) {
        store.replaceRoom(survey::unknownRoom(), store::RoomOrigin::Solved);
    });
    Polygon drawn = editor.draft().room.outline;
    drawn[2] += Eigen::Vector2d(0.5, 0);
    editor.setOutline(drawn);
    storage.flush();
    EXPECT_TRUE(editor.draft().isRoomKnown);
    EXPECT_EQ(session->store().knownRoom().outline, drawn);
    EXPECT_EQ(plan.walls(), Qt::SolidLine);
    editor.undoStack()->undo();
    storage.flush();
    EXPECT_FALSE(editor.draft().isRoomKnown);
    EXPECT_TRUE(session->store().knownRoom().outline.empty());
}

TEST_F(PlanStorageTest, AnotherSurveyOfTheSameRoomShowsItsOwnRails) {
    openSurvey();
    session->write(SurveySession::Photos, [](store::SurveyStore& store) {
        store.beginShot(store.stations().front().id, "", {"", 0});
    });
    ASSERT_EQ(storage.state(), State::Locked);
    const std::filesystem::path finer = folder / "finer.spherewalk";
    {
        survey::PlanOptions options = session->state().options;
        options.stepM /= 2;
        const survey::Room& room = session->state().room;
        auto store = store::SurveyStore::create(finer, "finer", room, options, survey::plan(room, options));
        store.beginShot(store.stations().front().id, "", {"", 0});
    }
    const auto other = SurveySession::open(QString::fromStdString(finer.string()));
    storage.setSession(other.get());
    EXPECT_EQ(storage.state(), State::Locked);
    EXPECT_EQ(editor.draft().options.stepM, other->state().options.stepM);
    storage.setSession(session.get());
}

TEST_F(PlanStorageTest, ANewSurveyNeedsAPlan) {
    storage.beginNew();
    editor.setOutline({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    test::expectError(ErrorKind::InvalidInput, "",
                      [&] { storage.create(QString::fromStdString(path.string())); });
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(NewSurveyForm, ProposesANameThatIsFree) {
    const test::TemporaryFolder folder;
    QSettings().setValue("surveysPlace", QString::fromStdString(folder.path().string()));
    NewSurveyForm form;
    form.propose();
    const QString first = form.folder();
    std::filesystem::create_directories(first.toStdString());
    form.propose();
    EXPECT_NE(form.folder(), first);
    QSettings().remove("surveysPlace");
}

TEST(NewSurveyForm, MakesNoSurveyWithoutAPlanOrANameForAFolder) {
    NewSurveyForm form;
    form.propose();
    auto* create = form.findChild<QPushButton*>("createSurvey");
    EXPECT_FALSE(create->isEnabled());
    form.setPossible(true);
    EXPECT_TRUE(create->isEnabled());
    for (const char* name : {"", "  ", "a/b"}) {
        form.findChild<QLineEdit*>("surveyName")->setText(name);
        EXPECT_FALSE(create->isEnabled()) << name;
    }
}

} // namespace spherewalk::ui
