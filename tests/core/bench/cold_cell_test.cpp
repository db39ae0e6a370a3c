// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_dataset.h"
#include "measurements.h"
#include "temporary_folder.h"

#include "spherewalk/base/parallel.h"

namespace spherewalk::bench {

using test::expectError;

namespace {

ColdCells coldCellsAt(const std::vector<Eigen::Vector3d>& places, int views) {
    const test::TemporaryFolder folder;
    test::MadeDataset made;
    made.places = places;
    return measureColdCells(test::openMadeDataset(folder.path(), made), views, noProgress(), {});
}

} // namespace

TEST(ColdCells, LeaveOutPhotosThatAreNowhereTheNearest) {
    // The second one would be measured first, and its view would find the first one in memory.
    for (const BenchRow& row : coldCellsAt({{0, 0, 1}, {0, 0, 1}, {1, 0, 1}}, 1).rows) {
        EXPECT_GT(row.parts->decodeMs, 0) << row.name;
    }
}

TEST(ColdCells, CanBeMeasuredWhereAllPhotosShareOnePlace) {
    const ColdCells cells = coldCellsAt({{0, 0, 1}, {0, 0, 1}}, 3);
    ASSERT_EQ(cells.rows.size(), 3U);
    for (const BenchRow& row : cells.rows) {
        EXPECT_GT(row.parts->decodeMs, 0) << row.name;
    }
}

TEST(ColdCells, AreLevelViewsOf90DegreesByAllThreads) {
    for (const BenchRow& row : coldCellsAt({{0, 0, 1}, {1, 0, 1}}, 1).rows) {
        EXPECT_EQ(row.view->fieldDeg, 90);
        EXPECT_EQ(row.view->pitchDeg, 0);
        EXPECT_EQ(row.threads, hardwareThreads());
        EXPECT_GE(row.own.medianMs, row.parts->decodeMs); // decoding is a part of the view
    }
}

TEST(ColdCells, NeedNoMarkersInThePhotos) {
    const test::TemporaryFolder folder;
    const auto unmarked = test::withoutMarkers(*test::openMadeDataset(folder.path()));
    EXPECT_EQ(measureColdCells(unmarked, 2, noProgress(), {}).rows.size(), 3U);
}

TEST(ColdCells, NameThePhotoThatWasChanged) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    Bytes bytes = readFile(dataset->folder() / "photos/1.jpg");
    bytes[bytes.size() / 2] ^= 1;
    writeFile(dataset->folder() / "photos/1.jpg", bytes);
    expectError(ErrorKind::Corrupt, "photos/1.jpg", [&] { measureColdCells(dataset, 4, noProgress(), {}); });
}

TEST(ColdCells, SayWhichPhotoIsGone) {
    const test::TemporaryFolder folder;
    const auto dataset = test::openMadeDataset(folder.path());
    std::filesystem::remove(dataset->folder() / "photos/1.jpg");
    expectError(ErrorKind::NotFound, "1.jpg", [&] { measureColdCells(dataset, 4, noProgress(), {}); });
}

TEST(FileCache, IsNotSaidToHaveDroppedAnEmptyFile) {
    const test::TemporaryFolder folder;
    writeFile(folder / "empty", {});
    EXPECT_FALSE(dropFromFileCache(folder / "empty"));
}

} // namespace spherewalk::bench
