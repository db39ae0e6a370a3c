// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <limits>

namespace spherewalk::store {

namespace {

survey::PrivateRegion regionAt(double azimuthDeg, double elevationDeg = 0) {
    return {Degrees(azimuthDeg), Degrees(elevationDeg), Degrees(10), Degrees(12)};
}

class RegionRecords : public test::SurveyTest {
  protected:
    std::int64_t m_photo = m_store.addPhoto(photoOf(stationAt(0), "a"));
};

} // namespace

TEST_F(RegionRecords, KeepWhatAPersonMarks) {
    const std::int64_t id = m_store.markRegion(m_photo, regionAt(170, -80));
    const RegionRecord expected{id, m_photo, regionAt(170, -80), RegionOrigin::Marked};
    EXPECT_EQ(m_store.regions(m_photo), std::vector{expected});
    EXPECT_EQ(SurveyStore::open(m_path, Access::Read).regions(), std::vector{expected});
}

TEST_F(RegionRecords, AreReplacedByTheNextSearch) {
    EXPECT_EQ(m_store.setFoundRegions(m_photo, {regionAt(0), regionAt(40)}, 1), 2U);
    EXPECT_EQ(m_store.setFoundRegions(m_photo, {regionAt(90)}, 1), 1U);
    ASSERT_EQ(m_store.regions().size(), 1U);
    EXPECT_EQ(m_store.regions()[0].region, regionAt(90));
    EXPECT_EQ(m_store.regions()[0].origin, RegionOrigin::Found);
}

TEST_F(RegionRecords, StayRemovedWhenOneSearchesAgain) {
    m_store.setFoundRegions(m_photo, {regionAt(0), regionAt(40)}, 1);
    m_store.removeRegion(m_store.regions()[0].id);
    EXPECT_EQ(m_store.setFoundRegions(m_photo, {regionAt(2), regionAt(41)}, 1), 1U);
    const std::vector<RegionRecord> regions = m_store.regions();
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[0].origin, RegionOrigin::Rejected);
    EXPECT_EQ(regions[1].region, regionAt(41));
}

TEST_F(RegionRecords, ThatAreMarkedAreNotFoundOnceMore) {
    m_store.markRegion(m_photo, regionAt(-179));
    EXPECT_EQ(m_store.setFoundRegions(m_photo, {regionAt(179)}, 1), 0U)
        << "both show the same, over the seam";
}

TEST_F(RegionRecords, AreGoneWhenAPersonRemovesWhatAPersonMarked) {
    const std::int64_t id = m_store.markRegion(m_photo, regionAt(5));
    const RegionRecord record = m_store.regions().front();
    m_store.removeRegion(id);
    EXPECT_TRUE(m_store.regions().empty());
    m_store.restoreRegion(record);
    EXPECT_EQ(m_store.regions(), std::vector{record}) << "undo brings it back as it was";
}

TEST_F(RegionRecords, TellWhichPhotosWereSearched) {
    const std::int64_t other = m_store.addPhoto(photoOf(stationAt(1), "b"));
    m_store.setFoundRegions(other, {}, 2);
    EXPECT_EQ(m_store.searchedPhotos(2), std::vector{other});
    EXPECT_TRUE(m_store.searchedPhotos(3).empty()) << "another method finds other things";
}

TEST_F(RegionRecords, RefuseWhatIsNone) {
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] { m_store.markRegion(99, regionAt(0)); });
    expectRefused(ErrorKind::NotFound, "no private region 7", [&] { m_store.removeRegion(7); });
    survey::PrivateRegion wrong = regionAt(0);
    wrong.width = Radians(std::numeric_limits<double>::quiet_NaN());
    expectRefused(ErrorKind::InvalidInput, "an angle is no number",
                  [&] { m_store.markRegion(m_photo, wrong); });
    wrong.width = Degrees(0);
    expectRefused(ErrorKind::InvalidInput, "a side of 0 degrees",
                  [&] { m_store.markRegion(m_photo, wrong); });
    expectRefused(ErrorKind::InvalidInput, "beyond a pole",
                  [&] { m_store.markRegion(m_photo, regionAt(0, 91)); });
    m_store.setFoundRegions(m_photo, {regionAt(0)}, 1);
    const std::int64_t id = m_store.regions().front().id;
    m_store.removeRegion(id);
    expectRefused(ErrorKind::NotFound, "no private region", [&] { m_store.removeRegion(id); });
}

TEST_F(RegionRecords, OlderSurveysGetTheTables) {
    const auto file = m_folder / "old.sqlite";
    Database database(file, Database::Mode::Create, std::chrono::seconds(1));
    makeSchema(database, migrations().first(6));
    migrate(database, migrations());
    EXPECT_EQ(database.integer("SELECT count(*) FROM private_region"), 0);
    EXPECT_EQ(database.integer("SELECT count(*) FROM face_search"), 0);
}

} // namespace spherewalk::store
