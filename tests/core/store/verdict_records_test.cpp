// SPDX-License-Identifier: GPL-3.0-or-later
#include "schema.h"
#include "survey_fixture.h"

namespace spherewalk::store {

namespace {

class VerdictRecords : public test::SurveyTest {
  protected:
    std::int64_t m_photo = m_store.addPhoto(photoOf(stationAt(0), "a"));
};

} // namespace

TEST_F(VerdictRecords, KeepTheLatestVerdict) {
    EXPECT_EQ(m_store.verdict(m_photo), std::nullopt);
    m_store.setVerdict({m_photo, CheckResult::Failed, R"([{"flaw":"blur"}])"});
    const PhotoVerdict latest{m_photo, CheckResult::Doubtful, R"([{"flaw":"foreign"}])"};
    m_store.setVerdict(latest);
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    EXPECT_EQ(reader.verdict(m_photo), latest);
    EXPECT_EQ(reader.verdicts(), std::vector{latest});
}

TEST_F(VerdictRecords, LeaveWhatAPersonDecidedAlone) {
    m_store.setReview({m_photo, Decision::Accepted, "It is fine"});
    m_store.setVerdict({m_photo, CheckResult::Failed, "[]"});
    EXPECT_EQ(m_store.review(m_photo).decision, Decision::Accepted);
}

TEST_F(VerdictRecords, RefuseUnknownPhotosAndFindingsThatAreNone) {
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] {
        m_store.setVerdict({99, CheckResult::Good, "[]"});
    });
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] { m_store.verdict(99); });
    for (const char* findings : {"", "{}", "[", "\"blur\""}) {
        expectRefused(ErrorKind::InvalidInput, "findings", [&] {
            m_store.setVerdict({m_photo, CheckResult::Good, findings});
        });
    }
}

TEST_F(VerdictRecords, OlderSurveysGetTheTable) {
    const auto file = m_folder / "old.sqlite";
    const Database database(file, Database::Mode::Create, std::chrono::seconds(1));
    makeSchema(database, migrations().first(3));
    migrate(database, migrations());
    EXPECT_EQ(database.integer("SELECT count(*) FROM verdict"), 0);
}

} // namespace spherewalk::store
