// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_dataset.h"
#include "measurements.h"
#include "random.h"
#include "sensor_rows.h"
#include "sphere/exact_view.h"
#include "temporary_folder.h"
#include "walk_path.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace spherewalk::bench {

using test::expectError;

class Phases : public testing::Test {
  protected:
    static std::set<std::string> namesOf(const std::vector<BenchRow>& rows) {
        std::set<std::string> names;
        for (const BenchRow& row : rows) {
            EXPECT_GT(row.own.medianMs, 0) << row.name;
            EXPECT_GE(row.own.madMs, 0) << row.name;
            EXPECT_GE(row.threads, 1) << row.name;
            names.insert(row.name);
        }
        return names;
    }

    test::TemporaryFolder folder;
    std::shared_ptr<const render::Dataset> dataset = test::openMadeDataset(folder.path());
};

TEST_F(Phases, ViewsAreTimedAfterTheyWereCheckedAndComparedWithPeers) {
    const BenchPhoto photo(dataset);
    EXPECT_DOUBLE_EQ(photo.freeM(), 0.25);
    const std::vector<BenchRow> rows = measureViews(photo, {57, 80}, true, 2, noProgress(), {});
    EXPECT_EQ(namesOf(rows), (std::set<std::string>{"view.nearest.57.steep", "view.bilinear.57.steep",
                                                    "view.reduced.57.steep", "view.footprint.57.steep",
                                                    "view.bicubic.57.steep"}));
    std::set<std::string> peers;
    for (const BenchRow& row : rows) {
        if (row.name == "view.bilinear.57.steep" && row.threads == 1) {
            ASSERT_TRUE(row.peer);
            peers.insert(row.peer->name);
            EXPECT_DOUBLE_EQ(row.ratio(), row.peer->medianMs / row.own.medianMs);
        }
        ASSERT_TRUE(row.parts);
        EXPECT_EQ(row.parts->decodeMs, 0); // all was in memory
    }
    EXPECT_EQ(peers, (std::set<std::string>{kMapsAndRemap, kRemap, kRemapSameMap}));
}

TEST_F(Phases, ViewsNeedNeitherPeersNorASphereNorASecondPhoto) {
    const test::TemporaryFolder other;
    test::MadeDataset made;
    made.places = {{5, 5, 1}};
    made.hasSphere = false;
    const BenchPhoto photo(test::openMadeDataset(other.path(), made));
    const std::vector<BenchRow> rows = measureViews(photo, {90, 0}, false, 1, noProgress(), {});
    EXPECT_TRUE(namesOf(rows).contains("view.footprint"));
    for (const BenchRow& row : rows) {
        EXPECT_EQ(row.peer.has_value(), row.threads > 1);
    }
}

TEST_F(Phases, ExtrasAreComparedWithTheViewAlone) {
    const std::vector<BenchRow> rows = measureExtras(BenchPhoto(dataset), 2, noProgress(), {});
    std::set<std::string> expected = test::sensorRows();
    expected.insert("view.with_trust");
    const test::TemporaryFolder other;
    test::MadeDataset made;
    made.hasSphere = false;
    const BenchPhoto without(test::openMadeDataset(other.path(), made));
    EXPECT_EQ(namesOf(measureExtras(without, 1, noProgress(), {})), expected);
    expected.insert(
        {"view.with_depth", "view.with_overlay", "view.with_overlay.shadow", "view.with_overlay.other_lens"});
    EXPECT_EQ(namesOf(rows), expected);
    for (const BenchRow& row : rows) {
        EXPECT_EQ(row.peer->name, kViewAlone);
    }
}

TEST_F(Phases, ScenesWithSurfacesAreComparedWithTheSphere) {
    EXPECT_TRUE(measureScenes(BenchPhoto(dataset), 1, noProgress(), {}).empty());
    const test::TemporaryFolder other;
    test::MadeDataset made;
    made.hasRoom = true;
    const std::vector<BenchRow> rows =
        measureScenes(BenchPhoto(test::openMadeDataset(other.path(), made)), 2, noProgress(), {});
    EXPECT_EQ(namesOf(rows), (std::set<std::string>{"scene.room.bilinear", "scene.room.footprint"}));
    for (const BenchRow& row : rows) {
        EXPECT_EQ(row.peer->name, kSphereView);
        EXPECT_GT(row.peer->medianMs, 0);
    }
}

