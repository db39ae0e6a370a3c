// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "survey/room_photos.h"
#include "warnings.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/dataset.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

// Surveys in which a person or a robot has made a mistake that no single photo shows.
namespace spherewalk::jobs {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

class AlignFaults : public RoomPhotos {
  protected:
    /// As a second exposure of one scene differs from the first.
    static RgbImage withNoise(const RgbImage& picture, unsigned seed) {
        test::Random random(seed);
        RgbImage noisy = picture;
        for (std::uint8_t& value : noisy.values()) {
            value = static_cast<std::uint8_t>(std::clamp(value + random.normal(2), 0.0, 255.0));
        }
        return noisy;
    }

    /// Aligns nine photos whose places are those of rails with steps that are wrong by these factors.
    AlignReport alignStretched(double x, double y) {
        photograph(3, 3);
        right = places;
        for (Eigen::Vector3d& place : places) {
            place = right[4] + (place - right[4]).cwiseProduct(Eigen::Vector3d(x, y, 1));
        }
        stretched.emplace(newSurvey());
        return alignSurvey(*stretched, {}, noProgress(), {});
    }

    /// Expects a sentence of the report and of the export, and that places are as uncertain as they are
    /// wrong.
    template <class Sentence>
    void expectWarning(const Sentence& sentence, const AlignReport& report) {
        EXPECT_THAT(report.tagWarnings, Contains(sentence));
        EXPECT_THAT(alignText(report), sentence);
        test::Warnings said;
        exportDataset(*stretched, folder / "d", {}, said, {});
        EXPECT_THAT(said.sentences, Contains(sentence));
        const auto exported = photosOf(render::Dataset::open(folder / "d"));
        for (const AlignedPhoto& photo : report.photos) {
            const std::size_t i = numberOf(photo.file);
            const double wrongByM = (places[i] - right[i]).norm(); // the middle is where it should be
            constexpr double kLeast = 1 - kScaleError / 0.2;       // of 20 % or more that the scale is off
            EXPECT_GE(photo.pose.sigmaPositionM, kLeast * wrongByM) << photo.file;
            ASSERT_TRUE(exported.at(i).positionSigmaM) << photo.file;
            EXPECT_GE(exported.at(i).positionSigmaM->x(), kLeast * wrongByM) << photo.file;
        }
    }

    /// How far a photo's solved place is off along the floor.
    double offM(const AlignedPhoto& photo) const {
        return (photo.pose.roomFromPhoto.translation - truth.at(numberOf(photo.file)).translation)
            .head<2>()
            .norm();
    }

    /// The photos of a dataset by their numbers.
    static std::map<std::size_t, render::DatasetPhoto> photosOf(const render::Dataset& dataset) {
        std::map<std::size_t, render::DatasetPhoto> photos;
        for (const render::DatasetPhoto& photo : dataset.info().photos) {
            photos.emplace(numberOf(std::filesystem::path(photo.file).filename().string()), photo);
        }
        return photos;
    }

    /// A floor that is not quite flat, and a fit of directions, tell a scale no better.
    static constexpr double kScaleError = 0.03;

    std::optional<store::SurveyStore> stretched;
    std::vector<Eigen::Vector3d> right; ///< the places before they were made wrong
};

} // namespace

TEST_F(AlignFaults, NamesTwoPhotosOfACameraThatWasNotMoved) {
    photograph();
    pictures[1] = withNoise(pictures[0], 2);
    truth[1] = truth[0];
    folder.leaveUnchecked(); // one station has the picture of another
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    const auto names = [&](const char* file, const char* other) {
        const AlignedPhoto& photo = photoOf(report, file);
        EXPECT_NE(photo.quality, survey::Quality::Good) << file;
        EXPECT_THAT(photo.flags, Contains(AllOf(HasSubstr("the camera was not moved between them"),
                                                HasSubstr(other), HasSubstr("0.20 m apart"))))
            << file;
    };
    names("R0.JPG", "R1.JPG");
    names("R1.JPG", "R0.JPG");
    for (const char* file : {"R2.JPG", "R3.JPG", "R4.JPG", "R5.JPG"}) {
        EXPECT_THAT(photoOf(report, file).flags, testing::IsEmpty()) << file;
    }
}

TEST_F(AlignFaults, SaysThatTheScaleOfTheTagsIsWrong) {
    const AlignReport report = alignStretched(1.25, 1.25);
    ASSERT_TRUE(report.scale);
    EXPECT_NEAR(report.scale->value, 1.25, kScaleError);
    EXPECT_EQ(toJson(report)["tags_scale"]["value"].get<double>(), report.scale->value);
    expectWarning(
        AllOf(HasSubstr("The scale of the tags is wrong"), HasSubstr(fixed(report.scale->value, 3))), report);
}

