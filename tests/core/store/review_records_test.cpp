// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

namespace spherewalk::store {

namespace {

class ReviewRecords : public test::SurveyTest {
  protected:
    std::int64_t m_photo = m_store.addPhoto(photoOf(stationAt(0), "a"));
};

class MovedPhotos : public test::SurveyTest {
  protected:
    std::int64_t m_a = m_store.addPhoto(photoOf(stationAt(0), "a"));
    std::int64_t m_b = m_store.addPhoto(photoOf(stationAt(1), "b"));

    MovedPhoto moved(std::int64_t photo, std::size_t station) const {
        const PhotoRecord record = m_store.photo(photo);
        return {
            photo,           m_store.stations().at(station).id, {7, 8, 9}, record.fileName, record.fileSha256,
            record.sizeBytes};
    }
};

class VerdictRecords : public test::SurveyTest {
  protected:
    std::int64_t m_photo = m_store.addPhoto(photoOf(stationAt(0), "a"));
};

} // namespace

TEST_F(ReviewRecords, KeepTheDecisionAndTheNote) {
    EXPECT_EQ(m_store.review(m_photo), (Review{m_photo, Decision::Open, ""}));
    m_store.setReview({m_photo, Decision::Rejected, "Someone walks through it"});
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    EXPECT_EQ(reader.review(m_photo), (Review{m_photo, Decision::Rejected, "Someone walks through it"}));
    EXPECT_EQ(reader.reviews().size(), 1U);
}

TEST_F(ReviewRecords, VanishWhenNothingIsLeftOfThem) {
    m_store.setReview({m_photo, Decision::Accepted, ""});
    m_store.setReview({m_photo, Decision::Open, ""});
    EXPECT_TRUE(m_store.reviews().empty());
}

TEST_F(ReviewRecords, RejectedPhotosAreLeftOutAndAreToBeTakenAgain) {
    const std::size_t missing = m_store.stationsWithoutPhoto().size();
    m_store.setReview({m_photo, Decision::Rejected, ""});
    EXPECT_EQ(m_store.stationsWithoutPhoto().size(), missing + 1);
    EXPECT_EQ(m_store.stationsWithoutPhoto().front().id, stationAt(0));
    EXPECT_EQ(m_store.counts().stationsWithPhoto, 0);
    EXPECT_EQ(m_store.counts().rejectedPhotos, 1);
    EXPECT_EQ(m_store.chosenPhotos().size(), 1U);
    EXPECT_TRUE(m_store.keptPhotos().empty());
}

TEST_F(ReviewRecords, ANewPhotoTakesThePlaceOfTheRejectedOne) {
    m_store.setReview({m_photo, Decision::Rejected, ""});
    const std::int64_t second = m_store.addPhoto(photoOf(stationAt(0), "b"));
    EXPECT_EQ(m_store.keptPhotos().at(0).id, second);
    EXPECT_EQ(m_store.counts().rejectedPhotos, 0);
}

TEST_F(ReviewRecords, RefuseUnknownPhotosAndNotesOfSeveralLines) {
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] {
        m_store.setReview({99, Decision::Accepted, ""});
    });
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] { m_store.review(99); });
    expectRefused(ErrorKind::InvalidInput, "one line", [&] {
        m_store.setReview({m_photo, Decision::Open, "a\nb"});
    });
}

TEST_F(ReviewRecords, AreRefusedOfASurveyOpenForReading) {
    SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    expectRefused(ErrorKind::InvalidInput, "reading only", [&] {
        reader.setReview({m_photo, Decision::Accepted, ""});
    });
}

TEST_F(ReviewRecords, OlderSurveysGetTheTable) {
    const auto file = m_folder / "old.sqlite";
    Database database(file, Database::Mode::Create, std::chrono::seconds(1));
    makeSchema(database, migrations().first(1));
    migrate(database, migrations());
    EXPECT_EQ(database.integer("SELECT count(*) FROM review"), 0);
}

TEST_F(ReviewRecords, ChangesByOthersAreSeenInTheDataVersion) {
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    const std::int64_t before = reader.dataVersion();
    EXPECT_EQ(reader.dataVersion(), before);
    m_store.setReview({m_photo, Decision::Accepted, ""});
    EXPECT_NE(reader.dataVersion(), before);
}

TEST(Decisions, AreCalledByTheirNames) {
    for (const Decision decision : {Decision::Open, Decision::Accepted, Decision::Rejected}) {
        EXPECT_EQ(decisionNamed(name(decision)), decision);
    }
    spherewalk::test::expectError(ErrorKind::InvalidInput, "open, accepted and rejected",
                                  [] { decisionNamed("maybe"); });
}

