// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "survey/room_photos.h"
#include "warnings.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace spherewalk::jobs {

using test::expectError;
using testing::HasSubstr;

namespace {

class AlignSurvey : public RoomPhotos {}; // of six photos, unless a test takes others

/// Asks to stop when so much is done.
class StopAt : public ProgressSink {
  public:
    explicit StopAt(double fraction) : m_fraction(fraction) {}

    void progress(double fraction, std::string_view /*activity*/) override {
        if (fraction >= m_fraction) {
            source.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_source source;

  private:
    double m_fraction;
};

} // namespace

TEST_F(AlignSurvey, FindsHowEveryPhotoIsTurnedAndTellsTheDataset) {
    photograph();
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    const AlignmentError error = alignmentError(report, truePoses(store));
    EXPECT_EQ(error.photos, 6);
    EXPECT_LT(error.yawRmsDeg, 0.1);
    EXPECT_LT(error.ownTiltRmsDeg, 0.05);
    EXPECT_LT(error.commonLeanDeg, 0.5);        // six photos, 40 cm apart at most, with heights off by 3 mm
    EXPECT_LT(std::abs(error.commonYawDeg), 2); // positions are off by 3 mm
    for (const AlignedPhoto& photo : report.photos) {
        EXPECT_EQ(photo.quality, survey::Quality::Good)
            << photo.file << ": " << testing::PrintToString(photo.flags);
    }
    EXPECT_THAT(report.tagWarnings, testing::IsEmpty());
    ASSERT_TRUE(store.activeSolution());
    EXPECT_EQ(store.activeSolution()->source, "align");
    exportDataset(store, folder / "d", {}, noProgress(), {});
    const auto dataset = render::Dataset::open(folder / "d");
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        EXPECT_EQ(photo.rotationSource, "aligned");
        ASSERT_TRUE(photo.rotationSigma);
        EXPECT_GT(photo.rotationSigma->yaw.value(), 0);
        EXPECT_LT(photo.rotationSigma->yaw, Radians(Degrees(0.15)));
    }
}

TEST_F(AlignSurvey, NamesPhotosThatShowNothingOrAreMirrored) {
    photograph();
    pictures[1] = RgbImage(kWidth, kWidth / 2);
    RgbImage& mirrored = pictures[5];
    for (int y = 0; y < mirrored.height(); ++y) {
        for (int x = 0; x < kWidth / 2; ++x) {
            std::swap_ranges(mirrored.at(x, y), mirrored.at(x, y) + 3, mirrored.at(kWidth - 1 - x, y));
        }
    }
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    for (const char* file : {"R1.JPG", "R5.JPG"}) {
        const AlignedPhoto& photo = photoOf(report, file);
        EXPECT_EQ(photo.quality, survey::Quality::Failed) << file;
        EXPECT_FALSE(photo.pose.isSolved);
        ASSERT_FALSE(photo.flags.empty());
        EXPECT_THAT(photo.flags.front(), testing::EndsWith("."));
    }
    EXPECT_EQ(store.solvedPhotos(report.solution).size(), 4U);
    EXPECT_LT(alignmentError(report, truePoses(store)).yawRmsDeg, 0.2);
    test::Warnings said;
    const ExportReport exported = exportDataset(store, folder / "d", {}, said, {});
    EXPECT_EQ(exported.failed, 2);
    EXPECT_EQ(exported.written.photos, 4U);
    EXPECT_THAT(said.sentences, testing::Contains(testing::AllOf(HasSubstr("R1.JPG"), HasSubstr("R5.JPG"),
                                                                 HasSubstr("left out"))));
    EXPECT_THAT(checkExport(store, folder / "e", {}, noProgress(), {}).doubts,
                testing::Contains(HasSubstr("R5.JPG")));
}

TEST_F(AlignSurvey, SolvesThePlaceOfAPhotoThatIsTaggedElsewhere) {
    photograph();
    places[4] += Eigen::Vector3d(0.12, 0.15, 0);
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    const AlignedPhoto& photo = photoOf(report, "R4.JPG");
    EXPECT_FALSE(photo.flags.empty());
    for (const AlignedPhoto& solved : report.photos) {
        const Eigen::Vector3d& trueM =
            truth.at(static_cast<std::size_t>(solved.file.at(1) - '0')).translation;
        EXPECT_LT((solved.pose.roomFromPhoto.translation - trueM).head<2>().norm(), 0.015) << solved.file;
    }
    EXPECT_LT(photo.pose.sigmaPositionM, 0.01);
}

TEST_F(AlignSurvey, GoesOnWhereItWasStopped) {
    photograph();
    auto store = newSurvey();
    StopAt stop(0.2);
    expectError(ErrorKind::Stopped, "Stopped",
                [&] { alignSurvey(store, {}, stop, stop.source.get_token()); });
    EXPECT_FALSE(store.activeSolution());
    AlignOptions once;
    once.threads = 1;
    const AlignReport resumed = alignSurvey(store, once, noProgress(), {});
    EXPECT_GT(resumed.fromCache, 0);
    EXPECT_LT(resumed.fromCache, 6);
    const AlignReport again = alignSurvey(store, {}, noProgress(), {});
    EXPECT_EQ(again.fromCache, 6);
    // The same input gives the same result, with any number of threads; history is kept.
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(again.photos[i].pose.roomFromPhoto.rotation.coeffs(),
                  resumed.photos[i].pose.roomFromPhoto.rotation.coeffs());
    }
    EXPECT_EQ(store.solutions().size(), 2U);
    EXPECT_EQ(store.activeSolution()->id, again.solution);
}

