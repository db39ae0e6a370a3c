// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/simulator/raw_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace spherewalk::simulator {
namespace {

using test::expectError;
using testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

const CameraIntrinsics kCamera = CameraIntrinsics::pinhole(2, 2, 1.0);

RawPicture raw(std::string_view encoding, const Bytes& bytes, std::uint64_t step = 0) {
    return {2, 2, step, encoding, false, bytes};
}

/// A copy, since older versions of gmock do not look into spans.
template <class Picture>
auto valuesOf(const Picture& picture) {
    const auto values = picture.values();
    return std::vector(values.begin(), values.end());
}

TEST(RawPicture, ColoursOfAllOrdersAreRedGreenBlue) {
    const auto expected = ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
    EXPECT_THAT(valuesOf(colourOf(raw("rgb8", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), kCamera)), expected);
    EXPECT_THAT(valuesOf(colourOf(raw("bgr8", {3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}), kCamera)), expected);
    EXPECT_THAT(
        valuesOf(colourOf(raw("bgra8", {3, 2, 1, 0, 6, 5, 4, 0, 9, 8, 7, 0, 12, 11, 10, 0}), kCamera)),
        expected);
}

TEST(RawPicture, RowsMayBePadded) {
    EXPECT_THAT(valuesOf(labelsOf(raw("mono8", {1, 2, 99, 99, 3, 4}, 4), kCamera)), ElementsAre(1, 2, 3, 4));
}

TEST(RawPicture, DepthsAreMetres) {
    const std::array<float, 4> metres{0.5F, 2, std::numeric_limits<float>::infinity(), 8};
    Bytes bytes(16);
    std::memcpy(bytes.data(), metres.data(), 16);
    EXPECT_THAT(valuesOf(depthOf(raw("32FC1", bytes), kCamera)), ElementsAre(0.5F, 2, metres[2], 8));
    EXPECT_THAT(valuesOf(depthOf(raw("16UC1", {0xF4, 1, 0xD0, 7, 0, 0, 1, 0}), kCamera)),
                ElementsAre(0.5F, 2, 0, 0.001F));
}

TEST(RawPicture, OfLabelsInThreeBytesTheFirstIsTaken) {
    EXPECT_THAT(valuesOf(labelsOf(raw("rgb8", {7, 1, 1, 8, 1, 1, 9, 1, 1, 5, 1, 1}), kCamera)),
                ElementsAre(7, 8, 9, 5));
}

TEST(RawPicture, RefusesOtherSizesAndMissingBytes) {
    RawPicture huge = raw("rgb8", Bytes(12));
    huge.width = std::int64_t{1} << 40;
    expectError(ErrorKind::InvalidInput, "2 x 2", [&] { colourOf(huge, kCamera); });
    huge.width = -2;
    expectError(ErrorKind::InvalidInput, "-2 x 2", [&] { colourOf(huge, kCamera); });
    expectError(ErrorKind::InvalidInput, "11 bytes", [&] { colourOf(raw("rgb8", Bytes(11)), kCamera); });
    expectError(ErrorKind::InvalidInput, "0 bytes", [&] { depthOf(raw("32FC1", {}), kCamera); });
    expectError(ErrorKind::InvalidInput, "rows of 5", [&] { colourOf(raw("rgb8", Bytes(12), 5), kCamera); });
    expectError(ErrorKind::InvalidInput, "do not fit", [&] {
        colourOf(raw("rgb8", Bytes(12), std::numeric_limits<std::uint64_t>::max()), kCamera);
    });
}

TEST(RawPicture, RefusesEncodingsThatItDoesNotKnow) {
    expectError(ErrorKind::Unsupported, "rgb8, bgr8", [] { colourOf(raw("yuv422", Bytes(12)), kCamera); });
    expectError(ErrorKind::Unsupported, "32FC1, 16UC1", [] { depthOf(raw("rgb8", Bytes(12)), kCamera); });
    const Bytes bytes(16);
    RawPicture swapped = raw("32FC1", bytes);
    swapped.isBigEndian = true;
    expectError(ErrorKind::Unsupported, "highest bytes first", [&] { depthOf(swapped, kCamera); });
}

} // namespace
} // namespace spherewalk::simulator
