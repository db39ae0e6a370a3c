// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "noise_photo.h"
#include "temporary_folder.h"

#include "spherewalk/align/photo_matching.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace spherewalk::align {

using test::expectError;

namespace {

/// Remembers what it was told, and asks for a stop at a fraction.
class Watcher : public ProgressSink {
  public:
    void progress(double fraction, std::string_view /*activity*/) override {
        isMonotone = isMonotone && fraction >= last;
        last = fraction;
        if (fraction >= stopAt) {
            source.request_stop();
        }
    }

    void warning(std::string_view sentence) override { warnings.emplace_back(sentence); }

    double last = 0;
    bool isMonotone = true;
    double stopAt = 2;
    std::stop_source source;
    std::vector<std::string> warnings;
};

class PhotoMatching : public testing::Test {
  protected:
    PhotoMatching() {
        for (int i = 0; i < 4; ++i) {
            const Eigen::Quaterniond turned(
                Eigen::AngleAxisd(i * std::numbers::pi / 3, Eigen::Vector3d::UnitZ()));
            const std::filesystem::path file = folder / ("R" + std::to_string(i) + ".JPG");
            writeFile(file, jpeg::encode(test::noisePhoto(turned, 512), 92));
            photos.push_back({file, file.filename().string(), {}});
        }
        options.features.width = 512;
        options.features.most = 300;
        options.threads = 2;
    }

    test::TemporaryFolder folder;
    std::vector<PhotoFile> photos;
    FindOptions options;
    Watcher watcher;
    std::stop_token stop = watcher.source.get_token();
};

} // namespace

TEST_F(PhotoMatching, GivesTheSameForAnyNumberOfThreads) {
    const FoundFeatures byTwo = findFeatures(photos, options, watcher, stop);
    options.threads = 1;
    EXPECT_EQ(findFeatures(photos, options, noProgress(), stop).photos, byTwo.photos);
    EXPECT_TRUE(watcher.isMonotone);
    EXPECT_DOUBLE_EQ(watcher.last, 1);
    EXPECT_EQ(byTwo.fromCache, 0);
    EXPECT_GT(byTwo.photos[0].count(), 100);
}

TEST_F(PhotoMatching, FindsPairsInTheirOrder) {
    const FoundFeatures found = findFeatures(photos, options, watcher, stop);
    const std::vector<std::pair<int, int>> pairs = {{1, 2}, {0, 3}};
    const auto matched = matchPairs(found.photos, pairs, {}, 2, noProgress(), stop);
    ASSERT_EQ(matched.size(), 2U);
    EXPECT_EQ(matched[0].a, 1);
    EXPECT_EQ(matched[0].b, 2);
    EXPECT_EQ(matched[1].a, 0);
    EXPECT_EQ(matched[1].b, 3);
    EXPECT_GT(matched[0].matches.size(), 50U);
    expectError(ErrorKind::InvalidInput, "before the second",
                [&] { matchPairs(found.photos, std::vector{std::pair(2, 1)}, {}, 2, noProgress(), stop); });
    expectError(ErrorKind::InvalidInput, "of 4",
                [&] { matchPairs(found.photos, std::vector{std::pair(0, 4)}, {}, 2, noProgress(), stop); });
}

TEST_F(PhotoMatching, GoesOnWhereItWasStopped) {
    options.cacheFolder = folder / "align-cache";
    options.threads = 1;
    watcher.stopAt = 0.5;
    expectError(ErrorKind::Stopped, "", [&] { findFeatures(photos, options, watcher, stop); });
    const FoundFeatures resumed = findFeatures(photos, options, noProgress(), {});
    EXPECT_EQ(resumed.fromCache, 2);
    options.cacheFolder.clear();
    EXPECT_EQ(findFeatures(photos, options, noProgress(), {}).photos, resumed.photos);
}

TEST_F(PhotoMatching, LeavesOutPhotosThatCannotBeRead) {
    writeFile(photos[1].file, bytesOf("no picture"));
    std::filesystem::remove(photos[2].file);
    const FoundFeatures found = findFeatures(photos, options, watcher, stop);
    EXPECT_THAT(found.unreadable, testing::ElementsAre(1, 2));
    EXPECT_EQ(watcher.warnings.size(), 2U);
    EXPECT_EQ(found.photos[1].count(), 0);
    EXPECT_GT(found.photos[3].count(), 100);
}

TEST_F(PhotoMatching, WarnsOnceOfACacheThatCannotBeWritten) {
    writeFile(folder / "file", bytesOf("in the way"));
    options.cacheFolder = folder / "file";
    const FoundFeatures found = findFeatures(photos, options, watcher, stop);
    EXPECT_EQ(watcher.warnings.size(), 1U);
    EXPECT_GT(found.photos[3].count(), 100);
}

} // namespace spherewalk::align
