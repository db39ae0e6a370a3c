// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/photo_judge.h"
#include "photographed_survey.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/image.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr const char* kBlurred = R"([{"flaw":"blur","quality":"failed","sentence":"It is blurred."}])";

/// A survey in which every station has a photo.
class Retakes : public testing::Test {
  protected:
    Retakes() {
        for (const store::StationRecord& station : m_store.stations()) {
            if (const auto photo = m_store.chosenPhoto(station.id)) {
                m_photos.push_back(*photo);
            }
        }
    }

    /// The photo whose neighbours stand on all sides, or the first one in a corner.
    std::int64_t photoWith(bool isInside) const {
        for (const store::PhotoRecord& photo : m_photos) {
            int near = 0;
            for (const store::PhotoRecord& other : m_photos) {
                const double distance = (other.positionM - photo.positionM).norm();
                near += other.id != photo.id && distance < 1.1 * m_store.planOptions().stepM ? 1 : 0;
            }
            if (isInside ? near == 4 : near == 2) {
                return photo.id;
            }
        }
        throw std::logic_error("the survey has no such photo");
    }

    test::PhotographedSurvey m_survey{12};
    store::SurveyStore m_store = m_survey.open(store::Access::Write);
    std::vector<store::PhotoRecord> m_photos;
};

} // namespace

TEST_F(Retakes, AreNoneAsLongAsAllIsWell) {
    EXPECT_TRUE(retakes(m_store).empty());
    m_store.setVerdict({m_photos[0].id, survey::Quality::Good, "[]"});
    EXPECT_TRUE(retakes(m_store).empty());
}

TEST_F(Retakes, TellPhotosThatLeaveAHoleFromThoseThatNeighboursStandInFor) {
    m_store.setVerdict({photoWith(true), survey::Quality::Failed, kBlurred});
    m_store.setVerdict({photoWith(false), survey::Quality::Failed, kBlurred});
    const std::vector<Retake> found = retakes(m_store);
    ASSERT_EQ(found.size(), 2U);
    for (const Retake& retake : found) {
        const bool isInside = retake.station.id == m_store.photo(photoWith(true)).station;
        EXPECT_EQ(retake.isSurrounded, isInside) << retake.station.name;
        EXPECT_TRUE(retake.isFailed);
        EXPECT_EQ(retake.sentence, "It is blurred.");
    }
    EXPECT_LT(found[0].station.id, found[1].station.id); // as one walks
}

TEST_F(Retakes, APersonsWordGoesBeforeTheChecks) {
    const std::int64_t photo = photoWith(true);
    m_store.setVerdict({photo, survey::Quality::Failed, kBlurred});
    m_store.setReview({photo, store::Decision::Accepted, ""});
    EXPECT_TRUE(retakes(m_store).empty());
    m_store.setReview({photo, store::Decision::Rejected, "A cat"});
    EXPECT_EQ(retakes(m_store).at(0).sentence, "A cat");
}

TEST_F(Retakes, AFlawedNeighbourStandsInForNothing) {
    const store::PhotoRecord middle = m_store.photo(photoWith(true));
    m_store.setVerdict({middle.id, survey::Quality::Failed, kBlurred});
    for (const store::PhotoRecord& other : m_photos) {
        if (other.id != middle.id && other.positionM.x() > middle.positionM.x() - 0.01) {
            m_store.setVerdict({other.id, survey::Quality::Doubtful, kBlurred});
        }
    }
    for (const Retake& retake : retakes(m_store)) {
        if (retake.station.id == middle.station) {
            EXPECT_FALSE(retake.isSurrounded);
        }
    }
}

TEST_F(Retakes, VerdictsAreGivenToPhotosThatCameOtherwise) {
    const JudgeReport first = judgeSurvey(m_store, false, noProgress(), {});
    EXPECT_EQ(first.judged, static_cast<int>(m_photos.size()));
    EXPECT_EQ(first.failed, 0);
    EXPECT_EQ(judgeSurvey(m_store, false, noProgress(), {}).judged, 0);
    EXPECT_EQ(judgeSurvey(m_store, true, noProgress(), {}).judged, first.judged);
}

