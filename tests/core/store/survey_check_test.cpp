// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <algorithm>

namespace spherewalk::store {

namespace {

class Check : public test::SurveyTest {
  protected:
    SurveyCheck check() { return m_store.check(noProgress(), {}); }
};

class Recorder : public ProgressSink {
  public:
    void progress(double fraction, std::string_view /*activity*/) override { fractions.push_back(fraction); }

    void warning(std::string_view /*sentence*/) override {}

    std::vector<double> fractions;
};

} // namespace

TEST_F(Check, FindsNothingInASoundSurvey) {
    m_store.addPhoto(photoOf(stationAt(0), "a"));
    m_store.addPhoto(photoOf(stationAt(1), "b"));
    const SurveyCheck found = check();
    EXPECT_TRUE(found.isSound());
    EXPECT_EQ(found.photosChecked, 2);
    EXPECT_TRUE(found.filesWithoutPhoto.empty());
}

TEST_F(Check, NamesEveryPhotoThatIsNotAsRecorded) {
    for (const char* name : {"missing", "short", "changed", "folder", "good"}) {
        m_store.addPhoto(photoOf(stationAt(0), name));
    }
    const auto photos = m_store.photoFolder();
    std::filesystem::remove(photos / "missing.JPG");
    writeFile(photos / "short.JPG", bytesOf("sho"));
    writeFile(photos / "changed.JPG", bytesOf("CHANGED"));
    std::filesystem::remove(photos / "folder.JPG");
    std::filesystem::create_directory(photos / "folder.JPG");
    writeFile(photos / "stranger.txt", bytesOf("x"));
    const SurveyCheck found = check();
    EXPECT_FALSE(found.isSound());
    EXPECT_EQ(found.photosChecked, 5);
    using Kind = PhotoFinding::Kind;
    ASSERT_EQ(found.photos.size(), 4U);
    EXPECT_EQ(found.photos[0].kind, Kind::Missing);
    EXPECT_EQ(found.photos[0].sentence, "The photo missing.JPG is missing from the photo folder.");
    EXPECT_EQ(found.photos[1].kind, Kind::SizeDiffers);
    EXPECT_EQ(found.photos[1].sentence,
              "The photo short.JPG has 3 bytes, and had 5 bytes when it was recorded.");
    EXPECT_EQ(found.photos[2].kind, Kind::BytesDiffer);
    EXPECT_EQ(found.photos[3].kind, Kind::Unreadable);
    EXPECT_EQ(found.filesWithoutPhoto, std::vector<std::string>{"stranger.txt"});
}

TEST_F(Check, NamesRowsThatBreakTheRules) {
    m_store.addPhoto(photoOf(stationAt(0), "a"));
    {
        Database raw(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        raw.execute("PRAGMA foreign_keys = OFF; UPDATE photo SET station = 999, is_chosen = 0;"
                    "INSERT INTO photo SELECT 50, 3, 'x.JPG', '', '', '', replace(camera_sha256, 'a', 'b'), "
                    "file_sha256, 1, 1, 1, NULL, added_utc, 0, 0, 0, 0, '' FROM photo");
    }
    const SurveyCheck found = check();
    ASSERT_EQ(found.database.size(), 2U);
    EXPECT_EQ(found.database[0], "A row of photo refers to a row of station that is not there.");
    EXPECT_EQ(found.database[1], "None of the photos at " + m_store.station(3).name + " is chosen.");
}

TEST_F(Check, ReportsForgedRowsInsteadOfFailing) {
    m_store.addPhoto(photoOf(stationAt(0), "a"));
    {
        Database raw(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        raw.execute("UPDATE photo SET file_name = '../../etc/passwd'");
    }
    const SurveyCheck found = check();
    ASSERT_EQ(found.database.size(), 1U);
    EXPECT_THAT(found.database[0], testing::HasSubstr("the record of a photo cannot be"));
    expectRefused(ErrorKind::Corrupt, "the record of a photo cannot be", [&] { m_store.photos(); });
}

TEST_F(Check, StopsOnRequest) {
    m_store.addPhoto(photoOf(stationAt(0), "a"));
    std::stop_source stop;
    stop.request_stop();
    expectRefused(ErrorKind::Stopped, "Stopped", [&] { m_store.check(noProgress(), stop.get_token()); });
}

TEST_F(Check, TellsItsProgressWithoutGoingBack) {
    for (const char* name : {"a", "bb", "ccc"}) {
        m_store.addPhoto(photoOf(stationAt(0), name));
    }
    std::filesystem::remove(m_store.photoFolder() / "bb.JPG");
    Recorder recorder;
    m_store.check(recorder, {});
    EXPECT_TRUE(std::is_sorted(recorder.fractions.begin(), recorder.fractions.end()));
    EXPECT_EQ(recorder.fractions.front(), 0);
    EXPECT_EQ(recorder.fractions.back(), 1);
    EXPECT_GE(recorder.fractions.size(), 4U);
}

} // namespace spherewalk::store
