// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::render {

namespace {

DepthMap sloped() {
    Image<float, 1> inverse(32, 16);
    MaskImage sure(32, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            *inverse.at(x, y) = 0.01F + 0.03F * static_cast<float>(x + y);
            *sure.at(x, y) = (x + y) % 3 == 0 ? 255 : 0;
        }
    }
    return DepthMap(std::move(inverse), std::move(sure));
}

} // namespace

TEST(DepthMap, ReadsBackWhatItWrote) {
    const DepthMap map = sloped();
    const DepthMap again = DepthMap::parse(map.serialised(), "d.pgm");
    EXPECT_EQ(again.inverseM(), map.inverseM());
    EXPECT_EQ(again.sure(), map.sure());
}

TEST(DepthMap, KeepsDistancesFromFiveCentimetresToAHundredMetres) {
    Image<float, 1> inverse(16, 8);
    *inverse.at(0, 0) = 1 / 0.05F;
    *inverse.at(1, 0) = 1 / 100.0F;
    const DepthMap map(std::move(inverse));
    EXPECT_NEAR(1 / *map.inverseM().at(0, 0), 0.05, 1e-3);
    EXPECT_NEAR(1 / *map.inverseM().at(1, 0), 100, 4);
}

TEST(DepthMap, RefusesWhatIsNoNumber) {
    Image<float, 1> inverse(16, 8);
    *inverse.at(3, 3) = NAN;
    test::expectError(ErrorKind::InvalidInput, "no numbers", [&] { DepthMap{inverse}; });
}

TEST(DepthMap, RefusesFilesCutShort) {
    Bytes bytes = sloped().serialised();
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, bytes.size() - 1}) {
        const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        test::expectError(ErrorKind::Corrupt, "d.pgm", [&] { DepthMap::parse(cut, "d.pgm"); });
    }
}

} // namespace spherewalk::render
