// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"
#include "random.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace spherewalk {
namespace {

using jpeg::PixelRect;
using jpeg::RegionDecoder;
using Size = std::pair<int, int>;

RegionDecoder decoderOf(const Bytes& marked) {
    return {std::make_shared<MemorySource>(marked, "a.jpg"), jpeg::indexRestarts(marked, "a.jpg")};
}

RgbImage cutOut(const RgbImage& whole, const PixelRect& region) {
    RgbImage part(region.width, region.height);
    for (int y = 0; y < region.height; ++y) {
        const auto* row = whole.at(region.x, region.y + y);
        std::copy(row, row + 3 * region.width, part.at(0, y));
    }
    return part;
}

PixelRect randomRegion(test::Random& random, int width, int height) {
    PixelRect region;
    region.x = random.integer(0, width - 1);
    region.y = random.integer(0, height - 1);
    // Half of the regions are small, so that their edges fall everywhere within an MCU.
    const bool isSmall = random.integer(0, 1) == 0;
    region.width = random.integer(1, std::min(width - region.x, isSmall ? 40 : width));
    region.height = random.integer(1, std::min(height - region.y, isSmall ? 40 : height));
    return region;
}

std::string nameOf(const PixelRect& region) {
    return text(region.width, " x ", region.height, " at ", region.x, ", ", region.y);
}

class Region : public testing::TestWithParam<std::tuple<test::JpegForm, Size, int>> {
  protected:
    Region() {
        const auto& [form, size, interval] = GetParam();
        marked = jpeg::withRestartMarkers(test::madeJpeg(test::madePicture(size.first, size.second), form),
                                          interval, "a.jpg");
    }

    Bytes marked;
};

TEST_P(Region, HasTheBytesOfAFullDecodeAtEveryReduction) {
    const RegionDecoder decoder = decoderOf(marked);
    test::Random random(3);
    for (const int denominator : {1, 2, 4, 8}) {
        const RgbImage whole = jpeg::decode(marked, "a.jpg", denominator);
        ASSERT_EQ(decoder.width(denominator), whole.width());
        ASSERT_EQ(decoder.height(denominator), whole.height());
        for (int round = 0; round < 40; ++round) {
            const PixelRect region = round == 0 ? PixelRect{0, 0, whole.width(), whole.height()}
                                                : randomRegion(random, whole.width(), whole.height());
            jpeg::RegionOptions options;
            options.denominator = denominator;
            options.threads = 1 + round % 3;
            ASSERT_EQ(decoder.decode(region, options), cutOut(whole, region))
                << nameOf(region) << " of 1/" << denominator << ", seed " << random.seed();
        }
    }
}

std::string caseName(const testing::TestParamInfo<Region::ParamType>& which) {
    const auto& [form, size, interval] = which.param;
    return text(form.name, "_", size.first, "x", size.second, "_", interval);
}

// 256 pixels are 16 MCUs of 4:2:0: intervals of 1, 4 and 16 divide its rows, 5, 24 and 32 do not.
INSTANTIATE_TEST_SUITE_P(
    Forms, Region,
    testing::Combine(testing::Values(test::JpegForm{.name = "f420"},
                                     test::JpegForm{.name = "f422", .vertical = 1},
                                     test::JpegForm{.name = "f440", .horizontal = 1, .vertical = 2},
                                     test::JpegForm{.name = "f411", .horizontal = 4, .vertical = 1},
                                     test::JpegForm{.name = "f410", .horizontal = 4, .vertical = 2},
                                     test::JpegForm{.name = "f444", .horizontal = 1, .vertical = 1},
                                     test::JpegForm{.name = "grey", .isGrey = true}),
                     testing::Values(Size{256, 128}, Size{253, 101}, Size{1, 1}, Size{3, 40}, Size{40, 3},
                                     Size{18, 70}, Size{35, 33}),
                     testing::Values(1, 4, 5, 16, 24, 32, 65535)),
    caseName);

TEST(RegionDecoder, GivesEachRowOnce) {
    const Bytes marked = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(200, 90), 90), 4, "a.jpg");
    const RgbImage whole = jpeg::decode(marked, "a.jpg");
    const PixelRect region{33, 21, 101, 50};
    jpeg::RegionOptions options;
    options.threads = 3;
    std::vector<int> seen(50);
    decoderOf(marked).decode(region, options, [&](int y, const std::uint8_t* pixels) {
        ++seen[static_cast<std::size_t>(y - region.y)];
        EXPECT_TRUE(std::equal(pixels, pixels + 3 * region.width, whole.at(region.x, y)));
    });
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
}

