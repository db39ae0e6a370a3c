// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_held_photos.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace spherewalk::jobs {

using testing::HasSubstr;
using testing::Not;

namespace {

constexpr double kOffM = 0.1;

/// Ten photos in two rows, whose places the pictures told in a frame and with a scale of their own.
class PlacesByTags : public testing::Test {
  protected:
    void SetUp() override {
        m_places.photos.clear();
        m_priors.clear();
        const Eigen::Isometry2d frame = Eigen::Translation2d(-4, 2) * Eigen::Rotation2Dd(1.9);
        for (int i = 0; i < 10; ++i) {
            const Eigen::Vector3d trueM(0.6 * (i % 5), 0.7 * (i / 5), 1.2 + 0.02 * i);
            Eigen::Vector3d solvedM = trueM / m_scale;
            solvedM.head<2>() = frame * solvedM.head<2>();
            align::FreePlace& place = m_places.photos.emplace_back();
            place.roomFromPhoto = Rigid3{Eigen::Quaterniond::Identity(), solvedM};
            place.sigmaM = 0.003;
            align::PhotoPrior& prior = m_priors.emplace_back();
            prior.positionSigmaM = kOffM;
            prior.positionM = trueM + kOffM * Eigen::Vector3d(std::cos(5 * i), std::sin(7 * i), 0);
        }
    }

    double solvedApartM(std::size_t a, std::size_t b) const {
        return (m_places.photos[a].roomFromPhoto->translation - m_places.photos[b].roomFromPhoto->translation)
            .norm();
    }

    double priorsApartM(std::size_t a, std::size_t b) const {
        return (m_priors[a].positionM - m_priors[b].positionM).norm();
    }

    double m_scale = 1.1;
    align::FreePlaces m_places;
    std::vector<align::PhotoPrior> m_priors;
};

} // namespace

TEST_F(PlacesByTags, TakeTheirFrameAndScaleFromTheTagsAndStandAsThePicturesSay) {
    const std::vector<align::PhotoPrior> tagged = m_priors;
    const std::optional<FrameSigma> frame = usePlacesByTags(m_places, m_priors);
    ASSERT_TRUE(frame);
    const double scale = priorsApartM(0, 9) / solvedApartM(0, 9);
    EXPECT_NEAR(scale, m_scale, 0.08);
    for (std::size_t i = 0; i < m_priors.size(); ++i) {
        EXPECT_NEAR(priorsApartM(0, i), scale * solvedApartM(0, i), 1e-9);
        EXPECT_LT((m_priors[i].positionM - tagged[i].positionM).norm(), 3 * kOffM);
        EXPECT_NEAR(m_priors[i].positionSigmaM, scale * 0.003, 1e-9);
        EXPECT_EQ(m_priors[i].placement, 0);
    }
    EXPECT_NEAR(frame->placeM, kOffM / std::sqrt(10), 1e-3);
    EXPECT_NEAR(frame->heading.value(), kOffM / std::sqrt(10 * (0.72 + 0.1225)), 1e-2);
    EXPECT_NEAR(frame->scale, frame->heading.value(), 1e-12);
    align::Alignment solved;
    solved.photos.resize(tagged.size());
    EXPECT_NEAR(scaleSigmaOf(tagged, solved), kOffM / std::sqrt(10 * (0.72 + 0.1225)), 1e-2);
    for (align::SolvedPose& pose : solved.photos) {
        pose.sigmaOwnPositionM = 2 * kOffM; // Nobody believes these tags.
    }
    EXPECT_NEAR(scaleSigmaOf(tagged, solved), 2 * kOffM / std::sqrt(10 * (0.72 + 0.1225)), 2e-2);
}

TEST_F(PlacesByTags, KeepTheScaleOfTheFloorWhereTheTagsKnowItWorse) {
    m_places.scaleBy = align::ScaleBy::Floor;
    m_places.scaleSigma = 0.008;
    const std::vector<align::PhotoPrior> tagged = m_priors;
    const std::optional<FrameSigma> frame = usePlacesByTags(m_places, m_priors);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scale, 0.008);
    EXPECT_THAT(frame->text(), testing::HasSubstr("The scale is known to 0.8 %"));
    EXPECT_NEAR(priorsApartM(0, 9), solvedApartM(0, 9), 1e-9);
    m_priors = tagged;
    m_places.scaleSigma = 0.2;
    ASSERT_TRUE(usePlacesByTags(m_places, m_priors));
    EXPECT_GT(priorsApartM(0, 9), 1.02 * solvedApartM(0, 9));
}

