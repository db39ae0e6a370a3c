// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "pixels/photo_plane.h"
#include "random.h"

namespace spherewalk::render {

namespace {

RgbImage noise(int width, unsigned seed) {
    test::Random random(seed);
    RgbImage picture(width, width / 2);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

/// What the sphere shows at (x, y), beyond the picture's edges too.
const std::uint8_t* onSphere(const RgbImage& picture, int x, int y) {
    if (y < 0 || y >= picture.height()) {
        y = y < 0 ? -1 - y : 2 * picture.height() - 1 - y;
        x += picture.width() / 2;
    }
    return picture.at((x + picture.width()) % picture.width(), y);
}

void expectSphere(const PhotoPlane& plane, const RgbImage& picture) {
    constexpr int kGuard = PlaneLayout::kGuard;
    for (int y = -kGuard; y < picture.height() + kGuard; ++y) {
        for (int x = -kGuard; x < picture.width() + kGuard; ++x) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(plane.view().stored(x, y, c) + 128, onSphere(picture, x, y)[c]) << x << " " << y;
            }
        }
    }
}

} // namespace

TEST(PhotoPlane, GoesOnAcrossSeamAndPoles) {
    for (const int width : {16, 18, 64, 130}) {
        const RgbImage picture = noise(width, 61);
        expectSphere(PhotoPlane(picture), picture);
    }
}

TEST(PhotoPlane, IsTheSameWrittenInAnyPieces) {
    test::Random random(62);
    const RgbImage picture = noise(64, 63);
    PhotoPlane plane(EquirectSize{64, 32});
    for (int y = 31; y >= 0; --y) {
        for (int x = 0; x < 64;) {
            const int count = std::min(random.integer(1, 40), 64 - x);
            plane.write(x, y, {picture.at(x, y), static_cast<std::size_t>(3 * count)});
            x += count;
        }
    }
    expectSphere(plane, picture);
}

TEST(PhotoPlane, RefusesWhatIsNoPanorama) {
    for (const EquirectSize& size :
         {EquirectSize{0, 0}, EquirectSize{14, 7}, EquirectSize{64, 33}, EquirectSize{16386, 8193}}) {
        test::expectError(ErrorKind::Unsupported, "twice as wide as high", [&] { PhotoPlane{size}; });
    }
}

} // namespace spherewalk::render
