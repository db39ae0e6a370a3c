// SPDX-License-Identifier: Apache-2.0
#include "engine/tile_supply.h"
#include "expect_error.h"
#include "temporary_folder.h"
#include "test_dataset.h"
#include "tiles/photo_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::render {
namespace {

/// A dataset of three photos: 0 with restart markers and a thumbnail, 1 with markers, 2 with neither.
class Loading : public testing::Test {
  protected:
    Loading() {
        std::vector<Rigid3> poses(3);
        poses[1].translation.x() = 1;
        poses[2].translation.x() = 2;
        DatasetInfo info = test::writeTestDataset(folder.path(), poses, test::smoothWorld, 512);
        test::mark(folder.path(), info.photos[0]);
        test::mark(folder.path(), info.photos[1]);
        test::addThumbnail(folder.path(), info.photos[0]);
        test::rewriteInfo(folder.path(), info);
        dataset = std::make_shared<const Dataset>(Dataset::open(folder.path()));
    }

    /// Changes one byte of the photo's picture, past the first view's part of it.
    void damage(std::size_t photo) {
        const auto file = folder / dataset->info().photos[photo].file;
        Bytes bytes = readFile(file);
        bytes[bytes.size() - 40] ^= 0x10;
        writeFile(file, bytes);
    }

    TileSet tile(int i) const {
        TileSet set(grid);
        set.insert(i);
        return set;
    }

