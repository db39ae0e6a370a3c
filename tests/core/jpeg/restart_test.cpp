// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"
#include "random.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/restart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace spherewalk {
namespace {

using Size = std::pair<int, int>;

/// All APPn and COM segments, one after the other.
Bytes applicationBytes(ByteView jpeg) {
    Bytes bytes;
    for (const jpeg::Segment& segment : jpeg::segments(jpeg, "a.jpg")) {
        if ((segment.marker >= jpeg::kApp0 && segment.marker <= jpeg::kApp15) ||
            segment.marker == jpeg::kCom) {
            const ByteView whole = segment.whole(jpeg);
            bytes.insert(bytes.end(), whole.begin(), whole.end());
        }
    }
    return bytes;
}

/// A JPEG of one row of MCUs with the header of the whole and the entropy-coded data of interval i.
Bytes intervalAlone(ByteView jpeg, const jpeg::RestartIndex& index, std::size_t i, int mcus) {
    Bytes alone{0xFF, jpeg::kSoi};
    for (const jpeg::Segment& segment : jpeg::segments(jpeg, "a.jpg")) {
        const ByteView whole = segment.whole(jpeg);
        alone.insert(alone.end(), whole.begin(), whole.end());
        if (segment.marker == jpeg::kSof0) {
            const int width = mcus * index.mcuWidth;
            std::uint8_t* content = &alone[alone.size() - whole.size() + 4];
            content[1] = 0;
            content[2] = static_cast<std::uint8_t>(index.mcuHeight);
            content[3] = static_cast<std::uint8_t>(width >> 8);
            content[4] = static_cast<std::uint8_t>(width);
        }
    }
    const std::size_t end = i + 1 < index.offsets.size() ? index.offsets[i + 1] : jpeg.size();
    const ByteView data = jpeg.subspan(index.offsets[i], end - 2 - index.offsets[i]);
    alone.insert(alone.end(), data.begin(), data.end());
    alone.insert(alone.end(), {0xFF, jpeg::kEoi});
    return alone;
}

/// Compares MCU `from` of the one-row picture with MCU `to` of the whole one, but for a margin where chroma
/// upsampling looks at neighbours that the one does not have.
void expectSameMcu(const RgbImage& alone, int from, const RgbImage& whole, int to,
                   const jpeg::RestartIndex& index, int margin) {
    const int perRow = (whole.width() + index.mcuWidth - 1) / index.mcuWidth;
    const int left = to % perRow * index.mcuWidth;
    const int top = to / perRow * index.mcuHeight;
    for (int y = margin; y < std::min(index.mcuHeight, whole.height() - top) - margin; ++y) {
        for (int x = margin; x < std::min(index.mcuWidth, whole.width() - left) - margin; ++x) {
            const auto* expected = whole.at(left + x, top + y);
            const auto* got = alone.at(from * index.mcuWidth + x, y);
            ASSERT_TRUE(std::equal(expected, expected + 3, got)) << "MCU " << to << " at " << x << ", " << y;
        }
    }
}

class RestartMarkers : public testing::TestWithParam<std::tuple<test::JpegForm, Size, int>> {
  protected:
    void SetUp() override {
        const auto& [form, size, interval] = GetParam();
        original = test::madeJpeg(test::madePicture(size.first, size.second), form);
        marked = jpeg::withRestartMarkers(original, interval, "a.jpg");
    }