TEST_F(AlignSurvey, WorksAThousandKilometresFromTheOrigin) {
    originM = {1e6, -1e6, 0};
    photograph();
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    EXPECT_LT(alignmentError(report, truePoses(store)).yawRmsDeg, 0.1);
}

TEST_F(AlignSurvey, SaysWhatToDoWithoutPhotosAndWithOne) {
    pictures.emplace_back(kWidth, kWidth / 2);
    places.emplace_back(2, 1.6, 1.2);
    auto store = newSurvey();
    auto empty = store::SurveyStore::create(folder / "empty.spherewalk", "empty", store.room(),
                                            store.planOptions(), store.plan());
    expectError(ErrorKind::InvalidInput, "capture or import",
                [&] { alignSurvey(empty, {}, noProgress(), {}); });
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    ASSERT_EQ(report.photos.size(), 1U);
    EXPECT_EQ(report.photos.front().quality, survey::Quality::Failed);
    EXPECT_THAT(report.photos.front().flags.front(), testing::EndsWith("."));
    EXPECT_EQ(report.solution, 0);
    EXPECT_THAT(alignText(report), HasSubstr("How the photos are turned is not known."));
    EXPECT_THAT(alignText(report), testing::Not(HasSubstr("0.000 deg")));
    EXPECT_THAT(alignText(report), testing::Not(HasSubstr("Model"))) << "none was solved";
    EXPECT_TRUE(toJson(report)["sigma_common_yaw_deg"].is_null());
    EXPECT_TRUE(toJson(report)["sigma_common_lean_deg"].is_null());
}

TEST_F(AlignSurvey, HandsOnNoPoseThatContradictsThePhotosOwnTilt) {
    photograph();
    liar = 4;
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    const AlignedPhoto& photo = photoOf(report, "R4.JPG");
    EXPECT_EQ(photo.quality, survey::Quality::Failed);
    EXPECT_THAT(photo.flags, testing::Contains(HasSubstr("what its camera states of its tilt")));
    EXPECT_TRUE(toJson(report)["photos"][4]["sigma_deg"].is_null());
    EXPECT_EQ(store.solvedPhotos(report.solution).size(), 5U);
}

TEST_F(AlignSurvey, HandsOnNothingOfMirroredTags) {
    photograph();
    for (Eigen::Vector3d& place : places) {
        place.y() = 3.4 - place.y(); // the two rows are exchanged
    }
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    EXPECT_TRUE(report.tagFrame.isMirrored);
    for (const AlignedPhoto& photo : report.photos) {
        EXPECT_EQ(photo.quality, survey::Quality::Failed) << photo.file;
        EXPECT_EQ(photo.fits, "") << photo.file; // nobody shall swap them
        EXPECT_FALSE(photo.isHandedOn()) << photo.file;
    }
    ASSERT_EQ(report.tagWarnings.size(), 1U);
    EXPECT_THAT(report.tagWarnings[0], HasSubstr("mirrored"));
    const std::string words = alignText(report);
    EXPECT_THAT(words, HasSubstr("How the photos are turned is not known."));
    EXPECT_THAT(words, testing::Not(HasSubstr("known to")));
    EXPECT_TRUE(toJson(report)["sigma_common_yaw_deg"].is_null());
    EXPECT_TRUE(store.solvedPhotos(store.activeSolution()->id).empty());
    EXPECT_TRUE(activeFindings(store)->retags().empty());
    expectError(ErrorKind::InvalidInput, "mirrored",
                [&] { exportDataset(store, folder / "d", {}, noProgress(), {}); });
}

