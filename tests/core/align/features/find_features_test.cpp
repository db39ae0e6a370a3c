// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made/noise_photo.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/align/find_features.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace spherewalk::align {

namespace {

const std::string kPhoto = sha256Hex(bytesOf("a photo"));

Features someFeatures(int count = 50) {
    test::Random random(1);
    Features features;
    features.descriptorBytes = 128;
    for (int i = 0; i < count; ++i) {
        features.bearings.push_back(random.direction().cast<float>());
        features.sigmasRad.push_back(0.001F);
        features.responses.push_back(static_cast<float>(i));
    }
    features.descriptors.resize(static_cast<std::size_t>(count) * 128, std::uint8_t{7});
    features.vertical = Vertical{Eigen::Vector3d(0.1, -0.2, 1).normalized(), 0.001};
    return features;
}

} // namespace

TEST(FeatureCache, GivesBackWhatItKept) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder / "align-cache", {});
    EXPECT_FALSE(cache.find(kPhoto));
    cache.keep(kPhoto, someFeatures());
    ASSERT_TRUE(cache.find(kPhoto));
    EXPECT_EQ(*cache.find(kPhoto), someFeatures());
}

TEST(FeatureCache, KeepsWhichFeaturesShowOneThing) {
    const test::TemporaryFolder folder;
    FeatureOptions options;
    options.isWide = true;
    const FeatureCache cache(folder.path(), options);
    Features features = someFeatures(4);
    features.firstOf = {0, 1, 0, 3};
    cache.keep(kPhoto, features);
    ASSERT_TRUE(cache.find(kPhoto));
    EXPECT_EQ(*cache.find(kPhoto), features);
    features.firstOf = {0, 2, 0, 3}; // The second cannot be the third's.
    cache.keep(kPhoto, features);
    EXPECT_FALSE(cache.find(kPhoto));
    EXPECT_FALSE(FeatureCache(folder.path(), {}).find(kPhoto));
}

TEST(FeatureCache, KeepsThatAPhotoHasNoFeatures) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    cache.keep(kPhoto, {});
    ASSERT_TRUE(cache.find(kPhoto));
    EXPECT_EQ(cache.find(kPhoto)->count(), 0);
    EXPECT_FALSE(cache.find(kPhoto)->vertical);
}

TEST(FeatureCache, TellsPhotosOptionsAndMasksApart) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    cache.keep(kPhoto, someFeatures());
    EXPECT_FALSE(cache.find(sha256Hex(bytesOf("another"))));
    FeatureOptions options;
    options.most = 1999;
    EXPECT_FALSE(FeatureCache(folder.path(), options).find(kPhoto));
    options = {};
    options.isWide = true;
    EXPECT_FALSE(FeatureCache(folder.path(), options).find(kPhoto));
    MaskImage mask(8, 4);
    EXPECT_FALSE(FeatureCache(folder.path(), {}, mask).find(kPhoto));
    EXPECT_TRUE(FeatureCache(folder.path(), {}).find(kPhoto));
}

TEST(FeatureCache, IgnoresAFileWithAnyByteChangedOrCut) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    cache.keep(kPhoto, someFeatures(3));
    const Bytes whole = readFile(cache.fileOf(kPhoto));
    for (std::size_t i = 0; i < whole.size(); i += 5) {
        Bytes damaged = whole;
        damaged[i] ^= 0x41;
        writeFile(cache.fileOf(kPhoto), damaged);
        EXPECT_FALSE(cache.find(kPhoto)) << "byte " << i;
        writeFile(cache.fileOf(kPhoto), ByteView(whole).first(i));
        EXPECT_FALSE(cache.find(kPhoto)) << "cut at " << i;
    }
}

/// Whole files with a right checksum, but made by someone else.
TEST(FeatureCache, IgnoresFeaturesThatCannotBe) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    Features wrong = someFeatures(3);
    wrong.bearings[1].x() = std::numeric_limits<float>::quiet_NaN();
    cache.keep(kPhoto, wrong);
    EXPECT_FALSE(cache.find(kPhoto));
    wrong = someFeatures(3);
    wrong.bearings[1] *= 2;
    cache.keep(kPhoto, wrong);
    EXPECT_FALSE(cache.find(kPhoto));
    wrong = someFeatures(3);
    wrong.sigmasRad[0] = 0;
    cache.keep(kPhoto, wrong);
    EXPECT_FALSE(cache.find(kPhoto));
    wrong = someFeatures(3);
    wrong.vertical->upInPhoto *= 2;
    cache.keep(kPhoto, wrong);
    EXPECT_FALSE(cache.find(kPhoto));
    cache.keep(kPhoto, someFeatures(FeatureOptions().most + 1));
    EXPECT_FALSE(cache.find(kPhoto));
}

TEST(FeatureCache, IgnoresAnotherPhotosFile) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    const std::string other = sha256Hex(bytesOf("another"));
    cache.keep(other, someFeatures());
    std::filesystem::rename(cache.fileOf(other), cache.fileOf(kPhoto));
    EXPECT_FALSE(cache.find(kPhoto));
}

/// Remembers what it was told, and asks for a stop at a fraction.
class StoppingSink : public ProgressSink {
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

class FindFeatures : public testing::Test {
  protected:
    FindFeatures() {
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
    StoppingSink watcher;
    std::stop_token stop = watcher.source.get_token();
};

TEST_F(FindFeatures, GivesTheSameForAnyNumberOfThreads) {
    const FoundFeatures byTwo = findFeatures(photos, options, watcher, stop);
    options.threads = 1;
    EXPECT_EQ(findFeatures(photos, options, noProgress(), stop).photos, byTwo.photos);
    EXPECT_TRUE(watcher.isMonotone);
    EXPECT_DOUBLE_EQ(watcher.last, 1);
    EXPECT_EQ(byTwo.fromCache, 0);
    EXPECT_GT(byTwo.photos[0].count(), 100);
}

TEST_F(FindFeatures, GoesOnWhereItWasStopped) {
    options.cacheFolder = folder / "align-cache";
    options.threads = 1;
    watcher.stopAt = 0.5;
    test::expectError(ErrorKind::Stopped, "", [&] { findFeatures(photos, options, watcher, stop); });
    const FoundFeatures resumed = findFeatures(photos, options, noProgress(), {});
    EXPECT_EQ(resumed.fromCache, 2);
    options.cacheFolder.clear();
    EXPECT_EQ(findFeatures(photos, options, noProgress(), {}).photos, resumed.photos);
}

TEST_F(FindFeatures, LeavesOutPhotosThatCannotBeRead) {
    writeFile(photos[1].file, bytesOf("no picture"));
    std::filesystem::remove(photos[2].file);
    const FoundFeatures found = findFeatures(photos, options, watcher, stop);
    EXPECT_THAT(found.unreadable, testing::ElementsAre(1, 2));
    EXPECT_EQ(watcher.warnings.size(), 2U);
    EXPECT_EQ(found.photos[1].count(), 0);
    EXPECT_GT(found.photos[3].count(), 100);
}

TEST_F(FindFeatures, WarnsOnceOfACacheThatCannotBeWritten) {
    writeFile(folder / "file", bytesOf("in the way"));
    options.cacheFolder = folder / "file";
    const FoundFeatures found = findFeatures(photos, options, watcher, stop);
    EXPECT_EQ(watcher.warnings.size(), 1U);
    EXPECT_GT(found.photos[3].count(), 100);
}

} // namespace spherewalk::align