    Bytes original;
    Bytes marked;
};

TEST_P(RestartMarkers, KeepEveryPixelAndEveryApplicationSegment) {
    EXPECT_EQ(jpeg::decode(marked, "marked"), jpeg::decode(original, "original"));
    EXPECT_EQ(applicationBytes(marked), applicationBytes(original));
    const jpeg::Info info = jpeg::readInfo(marked, "marked");
    EXPECT_EQ(info.restartInterval, std::get<2>(GetParam()));
    EXPECT_FALSE(info.progressive);
}

TEST_P(RestartMarkers, AreIndexedWhereTheyStand) {
    const jpeg::RestartIndex index = jpeg::indexRestarts(marked, "marked");
    const jpeg::Info info = jpeg::readInfo(marked, "marked");
    EXPECT_EQ(index.width, info.width);
    EXPECT_EQ(index.height, info.height);
    EXPECT_EQ(index.mcuWidth, info.mcuWidth);
    EXPECT_EQ(index.mcuHeight, info.mcuHeight);
    EXPECT_EQ(index.mcusPerInterval, info.restartInterval);
    EXPECT_EQ(index.fileSizeBytes, marked.size());
    const jpeg::Segment scan = jpeg::segments(marked, "marked").back();
    EXPECT_EQ(index.offsets.front(), scan.offset + scan.size);
    for (std::size_t i = 1; i < index.offsets.size(); ++i) {
        EXPECT_EQ(marked[index.offsets[i] - 2], 0xFF);
        EXPECT_EQ(marked[index.offsets[i] - 1], jpeg::kRst0 + (i - 1) % 8);
    }
}

TEST_P(RestartMarkers, MakeEveryIntervalDecodableByItself) {
    const jpeg::RestartIndex index = jpeg::indexRestarts(marked, "marked");
    const RgbImage whole = jpeg::decode(marked, "marked");
    const int perRow = (index.width + index.mcuWidth - 1) / index.mcuWidth;
    const int total = perRow * ((index.height + index.mcuHeight - 1) / index.mcuHeight);
    const int margin = index.mcuWidth > 8 || index.mcuHeight > 8 ? 1 : 0;
    for (std::size_t i = 0; i < index.offsets.size(); ++i) {
        const int first = static_cast<int>(i) * index.mcusPerInterval;
        const int mcus = std::min(index.mcusPerInterval, total - first);
        const RgbImage alone = jpeg::decode(intervalAlone(marked, index, i, mcus), "interval");
        for (int mcu = 0; mcu < mcus && !HasFatalFailure(); ++mcu) {
            expectSameMcu(alone, mcu, whole, first + mcu, index, margin);
        }
    }
}

TEST_P(RestartMarkers, IndexSurvivesBeingWritten) {
    const jpeg::RestartIndex index = jpeg::indexRestarts(marked, "marked");
    EXPECT_EQ(jpeg::parseRestartIndex(jpeg::serialised(index), "index"), index);
}

std::string restartCaseName(const testing::TestParamInfo<RestartMarkers::ParamType>& which) {
    const auto& [form, size, interval] = which.param;
    return text(form.name, "_", size.first, "x", size.second, "_", interval);
}

INSTANTIATE_TEST_SUITE_P(
    Forms, RestartMarkers,
    testing::Combine(testing::Values(test::JpegForm{.name = "f420"},
                                     test::JpegForm{.name = "f422", .vertical = 1},
                                     test::JpegForm{.name = "f444", .horizontal = 1, .vertical = 1},
                                     test::JpegForm{.name = "grey", .isGrey = true},
                                     test::JpegForm{.name = "progressive", .isProgressive = true},
                                     test::JpegForm{.name = "scans", .hasScanPerColour = true},
                                     test::JpegForm{.name = "bare", .hasJfif = false},
                                     test::JpegForm{.name = "marked", .restartInterval = 7}),
                     testing::Values(Size{1, 1}, Size{17, 9}, Size{333, 77}), testing::Values(1, 4, 65535)),
    restartCaseName);

TEST(RestartMarking, KeepLargeAndManyApplicationSegmentsInOrder) {
    test::Random random(5);
    std::vector<Bytes> contents(4);
    for (std::size_t i = 0; i < contents.size(); ++i) {
        contents[i].resize(i == 1 ? 65533 : i * 1000);
        for (std::uint8_t& byte : contents[i]) {
            byte = static_cast<std::uint8_t>(random.integer(0, 255));
        }
    }
    Bytes original = test::madeJpeg(test::madePicture(64, 32), {.applications = contents});
    // Ahead of JFIF: an Adobe segment, a comment, and a second APP0, which libjpeg knows and might repeat.
    const Bytes front{0xFF, 0xEE, 0, 14, 'A', 'd',  'o', 'b',  'e',  0, 100, 0,   0,   0,   0,   1,
                      0xFF, 0xFE, 0, 5,  'a', 0xFF, 'b', 0xFF, 0xE0, 0, 7,   'J', 'F', 'X', 'X', 0};
    original.insert(original.begin() + 2, front.begin(), front.end());
    const Bytes marked = jpeg::withRestartMarkers(original, 2, "a.jpg");
    const Bytes kept = applicationBytes(marked);
    EXPECT_EQ(kept, applicationBytes(original));
    EXPECT_TRUE(std::equal(front.begin(), front.end(), kept.begin()));
    EXPECT_EQ(jpeg::decode(marked, "marked"), jpeg::decode(original, "original"));
}

TEST(RestartMarking, TakeAnIntervalOfOneTo65535) {
    const Bytes jpeg = jpeg::encode(test::madePicture(16, 16), 90);
    for (const int interval : {-1, 0, 65536}) {
        test::expectError(ErrorKind::InvalidInput, "every",
                          [&] { jpeg::withRestartMarkers(jpeg, interval, "a.jpg"); });
    }
}

TEST(RestartIndex, NeedsMarkersOfOneBaselineScan) {
    const RgbImage picture = test::madePicture(64, 32);
    const auto refused = [&](const std::string& part, const test::JpegForm& form) {
        test::expectError(ErrorKind::Unsupported, part,
                          [&] { jpeg::indexRestarts(test::madeJpeg(picture, form), "a.jpg"); });
    };
    refused("it has none", {});
    refused("not a baseline", {.isProgressive = true, .restartInterval = 2});
    refused("separate scans", {.hasScanPerColour = true, .restartInterval = 2});
}

TEST(RestartIndex, RefusesMarkersMissingSwappedOrInExcess) {
    const Bytes jpeg = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(128, 64), 90), 2, "a.jpg");
    const jpeg::RestartIndex index = jpeg::indexRestarts(jpeg, "a.jpg");
    const auto refused = [](const std::string& part, const Bytes& bytes) {
        test::expectError(ErrorKind::Corrupt, part, [&] { jpeg::indexRestarts(bytes, "a.jpg"); });
    };
    Bytes swapped = jpeg;
    std::swap(swapped[index.offsets[3] - 1], swapped[index.offsets[4] - 1]);
    refused("out of order", swapped);

    const auto at = [](Bytes& bytes, std::size_t offset) {
        return bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    };
    Bytes missing = jpeg;
    missing.erase(at(missing, index.offsets.back() - 2), at(missing, index.offsets.back()));
    refused("instead of", missing);

    Bytes excess = jpeg;
    const auto next = static_cast<std::uint8_t>(jpeg::kRst0 + (index.offsets.size() - 1) % 8);
    excess.insert(at(excess, excess.size() - 2), {0xFF, next, 0x12});
    refused("out of order", excess);

    Bytes cut(jpeg.begin(), jpeg.end() - 2);
    refused("ends within", cut);
}

