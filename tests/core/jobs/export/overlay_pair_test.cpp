// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <spng.h>

namespace spherewalk {

namespace {

const std::filesystem::path kPair = std::filesystem::path(SPHEREWALK_TEST_DATA) / "flat-a" / "overlay";

RgbaImage colours(const std::string& name) {
    const Bytes png = readFile(kPair / (name + ".png"));
    const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(0), spng_ctx_free);
    spng_ihdr header{};
    spng_set_png_buffer(context.get(), png.data(), png.size());
    EXPECT_EQ(spng_get_ihdr(context.get(), &header), SPNG_OK) << name;
    RgbaImage picture(static_cast<int>(header.width), static_cast<int>(header.height));
    const std::span<std::uint8_t> values = picture.values();
    EXPECT_EQ(spng_decode_image(context.get(), values.data(), values.size_bytes(), SPNG_FMT_RGBA8, 0),
              SPNG_OK)
        << name;
    return picture;
}

/// 0 stays 0.
DepthImage depth(const std::string& name) {
    const Image<std::uint16_t, 1> millimetres = photo::readPng16(kPair / (name + ".png"));
    DepthImage result(millimetres.width(), millimetres.height());
    std::transform(millimetres.values().begin(), millimetres.values().end(), result.values().begin(),
                   [](std::uint16_t value) { return static_cast<float>(value) / 1000; });
    return result;
}

} // namespace

// Colour, depth and truth that another program made, with its own conventions: tests/data/flat-a/README.md.
TEST(OverlayPair, AnotherRenderersObjectIsShownWhereItIsVisible) {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, Radians(Degrees(57)).value());
    camera.width = 98;
    camera.height = 203;
    camera.cx -= 273;
    camera.cy -= 97;
    const render::Overlay overlay{colours("object_rgba"), render::Alpha::Straight, depth("object_depth"),
                                  camera, depth("scene_depth")};
    const RgbImage without = photo::readPicture(kPair / "without.png");
    const RgbImage with = photo::readPicture(kPair / "with.png");
    const RgbImage visible = photo::readPicture(kPair / "truth_mask.png");
    RgbImage picture = without;
    MaskImage shown;
    WorkerPool pool;
    render::Composer().compose({&overlay, 1}, CameraModel(camera), {}, {}, pool, picture, &shown);
    std::filesystem::create_directories(SPHEREWALK_TEST_PICTURES);
    photo::writePng(std::filesystem::path(SPHEREWALK_TEST_PICTURES) / "pair.png", picture);

    int objects = 0;
    int right = 0;
    int rim = 0;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const int alpha = overlay.picture.at(x, y)[3];
            const bool isObject = *overlay.depth.at(x, y) > 0;
            objects += isObject ? 1 : 0;
            right += isObject && (*shown.at(x, y) >= 128) == (visible.at(x, y)[0] >= 128) ? 1 : 0;
            // All of it is in front of the room, so its antialiased border is as it was, also where the
            // centres of pixels miss it; but for the faintest, which is more than a pixel from any depth.
            rim += alpha > 0 && !isObject ? 1 : 0;
            EXPECT_NEAR(*shown.at(x, y), alpha, 8) << x << ", " << y;
        }
    }
    RecordProperty("right", text(static_cast<double>(right) / objects));
    EXPECT_GT(objects, 5000);
    EXPECT_GT(rim, 300);
    EXPECT_GE(right, 0.999 * objects);
    EXPECT_GT(photo::psnr(picture, with), photo::psnr(without, with) + 5);
}

} // namespace spherewalk
