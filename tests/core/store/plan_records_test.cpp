// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <cmath>

namespace spherewalk::store {

using survey::CaptureProfile;

namespace {

class PlanRecords : public test::SurveyTest {};

class ProfileRecords : public test::SurveyTest {
  protected:
    /// Changes the database as no survey would be, and reads the profile.
    std::optional<CaptureProfile> readAfter(const std::string& sql) const {
        Database database(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        database.execute(sql);
        return m_store.captureProfile();
    }
};

} // namespace

TEST_F(PlanRecords, KeepTheRoomTheOptionsAndThePlanToTheLastBit) {
    const survey::Plan planned = survey::plan(test::smallRoom(), test::twoHeights());
    const SurveyStore read = SurveyStore::open(m_path, Access::Read);
    EXPECT_EQ(read.room().outline, test::smallRoom().outline);
    EXPECT_EQ(read.room().obstacles, test::smallRoom().obstacles);
    EXPECT_EQ(read.room().ceilingM, 2.6);
    EXPECT_EQ(read.planOptions().heightsM, test::twoHeights().heightsM);
    EXPECT_EQ(read.planOptions().stepM, 0.2);
    EXPECT_EQ(read.planOptions().railStops, 4);
    EXPECT_EQ(read.planOptions().clearanceM, 0.3);
    EXPECT_EQ(read.planOptions().secondsPerPhoto, 12);
    EXPECT_EQ(read.planOptions().secondsPerPlacement, 60);
    const survey::Plan plan = read.plan();
    ASSERT_EQ(plan.stations.size(), planned.stations.size());
    ASSERT_EQ(plan.stations.size(), 24U);
    for (std::size_t i = 0; i < plan.stations.size(); ++i) {
        EXPECT_EQ(plan.stations[i].positionM, planned.stations[i].positionM);
        EXPECT_EQ(plan.stations[i].placement, planned.stations[i].placement);
        EXPECT_EQ(plan.stations[i].stop, planned.stations[i].stop);
    }
    ASSERT_EQ(plan.placements.size(), planned.placements.size());
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        EXPECT_EQ(plan.placements[i].origin, planned.placements[i].origin);
        EXPECT_EQ(plan.placements[i].heading, planned.placements[i].heading);
        EXPECT_EQ(plan.placements[i].stops, planned.placements[i].stops);
        EXPECT_EQ(plan.placements[i].stepM, planned.placements[i].stepM);
    }
}

TEST_F(PlanRecords, KeepTheNamesOfRooms) {
    survey::Room room = test::smallRoom();
    const Eigen::Vector2d corner = room.outline.front();
    room.names = {{"kuchnia", corner + Eigen::Vector2d(0.1, 0.1)},
                  {"hall", corner + Eigen::Vector2d(0.4, 0.2)}};
    const std::vector<survey::RoomName> names = room.names;
    m_store.replacePlan(room, test::twoHeights(), survey::plan(room, test::twoHeights()));
    EXPECT_EQ(SurveyStore::open(m_path, Access::Read).room().names, names);
    room.names.clear();
    m_store.replacePlan(room, test::twoHeights(), survey::plan(room, test::twoHeights()));
    EXPECT_TRUE(SurveyStore::open(m_path, Access::Read).room().names.empty());
}

TEST_F(PlanRecords, NameStationsInWalkingOrder) {
    const auto stations = m_store.stations();
    EXPECT_EQ(stations.front().name, "rail 1, stop 1 at 1.60 m");
    EXPECT_EQ(stations.back().name, "rail 3, stop 4 at 0.90 m");
    EXPECT_EQ(m_store.station(stations[5].id).name, stations[5].name);
    expectRefused(ErrorKind::NotFound, "There is no station 999 in the survey",
                  [&] { m_store.station(999); });
}

TEST_F(PlanRecords, SayWhichSurveyItIs) {
    const SurveyInfo info = m_store.info();
    EXPECT_EQ(info.name, "Small room");
    EXPECT_EQ(info.uuid.size(), 36U);
    EXPECT_LT(std::chrono::abs(std::chrono::system_clock::now() - info.createdAt), std::chrono::minutes(5));
}

TEST_F(PlanRecords, AddStationsOutsideThePlan) {
    const std::int64_t unnamed = m_store.addStation({0.5, 0.25, 1.4});
    const std::int64_t named = m_store.addStation({0.5, 0.25, 1.4}, "window sill");
    EXPECT_EQ(m_store.station(unnamed).name, "unplanned position (0.50, 0.25)");
    EXPECT_EQ(m_store.station(named).name, "window sill");
    EXPECT_EQ(m_store.station(named).station.placement, -1);
    EXPECT_EQ(m_store.plan().stations.back().positionM, Eigen::Vector3d(0.5, 0.25, 1.4));
    expectRefused(ErrorKind::InvalidInput, "its position is not a number", [&] {
        m_store.addStation({NAN, 0, 0});
    });
    expectRefused(ErrorKind::InvalidInput, "must be one line of UTF-8", [&] {
        m_store.addStation({0, 0, 1}, "a\nb");
    });
}

TEST_F(PlanRecords, MoveStationsOutsideThePlanAllOrNone) {
    const std::int64_t first = m_store.addStation({0, 0, 1}, "unknown place 1", false);
    const std::int64_t second = m_store.addStation({1, 0, 1}, "unknown place 2", false);
    m_store.beginShot(first, "", {"", 0}); // it is in use all the same
    m_store.placeStations({{first, {0.2, 0.3, 1.1}, "window", true}, {second, {0.4, 0.3, 1.1}, "", false}});
    EXPECT_EQ(m_store.station(first).name, "window");
    EXPECT_EQ(m_store.station(first).station.positionM, Eigen::Vector3d(0.2, 0.3, 1.1));
    EXPECT_TRUE(m_store.station(first).isPlaceKnown);
    EXPECT_EQ(m_store.station(second).name, "unknown place 2");
    EXPECT_FALSE(m_store.station(second).isPlaceKnown);
    expectRefused(ErrorKind::InvalidInput, "it is part of the plan", [&] {
        m_store.placeStations({{second, {9, 9, 9}}, {stationAt(0), {9, 9, 9}}});
    });
    expectRefused(ErrorKind::InvalidInput, "its position is not a number", [&] {
        m_store.placeStations({{second, {9, 9, 9}}, {first, {NAN, 0, 0}}});
    });
    expectRefused(ErrorKind::NotFound, "", [&] {
        m_store.placeStations({{second, {9, 9, 9}}, {99'999, {0, 0, 0}}});
    });
    EXPECT_EQ(m_store.station(second).station.positionM, Eigen::Vector3d(0.4, 0.3, 1.1));
}

TEST_F(PlanRecords, AreReplacedBeforeTheFirstShot) {
    const survey::PlanOptions coarse{.stepM = 0.4};
    m_store.replacePlan(test::smallRoom(), coarse, survey::plan(test::smallRoom(), coarse));
    EXPECT_EQ(m_store.planOptions().stepM, 0.4);
    EXPECT_EQ(m_store.stations().size(), survey::plan(test::smallRoom(), coarse).stations.size());
}

TEST_F(PlanRecords, AreNotReplacedOnceThereIsAShot) {
    m_store.beginShot(stationAt(0), "", {"", 0});
    expectRefused(ErrorKind::InvalidInput, "photos have been taken at its stations", [&] {
        m_store.replacePlan(test::smallRoom(), test::twoHeights(),
                            survey::plan(test::smallRoom(), test::twoHeights()));
    });
    EXPECT_EQ(m_store.stations().size(), 24U);
    EXPECT_EQ(m_store.openShots().size(), 1U);
}

TEST_F(PlanRecords, KeepARoomThatRailsWerePlannedFor) {
    expectRefused(ErrorKind::InvalidInput, "its rails were planned for the room as it is",
                  [&] { m_store.replaceRoom(survey::unknownRoom(), RoomOrigin::Solved); });
    EXPECT_EQ(m_store.room().outline, test::smallRoom().outline);
}

TEST_F(PlanRecords, TakeAnotherRoomWithoutRails) {
    m_store.replacePlan(test::smallRoom(), test::twoHeights(), {});
    const std::int64_t station = m_store.addStation({1, 1, 1});
    survey::Room room = survey::unknownRoom();
    room.names = {{"kitchen", {0, 0}}};
    EXPECT_EQ(m_store.roomOrigin(), RoomOrigin::Solved);
    m_store.replaceRoom(room, RoomOrigin::Drawn);
    EXPECT_EQ(m_store.roomOrigin(), RoomOrigin::Drawn);
    EXPECT_EQ(m_store.room().outline, room.outline);
    EXPECT_EQ(m_store.room().ceilingM, room.ceilingM);
    EXPECT_EQ(m_store.room().names.size(), 1U);
    EXPECT_EQ(m_store.planOptions().heightsM, test::twoHeights().heightsM);
    EXPECT_EQ(m_store.station(station).station.positionM, Eigen::Vector3d(1, 1, 1));
    room.ceilingM = -1;
    expectRefused(ErrorKind::InvalidInput, "", [&] { m_store.replaceRoom(room, RoomOrigin::Solved); });
    EXPECT_EQ(m_store.roomOrigin(), RoomOrigin::Drawn);
}

TEST_F(PlanRecords, KnowWhetherSomebodySaidHowHighTheLensIs) {
    expectRefused(ErrorKind::InvalidInput, "its rails were planned for the cart's",
                  [&] { m_store.setLensHeight(1.4); });
    survey::PlanOptions guess = test::twoHeights();
    guess.heightsM = {1.2};
    guess.areHeightsGuessed = true;
    m_store.replacePlan(survey::unknownRoom(), guess, {});
    EXPECT_TRUE(SurveyStore::open(m_path, Access::Read).planOptions().areHeightsGuessed);
    expectRefused(ErrorKind::InvalidInput, "below the ceiling", [&] { m_store.setLensHeight(9); });
    EXPECT_TRUE(m_store.planOptions().areHeightsGuessed);
    m_store.setLensHeight(1.4);
    EXPECT_EQ(m_store.planOptions().heightsM, std::vector<double>{1.4});
    EXPECT_FALSE(m_store.planOptions().areHeightsGuessed);
}

TEST_F(PlanRecords, KnowWhetherARoomIsKnown) {
    EXPECT_EQ(m_store.knownRoom().outline, test::smallRoom().outline);
    m_store.replacePlan(survey::unknownRoom(), test::twoHeights(), {});
    EXPECT_EQ(m_store.room().outline.size(), 4U);
    EXPECT_TRUE(m_store.knownRoom().outline.empty()) << "nobody said anything of a room";
    EXPECT_EQ(m_store.knownRoom().ceilingM, 0);
    m_store.replaceRoom(test::smallRoom(), RoomOrigin::Solved);
    EXPECT_EQ(m_store.knownRoom().outline, test::smallRoom().outline);
    m_store.replaceRoom(survey::unknownRoom(), RoomOrigin::Drawn);
    EXPECT_EQ(m_store.knownRoom().outline, survey::unknownRoom().outline) << "somebody drew it";
    m_store.replacePlan(survey::unknownRoom(), test::twoHeights(),
                        survey::plan(survey::unknownRoom(), test::twoHeights()));
    EXPECT_EQ(m_store.knownRoom().outline.size(), 4U) << "rails were planned for it";
}

TEST_F(PlanRecords, RefusePlansThatContradictThemselves) {
    survey::Plan broken = survey::plan(test::smallRoom(), test::twoHeights());
    broken.stations[3].placement = 77;
    expectRefused(ErrorKind::InvalidInput, "a station is not on the rail that it names",
                  [&] { m_store.replacePlan(test::smallRoom(), test::twoHeights(), broken); });
    broken = survey::plan(test::smallRoom(), test::twoHeights());
    broken.placements[0].heading = Radians(NAN);
    expectRefused(ErrorKind::InvalidInput, "numbers that no rail can have",
                  [&] { m_store.replacePlan(test::smallRoom(), test::twoHeights(), broken); });
}

TEST(PlanRecordsOfARoom, WithoutStationsAreKeptToo) {
    const spherewalk::test::TemporaryFolder folder;
    const survey::Room corridor{
        .outline = {{0, 0}, {5, 0}, {5, 0.5}, {0, 0.5}}, .obstacles = {}, .ceilingM = 2};
    const auto store =
        SurveyStore::create(folder / "c.spherewalk", "Corridor", corridor, {}, survey::plan(corridor, {}));
    EXPECT_TRUE(store.stations().empty());
    EXPECT_TRUE(store.room().obstacles.empty());
}

TEST_F(ProfileRecords, AreAutomaticInANewSurvey) {
    EXPECT_EQ(m_store.captureProfile(), CaptureProfile{});
}

TEST_F(ProfileRecords, AreReadAsTheyWereWritten) {
    CaptureProfile profile;
    profile.iso = 200;
    profile.shutterS = 1.0 / 60;
    profile.whiteBalance = survey::WhiteBalance::DaylightFluorescent;
    profile.photoWidth = 5376;
    m_store.setCaptureProfile(profile);
    EXPECT_EQ(SurveyStore::open(m_path, Access::Read).captureProfile(), profile);
    m_store.setCaptureProfile(std::nullopt);
    EXPECT_EQ(m_store.captureProfile(), std::nullopt);
}

TEST(Profiles, AreNoneInASurveyFromBeforeThem) {
    const spherewalk::test::TemporaryFolder folder;
    const auto path = folder / "old.spherewalk";
    test::createSurvey(path);
    {
        Database database(path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        database.execute(
            "ALTER TABLE survey DROP COLUMN are_heights_guessed; "
            "ALTER TABLE survey DROP COLUMN is_room_drawn; DROP TABLE private_region; DROP TABLE "
            "face_search; "
            "ALTER TABLE placement DROP COLUMN is_locked; ALTER TABLE survey DROP COLUMN is_by_hand; "
            "ALTER TABLE station DROP COLUMN is_place_known; DROP TABLE room_name; DROP TABLE verdict; "
            "DROP TABLE capture_profile; PRAGMA user_version = 2");
    }
    EXPECT_EQ(SurveyStore::open(path, Access::Read).captureProfile(), std::nullopt);
}

TEST_F(ProfileRecords, RefuseWhatNoCameraHas) {
    CaptureProfile profile;
    profile.shutterS = -1;
    expectRefused(ErrorKind::InvalidInput, "shutter", [&] { m_store.setCaptureProfile(profile); });
    EXPECT_EQ(m_store.captureProfile(), CaptureProfile{});
    for (const char* sql : {"UPDATE capture_profile SET white_balance = 'blue'",
                            "UPDATE capture_profile SET white_balance = 'auto', iso = -5",
                            "UPDATE capture_profile SET iso = NULL, compensation_ev = 1e9"}) {
        expectRefused(ErrorKind::Corrupt, "", [&] { readAfter(sql); });
    }
}

} // namespace spherewalk::store
