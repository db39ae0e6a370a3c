// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "survey/room_photos.h"
#include "warnings.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/dataset.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

// Surveys in which a person or a robot has made a mistake that no single photo shows.
namespace spherewalk::jobs {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

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
        AllOf(HasSubstr("The scale of the tags is wrong"), HasSubstr(fixed(report.scale->value, 2))), report);
}

TEST_F(AlignFaults, SaysThatTheScaleOfTheTagsDiffersAlongTheAxes) {
    const AlignReport report = alignStretched(1.25, 1);
    ASSERT_TRUE(report.tagFrame.yOverX);
    const double yOverX = report.tagFrame.yOverX->value;
    EXPECT_NEAR(yOverX, 0.8, kScaleError);
    EXPECT_EQ(toJson(report)["tags_y_over_x"]["value"].get<double>(), yOverX);
    expectWarning(
        AllOf(HasSubstr("The scale of the tags differs along the axes"), HasSubstr(fixed(yOverX, 2))),
        report);
}

} // namespace spherewalk::jobs
