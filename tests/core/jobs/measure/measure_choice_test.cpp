// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_summary.h"
#include "random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::jobs {

using render::Sampling;
using render::SceneKind;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

/// A report of two photos, with these rungs; the scene models' own errors are those with the first sampling.
MeasureReport reportOf(std::vector<Rung> rungs) {
    MeasureReport report;
    report.photos = 2;
    report.focalPx = 500;
    for (const Rung& rung : rungs) {
        if (report.scenes.empty() || report.scenes.back().scene != rung.scene) {
            SceneLikeness scene;
            scene.scene = rung.scene;
            scene.p95Px = rung.errorPx;
            scene.photos = {{0, rung.errorPx, 100}, {1, rung.errorPx, 100}};
            report.scenes.push_back(scene);
        }
    }
    report.rungs = std::move(rungs);
    return report;
}

const std::vector<Rung> kLadder{{SceneKind::Sphere, Sampling::Nearest, 9.0, 0.5, 100},
                                {SceneKind::Sphere, Sampling::Footprint, 6.0, 1.0, 100},
                                {SceneKind::Depth, Sampling::Nearest, 3.0, 15.0, 200},
                                {SceneKind::Depth, Sampling::Footprint, 2.0, 20.0, 200}};

const CameraModel kCamera(CameraIntrinsics::pinhole(640, 480, 1.0));

/// Gives a scene model views of these looks.
void look(SceneLikeness& scene, const std::vector<double>& ssim, double falseEdges) {
    scene.views.clear();
    std::vector<Looks> all;
    for (const double one : ssim) {
        ViewLikeness view;
        view.looks.ssim = one;
        view.looks.falseEdges = falseEdges;
        all.push_back(view.looks);
        scene.views.push_back(view);
    }
    scene.looks = summaryOf(all);
}

ViewLikeness viewAt(double x, double offsetY, double medianPx) {
    ViewLikeness view;
    view.roomFromCamera.translation = {x, 0, 0};
    view.offset = {0, offsetY, 0};
    view.medianPx = medianPx;
    return view;
}

} // namespace

TEST(MeasureChoice, IsTheCheapestRungWithinTheTolerance) {
    const MeasureReport report = reportOf(kLadder);
    EXPECT_EQ(chosen(report, 10).rung, 0U);
    EXPECT_EQ(chosen(report, 7).rung, 1U);
    EXPECT_EQ(chosen(report, 4).rung, 2U);
    EXPECT_EQ(chosen(report, 2).rung, 3U);
    EXPECT_TRUE(chosen(report, 2).isWithin);
}

TEST(MeasureChoice, SaysThatNoneHoldsAndNamesTheBest) {
    const Choice choice = chosen(reportOf(kLadder), 1);
    EXPECT_FALSE(choice.isWithin);
    EXPECT_EQ(choice.rung, 3U);
    EXPECT_THAT(choice.reason, HasSubstr("No option of this dataset holds 1.00 px"));
    EXPECT_THAT(choice.reason, HasSubstr("depth with sampling footprint, reaches 2.00 px"));
}

TEST(MeasureChoice, SaysWhetherPicturesOrPhotosLeftOutJudged) {
    MeasureReport report = reportOf(kLadder);
    EXPECT_THAT(chosen(report, 4).reason, StartsWith("The cheapest that holds 4.00 px"));
    report.isLeaveOneOut = false;
    EXPECT_THAT(chosen(report, 4).reason, StartsWith("On the robot's pictures the cheapest that holds"));
    EXPECT_THAT(chosen(report, 1).reason, StartsWith("On the robot's pictures no option of this dataset"));
}

TEST(MeasureChoice, SaysWhatTheBestOfTheCheaperOnesReaches) {
    EXPECT_THAT(chosen(reportOf(kLadder), 4).reason, HasSubstr("reaches 6.00 px"));
}

TEST(MeasureChoice, TakesTheSmallerDatasetOfTwoThatCostAboutAsMuch) {
    std::vector<Rung> rungs = kLadder;
    rungs[1].errorPx = 3.5;
    ASSERT_LT(rungs[2].cost(), 1.1 * rungs[1].cost());
    EXPECT_EQ(chosen(reportOf(rungs), 4).rung, 1U);
}

TEST(MeasureChoice, TakesTheMoreExactOfTwoThatCostAboutAsMuch) {
    const MeasureReport report = reportOf({{SceneKind::Sphere, Sampling::Bilinear, 2.0, 9, 100},
                                           {SceneKind::Sphere, Sampling::Reduced, 3.0, 1, 100}});
    EXPECT_EQ(chosen(report, 4).rung, 0U);
}

TEST(MeasureChoice, DoesNotDependOnWhatElseTheMachineDoes) {
    test::Random random(4);
    for (int i = 0; i < 20; ++i) {
        std::vector<Rung> rungs = kLadder;
        for (Rung& rung : rungs) {
            rung.renderMs = random.uniform(0.1, 100);
        }
        for (const double tolerancePx : {2.0, 4.0, 7.0, 10.0}) {
            EXPECT_EQ(chosen(reportOf(rungs), tolerancePx).rung, chosen(reportOf(kLadder), tolerancePx).rung);
        }
    }
}

