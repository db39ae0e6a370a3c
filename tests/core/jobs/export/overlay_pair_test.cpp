// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/overlay.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <cmath>
#include <filesystem>

namespace spherewalk {

namespace {

const std::filesystem::path kPair = std::filesystem::path(SPHEREWALK_TEST_DATA) / "flat-a" / "overlay";

/// As it stands in the file: 16 bits and alpha are kept.
cv::Mat stored(const std::string& name) {
    return cv::imread((kPair / (name + ".png")).string(), cv::IMREAD_UNCHANGED);
}

DepthImage depth(const std::string& name) {
    const cv::Mat millimetres = stored(name);
    DepthImage result(millimetres.cols, millimetres.rows);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) {
            *result.at(x, y) = static_cast<float>(millimetres.at<std::uint16_t>(y, x)) / 1000;
        }
    }
    return result;
}

RgbaImage colours(const std::string& name) {
    const cv::Mat bgra = stored(name);
    RgbaImage result(bgra.cols, bgra.rows);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) {
            const auto& from = bgra.at<cv::Vec4b>(y, x);
            std::uint8_t* to = result.at(x, y);
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            to[3] = from[3];
        }
    }
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
    const cv::Mat visible = stored("truth_mask");
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
            right += isObject && (*shown.at(x, y) >= 128) == (visible.at<std::uint8_t>(y, x) >= 128) ? 1 : 0;
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