TEST(RegionDecoder, PlanesOfAPartAreThoseOfTheWhole) {
    test::Random random(8);
    for (const test::JpegForm& form :
         {test::JpegForm{}, test::JpegForm{.vertical = 1}, test::JpegForm{.isGrey = true}}) {
        const Bytes marked =
            jpeg::withRestartMarkers(test::madeJpeg(test::madePicture(203, 91), form), 4, "a.jpg");
        const RegionDecoder decoder = decoderOf(marked);
        const jpeg::Planes whole = decoder.decodePlanes({0, 0, 203, 91});
        for (int round = 0; round < 60; ++round) {
            const PixelRect region = randomRegion(random, 203, 91);
            const jpeg::Planes part = decoder.decodePlanes(region, 1 + round % 3);
            const int left = region.x / whole.horizontal;
            const int top = region.y / whole.vertical;
            const auto expectSame = [](const jpeg::Planes::Plane& small, const jpeg::Planes::Plane& large,
                                       int x, int y) {
                for (int row = 0; row < small.height(); ++row) {
                    ASSERT_TRUE(std::equal(small.row(row).begin(), small.row(row).end(),
                                           large.row(y + row).begin() + x));
                }
            };
            expectSame(part.luma, whole.luma, left * whole.horizontal, top * whole.vertical);
            expectSame(part.blue, whole.blue, left, top);
            expectSame(part.red, whole.red, left, top);
            ASSERT_GE(part.luma.width(), region.width);
            ASSERT_GE(part.luma.height(), region.height);
        }
    }
}

TEST(RegionDecoder, ReadsOnlyWhatTheRegionTouches) {
    const Bytes marked = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(1024, 512), 90), 8, "a.jpg");
    const RegionDecoder decoder = decoderOf(marked);
    jpeg::RegionOptions options;
    // Two intervals wide, with one neighbour for upsampling; three MCU rows with one above and one below.
    const jpeg::RegionCost cost = decoder.decode({0, 64, 256, 48}, options, [](int, const std::uint8_t*) {});
    EXPECT_EQ(cost.intervals, 3U * 5U);
    EXPECT_LT(cost.bytesRead, marked.size() / 10);
    EXPECT_EQ(decoder.decode({300, 70, 20, 20}, options, [](int, const std::uint8_t*) {}).intervals, 2U);
}

TEST(RegionDecoder, IgnoresWhatFollowsThePicture) {
    Bytes marked = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(64, 64), 90), 2, "a.jpg");
    const RgbImage whole = jpeg::decode(marked, "a.jpg");
    marked.insert(marked.end(), 5000, 0xA5);
    EXPECT_EQ(decoderOf(marked).decode({0, 0, 64, 64}), whole);
}

TEST(RegionDecoder, RefusesRegionsOutsideThePicture) {
    const Bytes marked = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(64, 32), 90), 2, "a.jpg");
    const RegionDecoder decoder = decoderOf(marked);
    for (const PixelRect& region :
         {PixelRect{0, 0, 0, 1}, PixelRect{-1, 0, 5, 5}, PixelRect{60, 0, 5, 5}, PixelRect{0, 30, 5, 3},
          PixelRect{5, 5, 2147483647, 1}, PixelRect{2147483647, 0, 1, 1}}) {
        test::expectError(ErrorKind::InvalidInput, "not within", [&] { decoder.decode(region); });
        test::expectError(ErrorKind::InvalidInput, "not within", [&] { decoder.decodePlanes(region); });
    }
    jpeg::RegionOptions options;
    options.denominator = 3;
    test::expectError(ErrorKind::InvalidInput, "not by 3", [&] { decoder.decode({0, 0, 1, 1}, options); });
}

TEST(RegionDecoder, StopsWhenAsked) {
    const Bytes marked = jpeg::withRestartMarkers(jpeg::encode(test::madePicture(64, 32), 90), 2, "a.jpg");
    std::stop_source stop;
    stop.request_stop();
    jpeg::RegionOptions options;
    options.stop = stop.get_token();
    test::expectError(ErrorKind::Stopped, "", [&] { decoderOf(marked).decode({0, 0, 64, 32}, options); });
}

TEST(DividingInterval, DividesTheRowOrIsTheRow) {
    EXPECT_EQ(jpeg::dividingInterval(5376, 16, 8), 8);
    EXPECT_EQ(jpeg::dividingInterval(6720, 16, 8), 7);   // 420 MCUs
    EXPECT_EQ(jpeg::dividingInterval(5296, 16, 8), 331); // a prime
    for (int width = 1; width < 3000; width += 7) {
        const int columns = (width + 15) / 16;
        const int interval = jpeg::dividingInterval(width, 16, 8);
        EXPECT_EQ(columns % interval, 0) << width;
        EXPECT_TRUE(interval == columns || (interval >= 4 && interval <= 16)) << width;
    }
}

} // namespace
} // namespace spherewalk