TEST(MeasureChoice, KnowsTheCostOfEveryRungAndGrowsWithTheSceneModel) {
    for (const Sampling sampling :
         {Sampling::Nearest, Sampling::Bilinear, Sampling::Reduced, Sampling::Footprint, Sampling::Bicubic}) {
        EXPECT_GT(nominalCost(SceneKind::None, sampling), 0);
        EXPECT_GE(nominalCost(SceneKind::Sphere, sampling), nominalCost(SceneKind::None, sampling));
        EXPECT_GT(nominalCost(SceneKind::Room, sampling), nominalCost(SceneKind::Sphere, sampling));
        EXPECT_GT(nominalCost(SceneKind::Depth, sampling), nominalCost(SceneKind::Room, sampling));
        EXPECT_GT(nominalCost(SceneKind::Blend, sampling), nominalCost(SceneKind::Depth, sampling));
    }
    EXPECT_EQ(nominalCost(SceneKind::Sphere, Sampling::Bilinear), 1);
}

TEST(MeasureChoice, NeverPrefersWhatLooksWorseThanACheaperModel) {
    MeasureReport report = reportOf(kLadder);
    look(report.scenes[0], {0.68, 0.70, 0.69, 0.71}, 0.1);
    look(report.scenes[1], {0.46, 0.47, 0.50, 0.44}, 0.1);
    const Choice choice = chosen(report, 4); // which depth alone holds
    EXPECT_FALSE(choice.isWithin);
    EXPECT_EQ(choice.rung, 1U);
    ASSERT_EQ(choice.passedOver.size(), 1U);
    EXPECT_EQ(choice.passedOver[0].scene, SceneKind::Depth);
    EXPECT_EQ(choice.passedOver[0].than, SceneKind::Sphere);
    EXPECT_THAT(choice.reason, HasSubstr("The scene model depth is not chosen, because its views look worse "
                                         "than those of the cheaper sphere: in the same 4 views its SSIM is "
                                         "lower by 0.22"));
}

TEST(MeasureChoice, NeverPrefersWhatInventsEdges) {
    MeasureReport report = reportOf(kLadder);
    look(report.scenes[0], {0.6, 0.6, 0.6, 0.6}, 0.10);
    look(report.scenes[1], {0.8, 0.8, 0.8, 0.8}, 0.13);
    const Choice choice = chosen(report, 4);
    EXPECT_EQ(choice.rung, 1U);
    EXPECT_THAT(choice.reason, HasSubstr("its false edges are more by 3.0 (the margin is 0.5) percent"));
}

TEST(MeasureChoice, LetsLooksPassThatDifferByLessThanTheirSpread) {
    MeasureReport report = reportOf(kLadder);
    look(report.scenes[0], {0.60, 0.80, 0.60, 0.80}, 0.1);
    look(report.scenes[1], {0.70, 0.68, 0.72, 0.66}, 0.1); // lower by 0.01 on average, +-0.07
    EXPECT_EQ(chosen(report, 4).rung, 2U);
    EXPECT_TRUE(chosen(report, 4).passedOver.empty());
    look(report.scenes[0], {0.701, 0.702, 0.703, 0.704}, 0.1);
    look(report.scenes[1], {0.700, 0.701, 0.702, 0.703}, 0.1); // which nobody sees
    EXPECT_EQ(chosen(report, 4).rung, 2U);
}

TEST(MeasureChoice, DoesNotJudgeLooksByAHandfulOfViews) {
    MeasureReport report = reportOf(kLadder);
    look(report.scenes[0], {0.7, 0.7, 0.7}, 0.1);
    look(report.scenes[1], {0.4, 0.4, 0.4}, 0.1);
    EXPECT_TRUE(chosen(report, 4).passedOver.empty());
}

TEST(MeasureChoice, GivesNoPhotoAModelThatIsPassedOver) {
    MeasureReport report = reportOf({{SceneKind::None, Sampling::Bilinear, 9.0, 1, 100},
                                     {SceneKind::Sphere, Sampling::Bilinear, 8.0, 1, 100},
                                     {SceneKind::Depth, Sampling::Bilinear, 3.0, 1, 200}});
    look(report.scenes[0], {0.7, 0.7, 0.7, 0.7}, 0.1);
    look(report.scenes[1], {0.6, 0.6, 0.6, 0.6}, 0.1);
    look(report.scenes[2], {0.8, 0.8, 0.8, 0.8}, 0.1);
    report.scenes[1].photos = {{0, 1.0, 100}, {1, 12.0, 100}};
    EXPECT_EQ(chosen(report, 4).rung, 2U);
    EXPECT_TRUE(chosen(report, 4).photoScenes.empty());
}

