// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_summary.h"
#include "random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace spherewalk::jobs {

namespace {

/// A view in which so many features are displaced by so many pixels each, and so many are missed.
Comparison displaced(std::size_t features, double px, std::size_t missed = 0) {
    Comparison comparison;
    comparison.features = {std::vector<int>(features, static_cast<int>(100 * px)), missed};
    return comparison;
}

SceneLikeness together(const std::vector<Comparison>& views) {
    SceneSummary summary(render::SceneKind::Depth, render::Sampling::Bilinear, Places::Features);
    for (const Comparison& view : views) {
        summary.add(view, {});
    }
    return summary.result();
}

} // namespace

TEST(SceneSummary, TakesBothFiguresFromTheSameFeatures) {
    const SceneLikeness likeness = together({displaced(100, 1), displaced(20, 2), displaced(3, 500)});
    EXPECT_EQ(likeness.medianPx, 1);
    EXPECT_EQ(likeness.p95Px, 2);
    EXPECT_LE(*likeness.medianPx, *likeness.p95Px);
}

TEST(SceneSummary, CountsWhatIsMissedAsEndlesslyFarOff) {
    EXPECT_EQ(together({displaced(96, 1, 4)}).p95Px, 1);
    const SceneLikeness tenth = together({displaced(50, 1, 0), displaced(40, 2, 10)});
    EXPECT_EQ(tenth.p95Px, HUGE_VAL);
    EXPECT_EQ(tenth.medianPx, 2);
    EXPECT_DOUBLE_EQ(tenth.missedShare, 0.1);
    EXPECT_EQ(together({displaced(3, 1, 97)}).medianPx, HUGE_VAL) << "however well a handful matches";
}

TEST(SceneSummary, HasNoMedianWithoutFeatures) {
    const SceneLikeness likeness = together({displaced(0, 0), displaced(0, 0)});
    EXPECT_EQ(likeness.medianPx, std::nullopt);
    EXPECT_EQ(likeness.p95Px, std::nullopt);
    EXPECT_EQ(likeness.missedShare, 0);
    EXPECT_EQ(likeness.views.size(), 2U);
}

TEST(SceneSummary, CountsMissesAboutAPhotoToo) {
    SceneSummary summary(render::SceneKind::Depth, render::Sampling::Bilinear, Places::Features);
    ViewLikeness view;
    view.leftOut = 3;
    summary.add(displaced(80, 1, 20), view);
    const SceneLikeness likeness = summary.result();
    ASSERT_EQ(likeness.photos.size(), 1U);
    EXPECT_EQ(likeness.photos[0].p95Px, HUGE_VAL);
    EXPECT_EQ(likeness.photos[0].places, 100U);
}

TEST(BetweenPhotos, PlacesAreAsFarFromAPhotoAsTheGridMakesThem) {
    std::vector<Eigen::Vector3d> grid;
    std::vector<Eigen::Vector3d> line;
    for (int i = 0; i < 25; ++i) {
        grid.emplace_back(3 + 0.4 * (i % 5), 0.4 * (i / 5), 1.2);
        line.emplace_back(0.4 * i, 7, 1.2);
    }
    EXPECT_NEAR(betweenPhotosM(grid), 0.16, 0.01); // half of the places: pi r^2 = step^2 / 2
    EXPECT_NEAR(betweenPhotosM(line), 0.1, 0.01);
    EXPECT_EQ(betweenPhotosM({{1, 2, 3}}), 0);
    EXPECT_EQ(betweenPhotosM({{1, 2, 3}, {1, 2, 3}}), 0);
}

// One thing of ten lies at an edge and is off by very much. So it is in the views that are foretold.
TEST(Foretold, IsTheUsualErrorAndNotTheMeanOfAFewGreatOnes) {
    const CameraModel camera(CameraIntrinsics::pinhole(240, 180, 1.0));
    test::Random random(84);
    SceneLikeness leaveOneOut;
    leaveOneOut.scene = render::SceneKind::Room;
    ViewLikeness view;
    view.offset = {0.2, 0, 0};
    for (int i = 0; i < 20; ++i) {
        ViewLikeness from = view;
        from.offset = {0.4, 0, 0};
        for (int thing = 0; thing < 60; ++thing) {
            const Eigen::Vector2d pixel(random.uniform(0, 239), random.uniform(0, 179));
            from.things.push_back({2 * *camera.ray(pixel), random.uniform(0, 1) < 0.1 ? 100 : 1.0});
        }
        leaveOneOut.views.push_back(std::move(from));
    }
    EXPECT_NEAR(foretoldPx(leaveOneOut, view, camera).value(), 0.5, 0.02);
    leaveOneOut.scene = render::SceneKind::Depth; // the photos' own depths are off as much
    EXPECT_NEAR(foretoldPx(leaveOneOut, view, camera).value(), 0.5 / std::sqrt(2), 0.02);
}

TEST(LooksSummary, HasMeansAndTheWorstOfEach) {
    const LooksSummary summary =
        summaryOf({{30, 0.9, 0.01, 0.2, 0.5, 4, 3}, {20, 0.7, 0.05, 0.1, std::nullopt, 2, 0}});
    EXPECT_EQ(summary.views, 2U);
    EXPECT_DOUBLE_EQ(summary.mean.psnrDb, 25);
    EXPECT_DOUBLE_EQ(summary.mean.ssim, 0.8);
    EXPECT_DOUBLE_EQ(summary.mean.falseEdges, 0.03);
    EXPECT_DOUBLE_EQ(summary.mean.missedEdges, 0.15);
    EXPECT_EQ(summary.mean.bendPx, 0.5) << "of the view that shows lines";
    EXPECT_EQ(summary.mean.lines, 6U);
    EXPECT_EQ(summary.mean.linesFound, 3U);
    EXPECT_EQ(summary.worst.psnrDb, 20);
    EXPECT_EQ(summary.worst.ssim, 0.7);
    EXPECT_EQ(summary.worst.falseEdges, 0.05);
    EXPECT_EQ(summary.worst.missedEdges, 0.2);
    EXPECT_EQ(summaryOf({}).mean.ssim, 0);
}

} // namespace spherewalk::jobs
