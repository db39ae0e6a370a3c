// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey_fixture.h"

namespace spherewalk::store {

namespace {

class ShotRecords : public test::SurveyTest {};

} // namespace

TEST_F(ShotRecords, KeepEveryFieldThroughAllSteps) {
    const std::int64_t station = stationAt(4);
    const survey::Shot begun = m_store.beginShot(station, "YN1", {"http://c/R9.JPG", 17});
    EXPECT_EQ(begun.step, survey::ShotStep::Intended);
    m_store.markStarted(begun.id, "306");
    EXPECT_EQ(m_store.shot(begun.id).step, survey::ShotStep::Started);
    m_store.markTaken(begun.id, "http://c/R10.JPG");
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    const survey::Shot taken = reader.openShots().at(0);
    EXPECT_EQ(taken.id, begun.id);
    EXPECT_EQ(taken.station, station);
    EXPECT_EQ(taken.step, survey::ShotStep::Taken);
    EXPECT_EQ(taken.intendedAt, begun.intendedAt);
    EXPECT_EQ(taken.cameraSerial, "YN1");
    EXPECT_EQ(taken.baseline.latestFileUrl, "http://c/R9.JPG");
    EXPECT_EQ(taken.baseline.totalEntries, 17);
    EXPECT_EQ(taken.commandId, "306");
    EXPECT_EQ(taken.fileUrl, "http://c/R10.JPG");
    const std::int64_t photo = m_store.recordDownload(begun.id, photoOf(station, "a"));
    EXPECT_EQ(reader.shot(begun.id).step, survey::ShotStep::Downloaded);
    EXPECT_EQ(reader.shot(begun.id).photo, photo);
    EXPECT_TRUE(reader.openShots().empty());
}

TEST_F(ShotRecords, AreSettledByAPersonWhereUnclear) {
    const survey::Shot a = m_store.beginShot(stationAt(0), "", {"", 0});
    m_store.markUnclear(a.id, "two new files");
    EXPECT_TRUE(m_store.openShots().empty());
    ASSERT_EQ(m_store.unclearShots().size(), 1U);
    EXPECT_EQ(m_store.unclearShots()[0].note, "two new files");
    EXPECT_EQ(m_store.counts().unclearShots, 1);
    m_store.markTaken(a.id, "http://c/R1.JPG");
    EXPECT_EQ(m_store.openShots().size(), 1U);
    const survey::Shot b = m_store.beginShot(stationAt(1), "", {"", 0});
    m_store.markUnclear(b.id, "another camera");
    m_store.markNotTaken(b.id);
    EXPECT_EQ(m_store.shot(b.id).step, survey::ShotStep::NotTaken);
    EXPECT_EQ(m_store.counts().openShots, 1);
}

TEST_F(ShotRecords, AllowNoOtherOrderOfSteps) {
    const std::int64_t station = stationAt(0);
    const std::int64_t intended = m_store.beginShot(station, "", {"", 0}).id;
    expectRefused(ErrorKind::InvalidInput, "is recorded as intended, and cannot become downloaded",
                  [&] { m_store.recordDownload(intended, photoOf(station, "a")); });
    m_store.markNotTaken(intended);
    for (const auto& change : std::vector<std::function<void()>>{
             [&] { m_store.markStarted(intended, "1"); }, [&] { m_store.markTaken(intended, "u"); },
             [&] { m_store.markNotTaken(intended); }, [&] { m_store.markUnclear(intended, "w"); }}) {
        expectRefused(ErrorKind::InvalidInput, "is recorded as not_taken", change);
    }
    EXPECT_EQ(m_store.shot(intended).step, survey::ShotStep::NotTaken);
    expectRefused(ErrorKind::NotFound, "There is no shot 99 in the survey",
                  [&] { m_store.markStarted(99, "1"); });
    expectRefused(ErrorKind::NotFound, "There is no station 99 in the survey", [&] {
        m_store.beginShot(99, "", {"", 0});
    });
}

TEST_F(ShotRecords, RecordThePhotoAndTheStepTogetherOrNeither) {
    const std::int64_t station = stationAt(0);
    m_store.addPhoto(photoOf(stationAt(1), "a"));
    const std::int64_t shot = m_store.beginShot(station, "", {"", 0}).id;
    m_store.markTaken(shot, "u");
    expectRefused(ErrorKind::Exists, "is in the survey already",
                  [&] { m_store.recordDownload(shot, photoOf(station, "a")); });
    expectRefused(ErrorKind::InvalidInput, "its shot was taken at station",
                  [&] { m_store.recordDownload(shot, photoOf(stationAt(2), "b")); });
    EXPECT_EQ(m_store.shot(shot).step, survey::ShotStep::Taken);
    EXPECT_EQ(m_store.counts().photos, 1);
    m_store.recordDownload(shot, photoOf(station, "b"));
    EXPECT_EQ(m_store.shot(shot).step, survey::ShotStep::Downloaded);
    EXPECT_EQ(m_store.chosenPhoto(station)->fileName, "b.JPG");
}

} // namespace spherewalk::store