TEST_F(Phases, DecodingHasPartsOnlyWhereThePhotoHasMarkers) {
    const std::vector<BenchRow> rows = measureDecoding(BenchPhoto(dataset), true, 1, noProgress(), {});
    EXPECT_EQ(namesOf(rows),
              (std::set<std::string>{"decode.whole", "decode.region", "decode.reduced", "decode.thumbnail",
                                     "decode.whole.planes", "decode.region.planes"}));
    for (const BenchRow& row : rows) {
        EXPECT_EQ(row.peer.has_value(), row.name == "decode.whole" || row.name == "decode.region")
            << row.name;
        EXPECT_GT(row.bytes, 0U) << row.name;
        if (row.name == "decode.whole") {
            EXPECT_EQ(row.bytes, 512U * 256 * 3);
        }
    }
    const auto unmarked = test::withoutMarkers(*dataset);
    EXPECT_EQ(namesOf(measureDecoding(BenchPhoto(unmarked), true, 1, noProgress(), {})),
              (std::set<std::string>{"decode.whole", "decode.thumbnail"}));
}

TEST_F(Phases, RegionAheadHoldsEveryPixelOfTheView) {
    test::Random random(7);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 20; ++i) {
        const int width = 512 << random.integer(0, 3);
        const EquirectSize size{width, width / 2};
        const CameraModel camera = standardCamera(random.uniform(10, 120));
        const jpeg::PixelRect region = regionAhead(camera, size);
        const render::Projection projection(camera, lookingTo(0, 0), {}, size, render::SceneKind::None, 1);
        for (int j = 0; j < 500; ++j) {
            const auto pixel =
                *projection.photoPixel({random.uniform(-0.5, 639.5), random.uniform(-0.5, 479.5)});
            EXPECT_GE(pixel.x(), region.x);
            EXPECT_LE(pixel.x(), region.x + region.width - 1);
            EXPECT_GE(pixel.y(), region.y);
            EXPECT_LE(pixel.y(), region.y + region.height - 1);
        }
        EXPECT_LE(region.x + region.width, size.width);
        EXPECT_LE(region.y + region.height, size.height);
        EXPECT_LT(region.width, size.width);
    }
}

TEST_F(Phases, ColdCellsAreComparedWithWholeDecoding) {
    for (const int views : {2, 7}) { // more than there are photos
        const ColdCells cells = measureColdCells(dataset, views, noProgress(), {});
        EXPECT_EQ(namesOf(cells.rows),
                  (std::set<std::string>{"cold_cell", "cold_cell.unverified", "cold_cell.disk"}));
        for (const BenchRow& row : cells.rows) {
            EXPECT_EQ(row.peer->name, kWholeAndRender);
            EXPECT_EQ(row.threads, hardwareThreads());
            EXPECT_GT(row.parts->decodeMs, 0);
        }
    }
    const test::TemporaryFolder other;
    test::MadeDataset one;
    one.places = {{0, 0, 0}};
    EXPECT_EQ(measureColdCells(test::openMadeDataset(other.path(), one), 2, noProgress(), {}).rows.size(),
              3U);
}