    test::TemporaryFolder folder;
    std::shared_ptr<const Dataset> dataset;
    TileGrid grid{{512, 256}};
};

TEST_F(Loading, GivesTheBytesOfAWholeDecodeWithAndWithoutMarkers) {
    TileStore store(std::make_shared<PhotoFiles>(dataset, VerifyPhotos::BeforeUse), 100 << 20);
    for (const std::size_t photo : {0, 1, 2}) {
        const RgbImage whole = jpeg::decode(dataset->readPhoto(photo), "a");
        for (const int i : {5, 0, 15, 6}) {
            const TileLease lease = store.acquire({photo}, tile(i), TileStore::Missing::Decode);
            const PhotoPlane expected(whole);
            const jpeg::PixelRect own = grid.pixels(i);
            for (int y = own.y; y < own.y + own.height; ++y) {
                for (int x = own.x; x < own.x + own.width; ++x) {
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_EQ(lease.plane().stored(x, y, c), expected.view().stored(x, y, c))
                            << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST_F(Loading, VerifiesBeforeUseWhenAskedTo) {
    damage(0);
    PhotoFiles photos(dataset, VerifyPhotos::BeforeUse);
    for (int round = 0; round < 2; ++round) {
        test::expectError(ErrorKind::Corrupt, "was changed after the export",
                          [&] { photos.decodesParts(0); });
    }
    EXPECT_EQ(photos.hash(0), PhotoHash::Damaged);
    EXPECT_TRUE(photos.decodesParts(1));
    EXPECT_EQ(photos.hash(1), PhotoHash::Verified);
}

TEST_F(Loading, VerifiesInBackgroundAndRefusesWhatItServedBefore) {
    damage(0);
    const auto photos = std::make_shared<PhotoFiles>(dataset, VerifyPhotos::InBackground);
    TileStore store(photos, 100 << 20);
    EXPECT_FALSE(photos->verifyNext({}));
    store.acquire({0}, tile(0), TileStore::Missing::Decode);
    store.acquire({1}, tile(0), TileStore::Missing::Decode);
    EXPECT_EQ(photos->hash(0), PhotoHash::Unverified);
    EXPECT_TRUE(photos->verifyNext({}));
    EXPECT_TRUE(photos->verifyNext({}));
    EXPECT_FALSE(photos->verifyNext({}));
    EXPECT_EQ(photos->hash(0), PhotoHash::Damaged);
    EXPECT_EQ(photos->hash(1), PhotoHash::Verified);
    test::expectError(ErrorKind::Corrupt, "was changed after the export",
                      [&] { store.acquire({0}, tile(0), TileStore::Missing::Decode); });
    std::stop_source stop;
    stop.request_stop();
    store.acquire({2}, tile(0), TileStore::Missing::Decode);
    test::expectError(ErrorKind::Stopped, "", [&] { photos->verifyNext(stop.get_token()); });
    EXPECT_EQ(photos->hash(2), PhotoHash::Unverified);
}

TEST_F(Loading, RefusesAnIndexOrAFileThatIsAnothers) {
    std::filesystem::copy_file(folder / dataset->info().photos[1].file,
                               folder / dataset->info().photos[0].file,
                               std::filesystem::copy_options::overwrite_existing);
    PhotoFiles photos(dataset, VerifyPhotos::InBackground);
    // Both have the same picture here, so only the index of photo 1 is damaged.
    writeFile(folder / dataset->info().photos[1].restartIndex, bytesOf("SWRI nonsense"));
    test::expectError(ErrorKind::Corrupt, "restart index", [&] { photos.decodesParts(1); });
    writeFile(folder / dataset->info().photos[2].file, bytesOf("short"));
    test::expectError(ErrorKind::Corrupt, "was changed", [&] { photos.decodesParts(2); });
}

class Policies : public Loading {
  protected:
    TileSet all = TileSet::all(grid);
    TileStore store{std::make_shared<PhotoFiles>(dataset, VerifyPhotos::AtOpen), 100 << 20};
    LateViews loader{store, std::make_shared<Thumbnails>(dataset)};
    LateViews::NeedOf needOf = [this](std::size_t photo) { return TileNeed{{photo}, tile(3)}; };
};

TEST_F(Policies, WaitGivesTheTilesAndSaysHowLong) {
    const Served late = loader.serve({{0}, all}, LatePolicy::Wait, needOf);
    EXPECT_EQ(late.origin, ViewOrigin::Photo);
    EXPECT_TRUE(late.isLate);
    EXPECT_GT(late.lease.waitedMs(), 0);
    const Served there = loader.serve({{0}, all}, LatePolicy::Wait, needOf);
    EXPECT_FALSE(there.isLate);
    EXPECT_EQ(loader.counters().waited, 1U);
    EXPECT_EQ(loader.counters().views, 2U);
}

TEST_F(Policies, CoarseGivesTheThumbnailUntilTheTilesAreThere) {
    const Served late = loader.serve({{0}, all}, LatePolicy::Coarse, needOf);
    EXPECT_EQ(late.origin, ViewOrigin::Thumbnail);
    ASSERT_TRUE(late.coarse);
    EXPECT_EQ(late.coarse->view().size().width, 64);
    EXPECT_TRUE(late.isLate);
    store.prefetch({0}, all, {});
    EXPECT_EQ(loader.serve({{0}, all}, LatePolicy::Coarse, needOf).origin, ViewOrigin::Photo);
    EXPECT_EQ(loader.counters().coarse, 1U);
    EXPECT_EQ(loader.counters().late, 1U);
}

TEST_F(Policies, CoarseWithoutAThumbnailWaits) {
    const Served late = loader.serve({{1}, all}, LatePolicy::Coarse, needOf);
    EXPECT_EQ(late.origin, ViewOrigin::Photo);
    EXPECT_TRUE(late.isLate);
    EXPECT_TRUE(late.lease.isComplete());
}

TEST_F(Policies, PreviousGivesThePhotoBeforeWhereItsTilesAreThere) {
    loader.serve({{1}, all}, LatePolicy::Wait, needOf);
    const Served late = loader.serve({{0}, all}, LatePolicy::Previous, needOf);
    EXPECT_EQ(late.origin, ViewOrigin::PreviousPhoto);
    EXPECT_EQ(late.photo, 1U);
    EXPECT_TRUE(late.lease.isComplete());
    EXPECT_TRUE(late.isLate);
    EXPECT_EQ(loader.counters().previous, 1U);
}

TEST_F(Policies, PreviousAtTheStartIsCoarse) {
    EXPECT_EQ(loader.serve({{0}, all}, LatePolicy::Previous, needOf).origin, ViewOrigin::Thumbnail);
}

} // namespace
} // namespace spherewalk::render