TEST_F(AlignSurvey, NamesAPhotoThatItMovedFarFromItsTag) {
    photograph();
    places[4] += Eigen::Vector3d(0.05, 0.03, 0);
    auto store = newSurvey();
    AlignOptions options;
    options.checksPositions = false; // This move is smaller than what that check looks for.
    const AlignReport report = alignSurvey(store, options, noProgress(), {});
    for (const AlignedPhoto& photo : report.photos) {
        const bool isNamed = std::ranges::any_of(
            photo.flags, [](const auto& flag) { return flag.find("from where it is tagged") != flag.npos; });
        EXPECT_EQ(isNamed, photo.file == "R4.JPG") << photo.file;
    }
}

TEST_F(AlignSurvey, LooksAgainWithMoreEffortBeforeAPartIsGivenUp) {
    const practice::PracticeRoom room;
    const practice::PhotoErrors errors;
    for (int i = 0; i < 3; ++i) { // so far apart that a first look joins none
        places.emplace_back(0.7 + 1.8 * i, 1.1, 1.2);
        truth.push_back(errors.truePose(places.back(), i + 1));
        pictures.push_back(room.spherical(truth.back(), {kWidth, kWidth / 2}));
    }
    auto store = newSurvey();
    AlignOptions draft;
    draft.effort = align::Effort::Draft;
    const AlignReport report = alignSurvey(store, draft, noProgress(), {});
    EXPECT_GT(report.pairsTriedAgain, 0U);
    const AlignmentError error = alignmentError(report, truePoses(store));
    EXPECT_EQ(error.photos, 3);
    EXPECT_LT(error.yawRmsDeg, 0.5);
}

/// A square of four places 25 cm apart.
std::vector<Eigen::Vector2d> squareAt(double x, double y) {
    return {{x, y}, {x + 0.25, y}, {x, y + 0.25}, {x + 0.25, y + 0.25}};
}

TEST_F(AlignSurvey, TellsThreeRoomsWithoutSightOfEachOtherAsThreeParts) {
    std::vector<Eigen::Vector2d> all = squareAt(3.2, 4.2);
    for (const auto& [x, y] : {std::pair(4.5, 4.6), {3.9, 0.5}}) {
        const std::vector<Eigen::Vector2d> more = squareAt(x, y);
        all.insert(all.end(), more.begin(), more.end());
    }
    photographFlat(all);
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    EXPECT_EQ(report.alignment.components, 3);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const AlignedPhoto& photo = photoOf(report, text("R", i, ".JPG"));
        EXPECT_TRUE(photo.pose.isSolved) << photo.file;
        EXPECT_EQ(photo.pose.component, photoOf(report, text("R", i / 4 * 4, ".JPG")).pose.component)
            << photo.file;
        const bool isNamed = std::ranges::any_of(
            photo.flags, [](const auto& flag) { return flag.find("(3 parts)") != flag.npos; });
        EXPECT_EQ(isNamed, photo.pose.component > 0) << photo.file;
    }
    EXPECT_THAT(alignText(report), HasSubstr("3 parts"));
}

TEST_F(AlignSurvey, JoinsRoomAndCorridorByOnePhotoInTheDoorway) {
    std::vector<Eigen::Vector2d> all = squareAt(1.9, 0.4);
    const std::vector<Eigen::Vector2d> inside = squareAt(1.9, 2.1);
    all.insert(all.end(), inside.begin(), inside.end());
    all.emplace_back(2.0, 1.45); // in the doorway
    photographFlat(all);
    auto store = newSurvey();
    const AlignReport report = alignSurvey(store, {}, noProgress(), {});
    EXPECT_EQ(report.alignment.components, 1) << alignText(report);
    const AlignmentError error = alignmentError(report, truePoses(store));
    EXPECT_EQ(error.photos, 9);
    EXPECT_LT(error.yawRmsDeg, 0.2);
    EXPECT_LT(error.ownTiltRmsDeg, 0.1);
}

TEST_F(AlignSurvey, MeasuresWhatEachEffortAndModelCosts) {
    photograph();
    auto store = newSurvey();
    AlignTradeOptions options;
    options.efforts = {align::Effort::Draft};
    options.models = {align::Model::Yaw, align::Model::Tilt};
    options.truth = truePoses(store);
    const AlignTrade trade = alignTrade(store, options, noProgress(), {});
    ASSERT_EQ(trade.rows.size(), 2U);
    EXPECT_LT(trade.rows[1].error->yawRmsDeg, 0.2);
    EXPECT_TRUE(trade.rows[1].heldOutDeg);
    EXPECT_GT(trade.rows[0].seconds(), 0);
    EXPECT_FALSE(store.activeSolution());
    EXPECT_THAT(tradeTable(trade), HasSubstr("draft"));
    EXPECT_THAT(tradePlot(trade, "s"), testing::EndsWith("</svg>\n"));
}

} // namespace spherewalk::jobs