TEST_F(MovedPhotos, ChangePlaces) {
    m_store.movePhotos({moved(m_a, 1), moved(m_b, 0)});
    EXPECT_EQ(m_store.chosenPhoto(stationAt(0))->id, m_b);
    EXPECT_EQ(m_store.chosenPhoto(stationAt(1))->id, m_a);
    EXPECT_EQ(m_store.photo(m_a).positionM, Eigen::Vector3d(7, 8, 9));
}

TEST_F(MovedPhotos, LeaveTheOthersOfTheirStationAChosenOne) {
    const std::int64_t older = m_store.addPhoto([&] {
        NewPhoto photo = photoOf(stationAt(0), "c");
        photo.choose = false;
        return photo;
    }());
    m_store.movePhotos({moved(m_a, 2)});
    EXPECT_EQ(m_store.chosenPhoto(stationAt(0))->id, older);
    EXPECT_EQ(m_store.chosenPhoto(stationAt(2))->id, m_a);
    EXPECT_TRUE(m_store.check(noProgress(), {}).database.empty());
}

TEST_F(MovedPhotos, TakeThePlaceOfThePhotoThatWasChosenThere) {
    m_store.movePhotos({moved(m_a, 1)});
    EXPECT_EQ(m_store.chosenPhoto(stationAt(1))->id, m_a);
    EXPECT_EQ(m_store.photo(m_b).station, stationAt(1));
    EXPECT_EQ(m_store.chosenPhoto(stationAt(0)), std::nullopt);
}

TEST_F(MovedPhotos, LeaveNoStationToBeTakenThatNobodyPlanned) {
    const std::int64_t unplanned = m_store.addStation({0.5, 0.25, 1.2});
    const std::int64_t photo = m_store.addPhoto(photoOf(unplanned, "c"));
    const int stations = m_store.counts().stations;
    const std::size_t missing = m_store.stationsWithoutPhoto().size();
    m_store.movePhotos({moved(photo, 0)});
    EXPECT_EQ(m_store.counts().stations, stations - 1);
    EXPECT_EQ(m_store.stationsWithoutPhoto().size(), missing);
    m_store.setReview({m_b, Decision::Rejected, ""});
    EXPECT_EQ(m_store.stationsWithoutPhoto().size(), missing + 1);
}

TEST_F(MovedPhotos, MoveAllOrNone) {
    MovedPhoto nowhere = moved(m_b, 0);
    nowhere.station = 9999;
    expectRefused(ErrorKind::NotFound, "no station 9999", [&] {
        m_store.movePhotos({moved(m_a, 1), nowhere});
    });
    EXPECT_EQ(m_store.photo(m_a).station, stationAt(0));
    EXPECT_EQ(m_store.chosenPhoto(stationAt(0))->id, m_a);
}

TEST_F(VerdictRecords, KeepTheLatestVerdict) {
    EXPECT_EQ(m_store.verdict(m_photo), std::nullopt);
    m_store.setVerdict({m_photo, survey::Quality::Failed, R"([{"flaw":"blur"}])"});
    const PhotoVerdict latest{m_photo, survey::Quality::Doubtful, R"([{"flaw":"foreign"}])"};
    m_store.setVerdict(latest);
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    EXPECT_EQ(reader.verdict(m_photo), latest);
    EXPECT_EQ(reader.verdicts(), std::vector{latest});
}

TEST_F(VerdictRecords, LeaveWhatAPersonDecidedAlone) {
    m_store.setReview({m_photo, Decision::Accepted, "It is fine"});
    m_store.setVerdict({m_photo, survey::Quality::Failed, "[]"});
    EXPECT_EQ(m_store.review(m_photo).decision, Decision::Accepted);
}

TEST_F(VerdictRecords, RefuseUnknownPhotosAndFindingsThatAreNone) {
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] {
        m_store.setVerdict({99, survey::Quality::Good, "[]"});
    });
    expectRefused(ErrorKind::NotFound, "no photo 99", [&] { m_store.verdict(99); });
    for (const char* findings : {"", "{}", "[", "\"blur\""}) {
        expectRefused(ErrorKind::InvalidInput, "findings", [&] {
            m_store.setVerdict({m_photo, survey::Quality::Good, findings});
        });
    }
}

TEST_F(VerdictRecords, OlderSurveysGetTheTable) {
    const auto file = m_folder / "old.sqlite";
    Database database(file, Database::Mode::Create, std::chrono::seconds(1));
    makeSchema(database, migrations().first(3));
    migrate(database, migrations());
    EXPECT_EQ(database.integer("SELECT count(*) FROM verdict"), 0);
}

} // namespace spherewalk::store