TEST_F(Phases, FidelityRanksTheRungs) {
    // The photo has eight times as many pixels as the view: footprints are right, nearest pixels are not.
    const test::TemporaryFolder other;
    test::MadeDataset made;
    made.places = {{0, 0, 0}};
    made.width = 4096;
    const BenchPhoto photo(test::openMadeDataset(other.path(), made));
    const std::vector<RungFidelity> rungs = measureFidelity(photo, 120, {2, 16}, noProgress(), {});
    ASSERT_EQ(rungs.size(), kRungs.size());
    const auto of = [&](render::Sampling rung) {
        return *std::find_if(rungs.begin(), rungs.end(),
                             [&](const RungFidelity& row) { return row.rung == rung; });
    };
    EXPECT_GT(of(render::Sampling::Footprint).meanDb, of(render::Sampling::Bilinear).meanDb + 3);
    EXPECT_GT(of(render::Sampling::Bilinear).meanDb, of(render::Sampling::Nearest).meanDb);
    EXPECT_GT(of(render::Sampling::Footprint).worstDb, 40);
    for (const RungFidelity& row : rungs) {
        EXPECT_LE(row.worstDb, row.meanDb);
        EXPECT_EQ(row.fieldDeg, 120);
    }
}

TEST_F(Phases, PsnrIsThatOfTheDefinition) {
    RgbImage picture(5, 3);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{101});
    EXPECT_NEAR(psnrDb(std::vector<Eigen::Vector3d>(15, {100, 100, 100}), picture, 1), 48.13, 0.01);
    EXPECT_EQ(psnrDb(std::vector<Eigen::Vector3d>(15, {101, 101, 101}), picture, 1), 100);
    // Every second pixel along each axis: (0 2 4) x (0 2).
    picture.at(1, 0)[0] = 0;
    picture.at(4, 1)[0] = 0;
    EXPECT_EQ(psnrDb(std::vector<Eigen::Vector3d>(6, {101, 101, 101}), picture, 2), 100);
    picture.at(4, 2)[0] = 0;
    EXPECT_LT(psnrDb(std::vector<Eigen::Vector3d>(6, {101, 101, 101}), picture, 2), 30);
}

TEST_F(Phases, WalksHaveARowForEachSpeedAndPolicy) {
    EXPECT_NEAR(StationPath(serpentine(dataset->info())).lengthM(), 1, 1e-9);
    const std::vector<WalkRow> rows = measureWalks(dataset, {{1, 30}, 3}, noProgress(), {});
    std::set<std::string> kinds;
    for (const WalkRow& row : rows) {
        kinds.insert(std::to_string(row.speedMS) + std::string(name(row.policy)) +
                     (row.prefetch ? "+" : "-"));
        EXPECT_EQ(row.views, 3);
        EXPECT_GE(row.lateShare, 0);
        EXPECT_LE(row.lateShare, 1);
        EXPECT_GE(row.missedShare, 0);
        EXPECT_LE(row.missedShare, 1);
        EXPECT_GT(row.p99Ms, 0);
    }
    EXPECT_EQ(rows.size(), 8U);
    EXPECT_EQ(kinds.size(), 8U);
    EXPECT_TRUE(rows.front().prefetch);
}

TEST_F(Phases, LooksAtEachPhotoOrAtSoMany) {
    EXPECT_EQ(lookAllRound(dataset, 100, noProgress(), {}), 3U);
    EXPECT_EQ(lookAllRound(dataset, 2, noProgress(), {}), 2U);
}

TEST_F(Phases, PhotoRowHoldsCopiesAndIsRemoved) {
    std::filesystem::path where;
    {
        const PhotoRow row(*dataset, 5, noProgress(), {});
        where = row.dataset()->folder();
        const auto& photos = row.dataset()->info().photos;
        ASSERT_EQ(photos.size(), 5U);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(row.dataset()->readPhoto(i), dataset->readPhoto(0));
            EXPECT_NEAR(photos[i].roomFromPhoto.translation.x(), 0.2 * static_cast<double>(i), 1e-12);
        }
        EXPECT_EQ(row.dataset()->nearestPhoto({0.62, 0, 1.2}), 3U);
        EXPECT_NEAR(StationPath(serpentine(row.dataset()->info())).lengthM(), 0.8, 1e-9);
    }
    EXPECT_FALSE(std::filesystem::exists(where));
}

TEST_F(Phases, PhotoRowSaysWhereItCannotBe) {
    const char* before = std::getenv("TMPDIR");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("TMPDIR", (folder / "0.jpg").c_str(), 1); // a file
    expectError(ErrorKind::Io, "TMPDIR", [&] { PhotoRow(*dataset, 2, noProgress(), {}); });
    kept.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1);
}