TEST(MeasureChoice, HoldsNothingWhereTooManyPlacesAreMissed) {
    MeasureReport report = reportOf({{SceneKind::Sphere, Sampling::Bilinear, HUGE_VAL, 1, 100},
                                     {SceneKind::Depth, Sampling::Bilinear, HUGE_VAL, 1, 200}});
    look(report.scenes[0], {0.6, 0.6, 0.6, 0.6}, 0.1);
    look(report.scenes[1], {0.8, 0.8, 0.8, 0.8}, 0.1);
    const Choice choice = chosen(report, 1000);
    EXPECT_FALSE(choice.isWithin);
    EXPECT_EQ(choice.rung, 1U) << "which looks better";
    EXPECT_THAT(choice.reason, HasSubstr("misses more than 5 of 100 places"));
    report.choice = choice;
    EXPECT_FALSE(viewChoice(report)->isWithin());
    EXPECT_TRUE(std::isfinite(viewChoice(report)->errorPx)) << "as the description of a dataset needs it";
}

TEST(MeasureChoice, SaysSoWhereNothingCouldBeCompared) {
    const MeasureReport report = reportOf({{SceneKind::None, Sampling::Bilinear, std::nullopt, 1, 100}});
    EXPECT_FALSE(chosen(report, 4).rung);
    EXPECT_FALSE(viewChoice(report));
    EXPECT_THAT(chosen(report, 4).reason, HasSubstr("Nothing could be compared"));
}

TEST(MeasureChoice, GivesAPhotoTheCheaperSceneModelThatIsEnoughAboutIt) {
    MeasureReport report = reportOf(kLadder);
    report.scenes[0].photos = {{0, 12.0, 100}, {1, 1.0, 100}}; // with sampling nearest, as the scenes' errors
    const Choice choice = chosen(report, 4);
    ASSERT_EQ(choice.photoScenes.size(), 2U);
    EXPECT_FALSE(choice.photoScenes[0]);
    EXPECT_EQ(choice.photoScenes[1], SceneKind::Sphere);
    EXPECT_DOUBLE_EQ(choice.meanRenderMs, (15 + 0.5) / 2);
}

TEST(MeasureChoice, BelievesNoPhotoOfWhichLittleWasCompared) {
    MeasureReport report = reportOf(kLadder);
    report.scenes[0].photos = {{0, 1.0, 3}, {1, 1.0, 3}};
    EXPECT_TRUE(chosen(report, 4).photoScenes.empty());
}

TEST(MeasurePrediction, GrowsWithTheOffsetAcrossTheAxis) {
    SceneLikeness leftOut;
    leftOut.views = {viewAt(0, 0.2, 4)};
    EXPECT_DOUBLE_EQ(foretoldPx(leftOut, viewAt(0, 0.1, 0), kCamera).value(), 2);
    ViewLikeness along = viewAt(0, 0, 0);
    along.offset = {0, 0, 0.1};
    EXPECT_LT(foretoldPx(leftOut, along, kCamera).value(), 1);
}

TEST(MeasurePrediction, ListensToTheNearestViewsMost) {
    SceneLikeness leftOut;
    leftOut.views = {viewAt(0, 0.2, 1), viewAt(2, 0.2, 10)};
    EXPECT_LT(foretoldPx(leftOut, viewAt(0.2, 0.2, 0), kCamera).value(), 1.1);
    EXPECT_GT(foretoldPx(leftOut, viewAt(1.8, 0.2, 0), kCamera).value(), 9.9);
    leftOut.views[1].roomFromCamera = {Eigen::Quaterniond(0, 0, 1, 0), leftOut.views[0].at()};
    EXPECT_LT(foretoldPx(leftOut, viewAt(0, 0.2, 0), kCamera).value(), 1.1);
}

TEST(MeasurePrediction, CountsTheThingsThatTheViewHasInItsFrame) {
    // A wall ahead: little is off to the left, much to the right; something farther is off by far more.
    SceneLikeness leftOut;
    leftOut.views = {viewAt(0, 0.2, 5)};
    for (int i = -40; i <= 40; ++i) {
        for (int j = -20; j <= 20; ++j) {
            const Eigen::Vector3d at(0.1 * i, 0.1 * j, 2);
            leftOut.views[0].things.push_back({at, i < 0 ? 1.0 : 9.0});
            leftOut.views[0].things.push_back({1.5 * at, 100});
        }
    }
    ViewLikeness left = viewAt(0, 0.1, 0);
    left.roomFromCamera.rotation = Eigen::AngleAxisd(-0.8, Eigen::Vector3d::UnitY());
    ViewLikeness right = left;
    right.roomFromCamera.rotation = left.roomFromCamera.rotation.conjugate();
    EXPECT_NEAR(foretoldPx(leftOut, left, kCamera).value(), 0.5, 1e-6); // at half the offset
    EXPECT_NEAR(foretoldPx(leftOut, right, kCamera).value(), 4.5, 1e-6);
    ViewLikeness behind = left;
    behind.roomFromCamera.rotation = Eigen::AngleAxisd(3.1, Eigen::Vector3d::UnitY());
    EXPECT_NE(foretoldPx(leftOut, behind, kCamera), std::nullopt); // by the view as a whole
}

TEST(MeasurePrediction, IsUnknownWithoutAViewThatWasCompared) {
    SceneLikeness leftOut;
    leftOut.views = {ViewLikeness{}};
    EXPECT_FALSE(foretoldPx(leftOut, viewAt(0, 0.1, 0), kCamera));
}

} // namespace spherewalk::jobs
