// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "measure/photo_grid.h"
#include "parts/practice_dataset.h"
#include "random.h"

#include "spherewalk/jobs/grid_study.h"

#include <set>

namespace spherewalk::jobs {

using Eigen::Vector3d;

namespace {

/// A turned block of so many columns and rows, each photo up to `off` metres beside its point.
std::vector<Vector3d> block(int columns, int rows, double turn, double off) {
    test::Random random(5);
    std::vector<Vector3d> places;
    for (int i = 0; i < columns * rows; ++i) {
        const Vector3d place(0.2 * (i % columns), 0.2 * (i / columns), 1.2);
        const Vector3d error(random.uniform(-off, off), random.uniform(-off, off), 0);
        places.push_back(Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * (place + error) + Vector3d(1e5, 3, 0));
    }
    return places;
}

} // namespace

TEST(PhotoGrid, FindsStepAndPointsOfATurnedAndUnevenBlock) {
    const PhotoGrid grid(block(5, 4, 0.3, 0.005));
    EXPECT_NEAR(grid.stepM(), 0.2, 0.01);
    EXPECT_EQ(grid.photos().size(), 20U);
    std::set<int> columns;
    for (const auto& [point, photo] : grid.photos()) {
        columns.insert(point[0]);
    }
    EXPECT_TRUE(columns.size() == 5 || columns.size() == 4); // an axis may be the other one
}

TEST(PhotoGrid, OfPhotosAtOnePlaceHasNoStep) {
    const PhotoGrid grid(std::vector<Vector3d>{{1, 1, 1}, {1, 1, 1}});
    EXPECT_EQ(grid.stepM(), 0);
    EXPECT_TRUE(grid.photos().empty());
}

TEST(GridSplit, HoldsOutOnlyWhatStandsBetweenKeptPhotos) {
    const std::vector<Vector3d> places = block(5, 5, 0, 0);
    const PhotoGrid grid(places);
    const GridSplit second = bestSplits(grid, 2, 1).at(0);
    EXPECT_EQ(second.kept.size(), 9U);
    EXPECT_EQ(second.heldOut.size(), 16U);
    const GridSplit fourth = bestSplits(grid, 4, 1).at(0);
    EXPECT_EQ(fourth.kept.size(), 4U);
    EXPECT_EQ(fourth.heldOut.size(), 21U);
    const GridSplit chess = bestSplits(grid, 1, 1).at(0);
    EXPECT_NEAR(chess.grid.stepM(0.2), 0.283, 1e-3);
    for (const std::size_t photo : chess.heldOut) { // none at the edge, which would have too few about it
        EXPECT_GT(places[photo].x() - 1e5, 0.1);
        EXPECT_LT(places[photo].x() - 1e5, 0.7);
    }
    EXPECT_TRUE(bestSplits(grid, 5, 3).empty());
}

TEST(GridSplit, NeedsAllCornersOfACell) {
    std::vector<Vector3d> places = block(3, 3, 0, 0);
    places.erase(places.begin() + 8); // a corner
    const GridSplit split = bestSplits(PhotoGrid(places), 2, 1).at(0);
    EXPECT_EQ(split.kept.size(), 3U);
    EXPECT_EQ(split.heldOut.size(), 2U); // on the two edges that have both ends, not the one in the middle
}

TEST(GridStudy, SaysWhatEachStepShowsAndCosts) {
    const test::PracticeDataset dataset(3, false);
    GridStudyOptions options;
    options.withDepth = false;
    options.tolerancePx = 1000;
    options.mostOffsets = 1;
    options.mostViews = 8;
    options.room = {dataset.renderer().dataset().info().outline, {}, 2.6};
    const GridStudy study =
        gridStudy(dataset.renderer(), test::PracticeDataset::camera(), options, noProgress(), {});
    EXPECT_NEAR(study.gridStepM, 0.2, 1e-6);
    std::vector<GridRow> sphere;
    for (const GridRow& row : study.rows) {
        if (row.scene == render::SceneKind::Sphere) {
            sphere.push_back(row);
        }
    }
    ASSERT_EQ(sphere.size(), 2U);        // 28 and 40 cm
    EXPECT_EQ(sphere.front().views, 4U); // the middle one in four directions
    EXPECT_EQ(sphere.back().views, 9U);
    EXPECT_EQ(sphere.back().keptPhotos, 4U);
    EXPECT_GT(sphere.back().looks.psnrDb, 5);
    ASSERT_EQ(study.costs.size(), 2U);
    EXPECT_GT(study.costs.front().minutes, 1.5 * study.costs.back().minutes);
    const GridAnswer& answer = study.answers.at(1);
    EXPECT_EQ(answer.scene, render::SceneKind::Sphere);
    EXPECT_TRUE(answer.isLargest);
    EXPECT_NEAR(answer.stepM.value(), 0.4, 1e-6);
    EXPECT_GT(answer.cost.value().photos, 0);
}

TEST(GridStudy, RefusesPhotosWithNothingBetweenThem) {
    const test::PracticeDataset dataset(2, false);
    GridStudyOptions options;
    options.withDepth = false;
    test::expectError(ErrorKind::InvalidInput, "5 x 5", [&] {
        gridStudy(dataset.renderer(), test::PracticeDataset::camera(), options, noProgress(), {});
    });
}

} // namespace spherewalk::jobs