TEST_F(Phases, FilesAreDroppedFromTheCacheOrItIsSaid) {
    const auto file = folder / "cached";
    writeFile(file, Bytes(100'000, 7));
    dropFromFileCache(file); // what the answer is depends on the file system
    EXPECT_EQ(readFile(file), Bytes(100'000, 7));
    expectError(ErrorKind::NotFound, "none", [&] { dropFromFileCache(folder / "none"); });
}

TEST_F(Phases, RowsOfViewsAreNamedByTheirSetting) {
    EXPECT_EQ(viewRowName(render::Sampling::Bilinear, {90, 0}), "view.bilinear");
    EXPECT_EQ(viewRowName(render::Sampling::Bilinear, {57, 0}), "view.bilinear.57");
    EXPECT_EQ(viewRowName(render::Sampling::Footprint, {90, 80}), "view.footprint.steep");
    EXPECT_EQ(viewRowName(render::Sampling::Bicubic, {57, -80}), "view.bicubic.57.steep");
}

TEST_F(Phases, ThePhotoIsTheFirstAndItsRendererHoldsAllOfIt) {
    const BenchPhoto photo(dataset);
    EXPECT_EQ(photo.entry().file, dataset->info().photos.front().file);
    EXPECT_EQ(photo.jpeg(), dataset->readPhoto(0));
    EXPECT_EQ(photo.picture().width(), 512);
    EXPECT_EQ(photo.scene(), render::SceneKind::Sphere);
    // Looking straight ahead in the photo's frame is looking along the photo's x axis in the room.
    const Eigen::Vector3d ahead = photo.roomFromCamera(lookingTo(0, 0)).rotation * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d expected = photo.entry().roomFromPhoto.rotation * Eigen::Vector3d::UnitX();
    EXPECT_LT((ahead - expected).norm(), 1e-12);
    const Eigen::Vector3d up = lookingTo(0, 90).rotation * Eigen::Vector3d::UnitZ();
    EXPECT_LT((up - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
    const Eigen::Vector3d left = lookingTo(90, 0).rotation * Eigen::Vector3d::UnitZ();
    EXPECT_LT((left - Eigen::Vector3d::UnitY()).norm(), 1e-9);
}

TEST_F(Phases, AllStopWhenAsked) {
    const BenchPhoto photo(dataset);
    const std::stop_token stop = test::stopped();
    const auto expectStop = [](auto&& phase) { expectError(ErrorKind::Stopped, "Stopped", phase); };
    expectStop([&] { thisMachine(stop); });
    expectStop([&] { measureViews(photo, {90, 0}, true, 1, noProgress(), stop); });
    expectStop([&] { measureDecoding(photo, true, 1, noProgress(), stop); });
    expectStop([&] { measureColdCells(dataset, 1, noProgress(), stop); });
    expectStop([&] { measureFidelity(photo, 90, {1, 1}, noProgress(), stop); });
    expectStop([&] { measureWalks(dataset, {{1}, 1}, noProgress(), stop); });
    expectStop([&] { lookAllRound(dataset, 1, noProgress(), stop); });
    expectStop([&] { PhotoRow(*dataset, 2, noProgress(), stop); });
}

TEST(Machine, SaysWhatItIs) {
    const Machine machine = thisMachine({});
    EXPECT_NE(machine.processor, "");
    EXPECT_NE(machine.simd, "");
    EXPECT_NE(machine.compiler, "");
    EXPECT_EQ(machine.threads, hardwareThreads());
    EXPECT_GT(machine.twoThreadGain, 0);
}

TEST(Machine, PeakOfMemoryGrowsWithWhatIsUsed) {
    const std::uint64_t before = peakResidentBytes();
    EXPECT_GT(before, 1U << 20);
    const std::vector<char> used(before + (64 << 20), 1); // beyond all that was used so far
    EXPECT_GE(peakResidentBytes(), before + (60 << 20)) << used.size();
}

} // namespace spherewalk::bench