TEST_F(Retakes, APhotoWithoutItsLightIsHeldAgainstNoOther) {
    m_survey.leaveUnchecked();
    const store::PhotoRecord& unlit = m_photos[1];
    const std::filesystem::path file = m_store.photoFolder() / unlit.fileName;
    RgbImage picture = jpeg::decode(readFile(file), unlit.fileName);
    for (std::uint8_t& value : picture.values()) {
        value /= 12;
    }
    writeFile(file, jpeg::encode(picture, 95));
    judgeSurvey(m_store, false, noProgress(), {});
    for (const store::PhotoRecord& photo : m_photos) {
        const photo::Verdict verdict = verdictOf(*m_store.verdict(photo.id));
        const auto light =
            std::ranges::count(verdict.findings, photo::Flaw::Brightness, &photo::Finding::flaw);
        EXPECT_EQ(light, photo.id == unlit.id ? 1 : 0) << verdict.sentence();
    }
}

// Of the first two photos nobody knows which is wrong, and the first one alone seems right.
TEST(EarlyVerdicts, AreGivenAgainWhenAThirdPhotoTellsWhichIsWrong) {
    test::PhotographedSurvey survey(24);
    survey.leaveUnchecked();
    store::SurveyStore store = survey.open(store::Access::Write);
    const std::vector<store::PhotoRecord> photos = store.chosenPhotos();
    const std::filesystem::path file = store.photoFolder() / photos[0].fileName;
    RgbImage picture = jpeg::decode(readFile(file), photos[0].fileName);
    for (std::uint8_t& value : picture.values()) {
        value /= 2;
    }
    writeFile(file, jpeg::encode(picture, 95));
    SharedStore shared(store);
    PhotoJudge judge(shared);
    const auto judgeNext = [&](std::size_t photo) {
        for (std::size_t i = 0; i < photos.size(); ++i) { // Rejected photos are beside no other.
            store.setReview(
                {photos[i].id, i <= photo ? store::Decision::Open : store::Decision::Rejected, ""});
        }
        judge.judge(photos[photo].id, {});
        return judge.takeAgain();
    };
    const auto flaws = [](const photo::Verdict& verdict) {
        std::vector<photo::Flaw> result;
        std::ranges::transform(verdict.findings, std::back_inserter(result), &photo::Finding::flaw);
        return result;
    };
    const auto stored = [&](std::size_t photo) { return verdictOf(*store.verdict(photos[photo].id)); };
    EXPECT_TRUE(judgeNext(0).empty());
    EXPECT_TRUE(stored(0).findings.empty());
    EXPECT_TRUE(judgeNext(1).empty());
    EXPECT_THAT(flaws(stored(1)), testing::Contains(photo::Flaw::Brightness));
    const std::vector<PhotoJudge::Again> again = judgeNext(2);
    ASSERT_EQ(again.size(), 2U);
    EXPECT_NE(again[0].before.isCompared, again[1].before.isCompared); // The first one was alone.
    EXPECT_TRUE(again[0].verdict.isCompared);
    EXPECT_THAT(flaws(stored(0)), testing::ElementsAre(photo::Flaw::Brightness));
    // The world is endlessly far, so that the camera seems to stand still.
    EXPECT_THAT(flaws(stored(1)), testing::ElementsAre(photo::Flaw::Unmoved));
    EXPECT_THAT(flaws(stored(2)), testing::ElementsAre(photo::Flaw::Unmoved));
    for (const PhotoJudge::Again& one : again) {
        EXPECT_EQ(verdictOf(*store.verdict(one.photo.id)), one.verdict);
    }
    EXPECT_TRUE(judgeNext(3).empty()); // Once is enough.
}

TEST_F(Retakes, APhotoThatIsGoneIsFailed) {
    m_survey.leaveUnchecked();
    std::filesystem::remove(m_store.photoFolder() / m_photos[0].fileName);
    judgeSurvey(m_store, false, noProgress(), {});
    EXPECT_EQ(m_store.verdict(m_photos[0].id)->quality, survey::Quality::Failed);
    EXPECT_EQ(verdictOf(*m_store.verdict(m_photos[0].id)).findings.at(0).flaw, photo::Flaw::Damaged);
}

TEST_F(Retakes, DamagedFindingsAreRefused) {
    EXPECT_THROW(verdictOf({1, survey::Quality::Failed, R"([{"flaw":"cat"}])"}), Error);
}

} // namespace spherewalk::jobs