TEST_F(PlacesByTags, LeaveAPhotoWhoseTagIsWrongItsTag) {
    m_priors[3].positionM.x() += 2;
    m_places.photos[6].doubt = "One other photo alone confirms it.";
    const std::vector<align::PhotoPrior> tagged = m_priors;
    ASSERT_TRUE(usePlacesByTags(m_places, m_priors));
    for (const std::size_t kept : {3U, 6U}) {
        EXPECT_EQ(m_priors[kept].positionM, tagged[kept].positionM);
        EXPECT_EQ(m_priors[kept].positionSigmaM, kOffM);
        EXPECT_EQ(m_priors[kept].placement, -1);
    }
    EXPECT_NEAR(priorsApartM(0, 9) / solvedApartM(0, 9), m_scale, 0.08);
}

TEST_F(PlacesByTags, LetPhotosThatHangTogetherInDoubtMoveAsOne) {
    const std::optional<FrameSigma> sure = usePlacesByTags(m_places, m_priors);
    SetUp();
    for (const std::size_t loose : {5U, 6U, 7U, 8U, 9U}) {
        m_places.photos[loose].doubt = "How far it is from the largest part is not known.";
    }
    const std::optional<FrameSigma> frame = usePlacesByTags(m_places, m_priors);
    ASSERT_TRUE(sure && frame);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(m_priors[i].placement, i < 5 ? 0 : 1);
    }
    EXPECT_NEAR(frame->placeM, std::sqrt(2) * sure->placeM, 1e-9);
    EXPECT_GT(frame->heading, sure->heading);
}

TEST_F(PlacesByTags, SayNothingWhereMoreThanAThirdHasNone) {
    for (const std::size_t wrong : {2U, 5U, 7U, 8U}) {
        m_places.photos[wrong].roomFromPhoto.reset();
    }
    const std::vector<align::PhotoPrior> tagged = m_priors;
    EXPECT_FALSE(usePlacesByTags(m_places, m_priors));
    EXPECT_EQ(m_priors[0].positionM, tagged[0].positionM);
}

TEST_F(PlacesByTags, SayNothingOfTagsThatAreMirroredOrLieTogether) {
    std::vector<align::PhotoPrior> mirrored = m_priors;
    std::vector<align::PhotoPrior> together = m_priors;
    for (std::size_t i = 0; i < m_priors.size(); ++i) {
        mirrored[i].positionM.x() = -4 * mirrored[i].positionM.x();
        mirrored[i].positionM.y() = 4 * mirrored[i].positionM.y();
        together[i].positionM.setZero();
    }
    EXPECT_FALSE(usePlacesByTags(m_places, mirrored));
    EXPECT_FALSE(usePlacesByTags(m_places, together));
    align::Alignment solved;
    solved.photos.resize(together.size());
    EXPECT_EQ(scaleSigmaOf(together, solved), 0);
    m_places.photos.resize(5);
    m_priors.resize(5);
    EXPECT_FALSE(usePlacesByTags(m_places, m_priors));
}

TEST_F(PlacesByTags, LeaveTheFrameAsOpenAsASolverTakesIt) {
    for (align::PhotoPrior& prior : m_priors) {
        prior.positionSigmaM = 1000;
    }
    const std::optional<FrameSigma> frame = usePlacesByTags(m_places, m_priors);
    ASSERT_TRUE(frame);
    align::SolveOptions options;
    options.placementSigmaM = frame->placeM;
    options.placementSigma = frame->heading;
    options.validate();
    EXPECT_EQ(frame->placeM, 10);
}