class RestartIndexFile : public testing::Test {
  protected:
    jpeg::RestartIndex index = jpeg::indexRestarts(
        jpeg::withRestartMarkers(jpeg::encode(test::madePicture(90, 50), 90), 3, "a"), "a");
    Bytes bytes = jpeg::serialised(index);

    static void expectRefused(const Bytes& damaged, const std::string& part = "Could not read") {
        test::expectError(ErrorKind::Corrupt, part, [&] { jpeg::parseRestartIndex(damaged, "a.idx"); });
    }
};

TEST_F(RestartIndexFile, HasTheBytesThatItsFormatNames) {
    EXPECT_EQ(textOf(ByteView(bytes).first(4)), "SWRI");
    EXPECT_EQ(bytes[4], 1);
    EXPECT_EQ(bytes[5], 0);
    EXPECT_EQ(bytes[10], 90);
    EXPECT_EQ(bytes.size(), 34 + 4 * index.offsets.size());
    EXPECT_EQ(bytes[34] | bytes[35] << 8, static_cast<int>(index.offsets[0]));
}

TEST_F(RestartIndexFile, EveryTruncationAndExcessIsRefused) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        expectRefused(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    }
    Bytes longer = bytes;
    longer.push_back(0);
    expectRefused(longer);
}

TEST_F(RestartIndexFile, AnotherVersionIsNamed) {
    bytes[4] = 99;
    expectRefused(bytes, "version is 99");
}

TEST_F(RestartIndexFile, HostileSizesAreRefusedBeforeAnythingIsReserved) {
    for (std::size_t field = 6; field < 34; ++field) {
        Bytes damaged = bytes;
        damaged[field] = 0xFF;
        if (field >= 22 && field < 30) {
            continue; // a larger file size contradicts nothing in the index
        }
        SCOPED_TRACE(field);
        expectRefused(damaged);
    }
    Bytes small = bytes;
    std::fill(small.begin() + 22, small.begin() + 30, std::uint8_t{0});
    expectRefused(small, "do not ascend");
}

TEST_F(RestartIndexFile, OffsetsThatDoNotAscendAreRefused) {
    Bytes swapped = bytes;
    std::swap_ranges(swapped.begin() + 34, swapped.begin() + 38, swapped.begin() + 38);
    expectRefused(swapped, "do not ascend");
    Bytes beyond = bytes;
    beyond.back() = 0xFF;
    expectRefused(beyond, "do not ascend");
}

TEST_F(RestartIndexFile, RandomBytesAreReadOrRefused) {
    test::Random random(77);
    SCOPED_TRACE(random.seed());
    int refused = 0;
    for (int round = 0; round < 5000; ++round) {
        Bytes damaged = bytes;
        for (int i = random.integer(1, 3); i > 0; --i) {
            damaged[static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1))] =
                static_cast<std::uint8_t>(random.integer(0, 255));
        }
        try {
            // What is accepted can be written again, and is the same then.
            EXPECT_EQ(jpeg::serialised(jpeg::parseRestartIndex(damaged, "a.idx")), damaged);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Corrupt);
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST_F(RestartIndexFile, AnIndexThatContradictsItselfIsNotWritten) {
    index.offsets.pop_back();
    test::expectError(ErrorKind::InvalidInput, "contradicts", [&] { jpeg::serialised(index); });
}

} // namespace
} // namespace spherewalk