TEST_F(AlignFaults, SaysThatTheScaleOfTheTagsDiffersAlongTheAxes) {
    const AlignReport report = alignStretched(1.25, 1);
    ASSERT_TRUE(report.tagFrame.yOverX);
    const double yOverX = report.tagFrame.yOverX->value;
    EXPECT_NEAR(yOverX, 0.8, kScaleError);
    EXPECT_EQ(toJson(report)["tags_y_over_x"]["value"].get<double>(), yOverX);
    expectWarning(
        AllOf(HasSubstr("The scale of the tags differs along the axes"), HasSubstr(fixed(yOverX, 3))),
        report);
}

// What resources/docs/testing.md counts as solved and as wrong, in metres.
constexpr double kSolvedM = 0.015;
constexpr double kWrongM = 0.030;

TEST_F(AlignFaults, SolvesOrLeavesOutFourWrongTagsOfTwentyFive) {
    photograph(5, 5);
    test::Random random(11);
    const std::vector<std::size_t> wrong{3, 7, 16, 21};
    for (const std::size_t i : wrong) {
        const double towards = random.uniform(-std::numbers::pi, std::numbers::pi);
        places[i] += 0.15 * Eigen::Vector3d(std::cos(towards), std::sin(towards), 0);
    }
    folder.leaveUnchecked(); // its photos keep their wrong tags
    auto store = newSurvey();
    AlignOptions draft; // which is enough, and takes less time
    draft.effort = align::Effort::Draft;
    const AlignReport report = alignSurvey(store, draft, noProgress(), {});
    test::Warnings said;
    exportDataset(store, folder / "d", {}, said, {});
    const auto exported = photosOf(render::Dataset::open(folder / "d"));
    for (const auto& [i, photo] : exported) {
        EXPECT_LT((photo.roomFromPhoto.translation - truth[i].translation).head<2>().norm(), kWrongM) << i;
    }
    for (const std::size_t i : wrong) {
        const AlignedPhoto& photo = photoOf(report, fileOf(i));
        EXPECT_THAT(photo.flags, Not(testing::IsEmpty())) << photo.file;
        if (photo.quality == survey::Quality::Failed) {
            EXPECT_FALSE(exported.contains(i));
            EXPECT_THAT(said.sentences, Contains(AllOf(HasSubstr(photo.file), HasSubstr("left out"))));
        } else {
            EXPECT_LT(offM(photo), kSolvedM) << photo.file;
        }
    }
    EXPECT_GE(exported.size(), 21U); // whose tags are right
}

TEST_F(AlignFaults, LeavesOutAPhotoOfAnotherRoom) {
    photograph();
    pictures[4] = practice::PracticeRoom(flatOptions())
                      .spherical({truth[4].rotation, {3.2, 4.2, 1.2}}, {kWidth, kWidth / 2});
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    for (const AlignedPhoto& photo : report.photos) {
        const bool isElsewhere = photo.file == "R4.JPG";
        EXPECT_EQ(photo.quality == survey::Quality::Failed, isElsewhere) << photo.file;
        EXPECT_EQ(photo.flags.empty(), !isElsewhere) << photo.file;
    }
    test::Warnings said;
    const ExportReport exported = exportDataset(store, folder / "d", {}, said, {});
    EXPECT_EQ(exported.written.photos, 5U);
    EXPECT_THAT(said.sentences, Contains(AllOf(HasSubstr("R4.JPG"), HasSubstr("left out"))));
}

/// Photos on one line do not show how it is turned about itself, but the room's upright edges do.
TEST_F(AlignFaults, KnowsHowALineLeansAndBlamesNoPhotoOnIt) {
    photograph(5, 1);
    AlignOptions options;
    options.cacheFolder = folder / "features"; // They are the same photos each time.
    for (const std::size_t photos : {5U, 3U, 2U}) {
        SCOPED_TRACE(photos);
        pictures.resize(photos);
        auto store = newSurvey(text("row-", photos));
        const AlignReport report = alignSurvey(store, options, noProgress(), {});
        EXPECT_LT(report.alignment.sigmaCommonLean, Radians(Degrees(0.15)));
        EXPECT_THAT(alignText(report), Not(HasSubstr("lie on one line")));
        for (const AlignedPhoto& photo : report.photos) {
            EXPECT_NE(photo.quality, survey::Quality::Failed) << photo.file;
            EXPECT_THAT(photo.flags, Not(Contains(HasSubstr("shares too little")))) << photo.file;
        }
    }
}

} // namespace spherewalk::jobs
