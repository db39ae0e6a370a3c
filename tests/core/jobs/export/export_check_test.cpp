// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::jobs {

using test::expectError;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// Small depths, which are soon there.
ExportOptions coarse(render::SceneKind scene) {
    ExportOptions options;
    options.scene = scene;
    options.depth.sweep.width = 128;
    options.depth.sweep.coarseWidth = 64;
    return options;
}

class ExportCheckTest : public testing::Test {
  protected:
    ExportCheck check(const std::filesystem::path& folder) const {
        return checkExport(survey.open(), folder, {}, noProgress(), {});
    }

    test::PhotographedSurvey survey{3};
};

} // namespace

TEST_F(ExportCheckTest, TellsTheSizeThatTheDatasetThenHas) {
    const ExportCheck found = check(survey / "d");
    const ExportReport made = exportDataset(survey.open(), survey / "d", {}, noProgress(), {});
    EXPECT_EQ(found.photos, 3U);
    EXPECT_NEAR(static_cast<double>(found.totalBytes) / static_cast<double>(made.written.totalBytes), 1, 0.1);
    EXPECT_GT(found.seconds, 0);
    EXPECT_GT(found.freeBytes, 0U);
    EXPECT_TRUE(found.isPossible());
}

TEST_F(ExportCheckTest, SaysWhatTheDatasetWouldLack) {
    auto store = survey.open(store::Access::Write);
    store.setReview({store.photos().at(0).id, store::Decision::Rejected, ""});
    const ExportCheck found = check(survey / "d");
    EXPECT_EQ(found.photos, 2U);
    EXPECT_THAT(found.doubts, Contains(HasSubstr("have no photo")));
    EXPECT_THAT(found.doubts, Contains(HasSubstr("1 photo was rejected")));
}

TEST_F(ExportCheckTest, SaysThatNobodyKnowsWherePhotosWereTaken) {
    constexpr int kUnknown = 22;
    std::filesystem::create_directories(survey / "more");
    for (int i = 0; i < kUnknown; ++i) {
        RgbImage picture(512, 256);
        std::ranges::fill(picture.values(), static_cast<std::uint8_t>(60 + 8 * i));
        writeFile(survey / "more" / text("M", i, ".JPG"), jpeg::encode(picture, 90));
    }
    auto store = survey.open(store::Access::Write);
    importPhotos(store, {survey / "more", {}}, noProgress(), {});
    const ExportCheck some = check(survey / "d");
    EXPECT_EQ(some.photos, 3U);
    EXPECT_TRUE(some.isPossible());
    EXPECT_THAT(some.doubts, Contains(AllOf(HasSubstr("22 photos are left out, since nobody knows where"),
                                            HasSubstr("M0.JPG"), HasSubstr(", ....")))); // not all by name
    for (const store::PhotoRecord& photo : store.photos()) {
        if (store.station(photo.station).isPlaceKnown) {
            store.setReview({photo.id, store::Decision::Rejected, ""});
        }
    }
    const ExportCheck none = check(survey / "d");
    EXPECT_THAT(none.obstacles, ElementsAre(HasSubstr("nobody knows where they were taken")));
    expectError(ErrorKind::InvalidInput, "Nothing can be exported. 22 photos are left out, since nobody",
                [&] { exportDataset(store, survey / "d", {}, noProgress(), {}); });
}

TEST_F(ExportCheckTest, CountsWhatIsBlurredInThePhotosThatAreExported) {
    auto store = survey.open(store::Access::Write);
    const std::vector<store::PhotoRecord> photos = store.photos();
    const survey::PrivateRegion region{Degrees(0), Degrees(0), Degrees(10), Degrees(10)};
    store.markRegion(photos.at(0).id, region);
    store.markRegion(photos.at(1).id, region);
    store.setFoundRegions(photos.at(1).id, {{Degrees(90), Degrees(0), Degrees(10), Degrees(10)}}, 1);
    store.setFoundRegions(photos.at(2).id, {region}, 1);
    store.removeRegion(store.regions(photos.at(2).id).front().id);
    store.setReview({photos.at(0).id, store::Decision::Rejected, ""});
    const ExportCheck found = check(survey / "d");
    EXPECT_EQ(found.privateRegions, 2U);
    EXPECT_EQ(found.blurredPhotos, 1U);
}

