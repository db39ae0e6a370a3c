// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/align/feature_cache.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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

TEST(FeatureCache, KeepsThatAPhotoHasNoFeatures) {
    const test::TemporaryFolder folder;
    const FeatureCache cache(folder.path(), {});
    cache.keep(kPhoto, {});
    ASSERT_TRUE(cache.find(kPhoto));
    EXPECT_EQ(cache.find(kPhoto)->count(), 0);
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
    options.isUpright = true;
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

} // namespace spherewalk::align