TEST_F(PlacesByTags, StateNoTurnBetterThanThePicturesKnowIt) {
    AlignReport report;
    report.alignment.photos.resize(m_places.photos.size());
    for (align::SolvedPose& pose : report.alignment.photos) {
        pose.isSolved = true;
        pose.sigmaYaw = pose.sigmaOwn = Degrees(0.01);
    }
    report.alignment.photos[1].doubt = "It may be turned otherwise.";
    for (align::FreePlace& place : m_places.photos) {
        place.sigmaRad = Radians(Degrees(0.03)).value();
    }
    m_places.photos[2].roomFromPhoto.reset();
    widenTurns(m_places, report);
    EXPECT_EQ(report.alignment.photos[0].sigmaYaw, Radians(Degrees(0.03)));
    EXPECT_EQ(report.alignment.photos[0].sigmaOwn, Radians(Degrees(0.03)));
    EXPECT_EQ(report.alignment.photos[1].sigmaYaw, Radians(Degrees(0.01)));
    EXPECT_EQ(report.alignment.photos[2].sigmaYaw, Radians(Degrees(0.01)));
    widenTurns(m_places, report);
    EXPECT_EQ(report.alignment.photos[0].sigmaYaw, Radians(Degrees(0.03)));
}

namespace {

/// Six photos of the practice room that were taken by hand, with tags that are off by a multiple of 10 cm.
class RoughTags : public testing::Test {
  protected:
    AlignReport aligned(const std::array<Eigen::Vector2d, 6>& tagsOff) {
        std::string positions = "file,x_m,y_m,z_m\n";
        for (std::size_t i = 0; i < m_truth.size(); ++i) {
            const Eigen::Vector2d tagM = m_truth[i].translation.head<2>() + kOffM * tagsOff[i];
            positions += text("H", i, ".jpg,", tagM.x(), ",", tagM.y(), ",1.2\n");
        }
        writeFile(m_folder / "tags.csv", bytesOf(positions));
        survey::Room room;
        room.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
        room.ceilingM = 2.6;
        auto store = store::SurveyStore::create(m_folder / "s.spherewalk", "s", room, {}, {});
        const ImportOptions import{m_folder / "in", m_folder / "tags.csv"};
        importPhotos(store, import, noProgress(), {});
        AlignOptions options;
        options.positionSigmaM = kOffM;
        return alignSurvey(store, options, noProgress(), {});
    }

    /// The worst turn against the first photo.
    Radians worstTurn(const AlignReport& report) const {
        Radians worst;
        for (std::size_t i = 0; i < m_truth.size(); ++i) {
            const auto turned = report.photos[0].pose.roomFromPhoto.rotation.conjugate() *
                                report.photos[i].pose.roomFromPhoto.rotation;
            worst =
                std::max(worst, angleBetween(turned, m_truth[0].rotation.conjugate() * m_truth[i].rotation));
        }
        return worst;
    }

    test::TemporaryFolder m_folder;
    std::vector<Rigid3> m_truth = test::writeHandHeldPhotos(m_folder / "in");
};

constexpr const char* kByPictures = "the places were solved from the pictures";

} // namespace

TEST_F(RoughTags, GiveTheFrameAndThePicturesThePlaces) {
    const AlignReport report =
        aligned({{{1, 0.5}, {-0.8, 1}, {0.3, -1.2}, {-1, -0.4}, {0.6, 0.9}, {0.2, -0.7}}});
    EXPECT_THAT(report.alignment.reason, HasSubstr(kByPictures));
    EXPECT_EQ(report.effort, align::Effort::Fine);
    EXPECT_FALSE(report.places); // The stations stay where they are planned.
    EXPECT_LT(worstTurn(report), Radians(Degrees(0.1)));
    for (std::size_t i = 0; i < m_truth.size(); ++i) {
        EXPECT_EQ(report.photos[i].quality, survey::Quality::Good) << report.photos[i].file;
        const Eigen::Vector3d offM = report.photos[i].pose.roomFromPhoto.translation - m_truth[i].translation;
        EXPECT_LT(offM.head<2>().norm(), 1.5 * kOffM);
        EXPECT_LT(offM.head<2>().norm(), 5 * report.photos[i].pose.sigmaPositionM);
    }
}

TEST_F(RoughTags, GiveThePlacesWhereThePicturesContradictThem) {
    const AlignReport report = aligned({{{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {15, 12}}});
    EXPECT_THAT(report.alignment.reason, Not(HasSubstr(kByPictures)));
    EXPECT_EQ(report.effort, align::Effort::Normal);
    EXPECT_NE(report.photos[5].quality, survey::Quality::Good);
}

} // namespace spherewalk::jobs