TEST_F(ExportCheckTest, CountsTheDepthsThatAreNotKnownYet) {
    const ExportOptions options = coarse(render::SceneKind::Depth);
    const auto store = survey.open();
    const ExportCheck before = checkExport(store, survey / "d", options, noProgress(), {});
    EXPECT_EQ(knownScene(store, options.depth), render::SceneKind::Sphere); // one of three was tried
    const ExportReport made = exportDataset(store, survey / "d", options, noProgress(), {});
    EXPECT_EQ(made.depth.photos, 3U);
    EXPECT_NEAR(static_cast<double>(before.totalBytes) / static_cast<double>(made.written.totalBytes), 1,
                0.1);
    EXPECT_EQ(knownScene(store, options.depth), render::SceneKind::Depth);
    EXPECT_EQ(knownScene(store, {}), render::SceneKind::Sphere) << "depths of another size are none of these";
}

TEST(ExportScene, FindsTheSameRoomFromADozenPhotosWhetherDepthsAreExportedOrNot) {
    const test::PhotographedSurvey survey{14};
    const auto exported = [&](render::SceneKind scene) {
        return exportDataset(survey.open(), survey / std::string(name(scene)), coarse(scene), noProgress(),
                             {});
    };
    const ExportReport room = exported(render::SceneKind::Room);
    const ExportReport depth = exported(render::SceneKind::Depth);
    EXPECT_EQ(room.depth.photos, 12U);
    EXPECT_EQ(depth.depth.photos, 14U);
    EXPECT_EQ(room.sphereRadiusM, depth.sphereRadiusM);
    EXPECT_EQ(room.roomShape, depth.roomShape);
}

TEST(ExportScene, OfBlendHasTheFilesOfDepth) {
    const test::PhotographedSurvey survey{3};
    const ExportOptions options = coarse(render::SceneKind::Blend);
    const ExportCheck before = checkExport(survey.open(), survey / "d", options, noProgress(), {});
    const ExportReport made = exportDataset(survey.open(), survey / "d", options, noProgress(), {});
    EXPECT_EQ(made.depth.photos, 3U);
    EXPECT_NEAR(static_cast<double>(before.totalBytes) / static_cast<double>(made.written.totalBytes), 1,
                0.1);
    const render::Dataset dataset = render::Dataset::open(survey / "d");
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        EXPECT_FALSE(photo.depth.empty()) << photo.file;
    }
    EXPECT_EQ(render::scenesOf(dataset.info()).back(), render::SceneKind::Blend);
}

TEST_F(ExportCheckTest, SaysWhyItCannotBeDone) {
    EXPECT_THAT(check(survey.path()).obstacles, Contains(HasSubstr("already")));
    auto store = survey.open(store::Access::Write);
    for (const store::PhotoRecord& photo : store.photos()) {
        store.setReview({photo.id, store::Decision::Rejected, ""});
    }
    EXPECT_THAT(check(survey / "d").obstacles, Contains(HasSubstr("No photo is left")));
}

TEST_F(ExportCheckTest, LeavesRejectedPhotosOutOfTheDataset) {
    auto store = survey.open(store::Access::Write);
    store.setReview({store.photos().at(0).id, store::Decision::Rejected, ""});
    const ExportReport made = exportDataset(store, survey / "d", {}, noProgress(), {});
    EXPECT_EQ(made.written.photos, 2U);
    EXPECT_EQ(made.rejected, 1);
}

TEST(RoomDoubts, NameTheDrawnWallsThatPhotosSeeThrough) {
    survey::Room drawn;
    drawn.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    scene::FittedRoom found;
    EXPECT_TRUE(roomDoubts(found, drawn).empty());
    found.wallsSeenThrough = {1};
    EXPECT_THAT(roomDoubts(found, drawn), ElementsAre(HasSubstr("the drawn wall B-C in most")));
    found.wallsSeenThrough = {1, 3};
    EXPECT_THAT(roomDoubts(found, drawn), ElementsAre(HasSubstr("the drawn walls B-C, D-A in most")));
    found.contradictsOutline = true;
    EXPECT_THAT(roomDoubts(found, drawn), ElementsAre(HasSubstr("too small or of another room")));
}

} // namespace spherewalk::jobs
