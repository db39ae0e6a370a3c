// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/region.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace spherewalk {
namespace {

using jpeg::RegionDecoder;

/// A marked picture, its index, and what it looks like.
class DamagedRegion : public testing::Test {
  protected:
    static RegionDecoder opened(const Bytes& bytes, const jpeg::RestartIndex& with) {
        return {std::make_shared<MemorySource>(bytes, "flip.jpg"), with};
    }

    static void expectCorrupt(const Bytes& bytes, const jpeg::RestartIndex& with) {
        test::expectError(ErrorKind::Corrupt, "flip.jpg", [&] {
            opened(bytes, with).decode({0, 0, with.width, with.height});
        });
    }

    /// True if it decodes; false if it is refused in a way that names the file.
    static bool decodes(const Bytes& bytes, const jpeg::RestartIndex& with, const jpeg::PixelRect& region) {
        try {
            const RegionDecoder decoder = opened(bytes, with);
            decoder.decode(region);
            decoder.decodePlanes(region);
            return true;
        } catch (const Error& error) {
            EXPECT_TRUE(error.kind() == ErrorKind::Corrupt || error.kind() == ErrorKind::Unsupported)
                << error.sentence();
            EXPECT_NE(error.sentence().find("flip.jpg"), std::string::npos) << error.sentence();
            return false;
        }
    }

    Bytes good = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(160, 64), 90), 2, "a.jpg");
    jpeg::RestartIndex index = jpeg::indexRestarts(good, "a.jpg");
};

TEST_F(DamagedRegion, AnIndexOfAnotherFileIsCorrupt) {
    jpeg::RestartIndex other = index;
    other.width -= 1;
    expectCorrupt(good, other);
    other = index;
    other.mcuHeight = 8;
    expectCorrupt(good, other);
    other = index;
    other.fileSizeBytes += 1;
    expectCorrupt(good, other);
    other = index;
    other.offsets.front() -= 1;
    expectCorrupt(good, other);
    other = index;
    other.offsets.pop_back();
    expectCorrupt(good, other);
    other = index;
    other.offsets.back() = 0xFFFFFFFF;
    expectCorrupt(good, other);
    expectCorrupt(good, {});
    Bytes shorter(good.begin(), good.end() - 1);
    expectCorrupt(shorter, index);
}

TEST_F(DamagedRegion, AnOffsetThatIsNotBehindAMarkerIsCorrupt) {
    for (std::size_t i = 1; i < index.offsets.size(); ++i) {
        jpeg::RestartIndex moved = index;
        moved.offsets[i] += 1;
        expectCorrupt(good, moved);
    }
}

TEST_F(DamagedRegion, AnEmptiedIntervalIsCorrupt) {
    for (std::size_t i = 0; i + 1 < index.offsets.size(); ++i) {
        Bytes damaged = good;
        std::fill(damaged.begin() + index.offsets[i], damaged.begin() + index.offsets[i + 1] - 2,
                  std::uint8_t{0xFF});
        expectCorrupt(damaged, index);
    }
}

TEST_F(DamagedRegion, OneDamagedIntervalLeavesTheOthersReadable) {
    Bytes damaged = good;
    std::fill(damaged.begin() + index.offsets[0], damaged.begin() + index.offsets[1] - 2, std::uint8_t{0xFF});
    EXPECT_FALSE(decodes(damaged, index, {0, 0, 8, 8}));
    const RgbImage whole = jpeg::decode(good, "a.jpg");
    const RgbImage part = opened(damaged, index).decode({80, 32, 80, 32});
    EXPECT_TRUE(std::equal(part.row(3).begin(), part.row(3).end(), whole.row(35).begin() + 3 * 80));
}

TEST_F(DamagedRegion, RandomDamageToFileAndIndexNeverCrashes) {
    test::Random random(20261121);
    SCOPED_TRACE(random.seed());
    const Bytes goodIndex = jpeg::serialised(index);
    int decoded = 0;
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
        Bytes file = good;
        Bytes indexBytes = goodIndex;
        Bytes& damaged = round % 3 == 0 ? indexBytes : file;
        for (int i = random.integer(1, 4); i > 0; --i) {
            const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(damaged.size()) - 1));
            damaged[at] = static_cast<std::uint8_t>(random.integer(0, 255));
        }
        jpeg::RestartIndex read;
        try {
            read = jpeg::parseRestartIndex(indexBytes, "flip.jpg.idx");
        } catch (const Error&) {
            continue;
        }
        (decodes(file, read, {random.integer(0, 100), random.integer(0, 40), 60, 24}) ? decoded : refused) +=
            1;
    }
    EXPECT_GT(decoded, 100);
    EXPECT_GT(refused, 100);
}

TEST_F(DamagedRegion, AFileThatIsCutWhileOpenIsCorrupt) {
    const test::TemporaryFolder folder;
    const auto file = folder / "flip.jpg";
    writeFile(file, good);
    const RegionDecoder decoder(std::make_shared<FileSource>(file), index);
    EXPECT_EQ(decoder.decode({0, 0, 160, 64}), jpeg::decode(good, "a.jpg"));
    std::filesystem::resize_file(file, good.size() / 2);
    test::expectError(ErrorKind::Corrupt, "flip.jpg", [&] { decoder.decode({0, 0, 160, 64}); });
}

TEST(ByteSources, ReadTheRangeAskedForOrRefuse) {
    const test::TemporaryFolder folder;
    const Bytes bytes{1, 2, 3, 4, 5};
    writeFile(folder / "a", bytes);
    const FileSource file(folder / "a");
    const MemorySource memory(bytes, "a");
    for (const ByteSource* source :
         {static_cast<const ByteSource*>(&file), static_cast<const ByteSource*>(&memory)}) {
        Bytes two(2);
        source->read(3, two);
        EXPECT_EQ(two, (Bytes{4, 5}));
        EXPECT_EQ(source->sizeBytes(), 5U);
        test::expectError(ErrorKind::Corrupt, "ends too early", [&] { source->read(4, two); });
        test::expectError(ErrorKind::Corrupt, "ends too early", [&] { source->read(UINT64_MAX, two); });
    }
    test::expectError(ErrorKind::NotFound, "missing", [&] { FileSource(folder / "missing"); });
    test::expectError(ErrorKind::InvalidInput, "not a file", [&] { FileSource{folder.path()}; });
}

} // namespace
} // namespace spherewalk
