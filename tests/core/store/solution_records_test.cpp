// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "survey_fixture.h"

#include <cmath>

namespace spherewalk::store {

namespace {

class SolutionRecords : public test::SurveyTest {
  protected:
    std::int64_t m_photo = m_store.addPhoto(photoOf(stationAt(0), "a"));

    NewSolution solution() const {
        NewSolution result{
            .source = "align", .model = "yaw and tilt", .report = R"({"pairs":3})", .photos = {}};
        SolvedPhoto solved;
        solved.photo = m_photo;
        result.photos.push_back(solved);
        return result;
    }
};

} // namespace

TEST_F(SolutionRecords, KeepEveryField) {
    spherewalk::test::Random random(3);
    NewSolution made = solution();
    SolvedPhoto& solved = made.photos[0];
    solved.roomFromPhoto = random.rotation();
    solved.positionM = {1e6 + 0.123456, -2, 1.2};
    solved.sigmaYawRad = 0.001;
    solved.sigmaPositionM = 0.0;
    solved.quality = survey::Quality::Doubtful;
    solved.flags = R"(["few matches"])";
    const std::int64_t id = m_store.addSolution(made, true);
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    const SolvedPhoto read = reader.solvedPhotos(id).at(0);
    EXPECT_EQ(read.photo, m_photo);
    EXPECT_EQ(read.positionM, solved.positionM);
    EXPECT_EQ(read.sigmaYawRad, 0.001);
    EXPECT_EQ(read.sigmaPositionM, 0.0);
    EXPECT_FALSE(read.sigmaPitchRad.has_value());
    EXPECT_FALSE(read.sigmaRollRad.has_value());
    EXPECT_EQ(read.quality, survey::Quality::Doubtful);
    EXPECT_EQ(read.flags, solved.flags);
    EXPECT_LT(read.roomFromPhoto.angularDistance(solved.roomFromPhoto), 1e-12);
    EXPECT_EQ(reader.solutions().at(0).source, "align");
    EXPECT_EQ(reader.solutions().at(0).model, "yaw and tilt");
    EXPECT_EQ(reader.solutions().at(0).report, R"({"pairs":3})");
}

TEST_F(SolutionRecords, HaveExactlyOneActive) {
    EXPECT_FALSE(m_store.activeSolution().has_value());
    const std::int64_t a = m_store.addSolution(solution(), false);
    EXPECT_EQ(m_store.activeSolution()->id, a);
    m_store.addSolution(solution(), false);
    EXPECT_EQ(m_store.activeSolution()->id, a);
    const std::int64_t c = m_store.addSolution(solution(), true);
    EXPECT_EQ(m_store.activeSolution()->id, c);
    EXPECT_EQ(m_store.solutions().size(), 3U);
    EXPECT_EQ(m_store.solutions().front().id, c) << "newest first";
    EXPECT_EQ(m_store.counts().solutions, 3);
    expectRefused(ErrorKind::NotFound, "There is no solution 9", [&] { m_store.solvedPhotos(9); });
}

TEST_F(SolutionRecords, RefuseWhatNoSolutionCanHold) {
    const auto expect = [&](ErrorKind kind, const std::string& part,
                            const std::function<void(NewSolution&)>& spoil) {
        NewSolution made = solution();
        spoil(made);
        expectRefused(kind, part, [&] { m_store.addSolution(made, true); });
    };
    expect(ErrorKind::NotFound, "There is no photo 8", [](NewSolution& s) { s.photos[0].photo = 8; });
    expect(ErrorKind::InvalidInput, "twice", [](NewSolution& s) { s.photos.push_back(s.photos[0]); });
    expect(ErrorKind::InvalidInput, "photo 1", [](NewSolution& s) { s.photos[0].roomFromPhoto.w() = NAN; });
    expect(ErrorKind::InvalidInput, "is not a number",
           [](NewSolution& s) { s.photos[0].positionM.x() = NAN; });
    expect(ErrorKind::InvalidInput, "standard deviation",
           [](NewSolution& s) { s.photos[0].sigmaRollRad = -1; });
    expect(ErrorKind::InvalidInput, "not valid JSON", [](NewSolution& s) { s.photos[0].flags = "{"; });
    expect(ErrorKind::InvalidInput, "not valid JSON", [](NewSolution& s) { s.report = ""; });
    EXPECT_EQ(m_store.counts().solutions, 0);
}

} // namespace spherewalk::store
