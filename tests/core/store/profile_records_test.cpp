// SPDX-License-Identifier: GPL-3.0-or-later
#include "schema.h"
#include "survey_fixture.h"

namespace spherewalk::store {

namespace {

using survey::CaptureProfile;

class ProfileRecords : public test::SurveyTest {
  protected:
    /// Changes the database as no survey would be, and reads the profile.
    std::optional<CaptureProfile> readAfter(const std::string& sql) const {
        const Database database(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        database.execute(sql);
        return m_store.captureProfile();
    }
};

} // namespace

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
        const Database database(path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
        database.execute("DROP TABLE verdict; DROP TABLE capture_profile; PRAGMA user_version = 2");
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
