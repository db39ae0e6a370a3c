// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/exact_view.h"
#include "sphere/sphere_view.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const EquirectSize kPhoto{2048, 1024};
const Rigid3 kRoomFromPhoto{rotation({Degrees(25), Degrees(4), Degrees(-3)}), {2.1, 1.9, 1.2}};
constexpr double kRadiusM = 2;

/// Looks up by the pitch, and across the photo's seam.
Rigid3 acrossTheSeam(double pitchDeg, const Vector3d& offsetM) {
    return {kRoomFromPhoto.rotation * rotation({Degrees(180), Degrees(-pitchDeg), Degrees(0)}) *
                bodyFromOptical(),
            kRoomFromPhoto.translation + offsetM};
}

/// Mean of 8 x 8 samples a pixel, each where the exact projection says.
Image<float, 3> areaReference(const RgbImage& photo, const CameraModel& camera, const Rigid3& pose) {
    const Projection projection(camera, pose, kRoomFromPhoto, kPhoto, SceneKind::Sphere, kRadiusM);
    constexpr int kParts = 8;
    Image<float, 3> result(camera.width(), camera.height());
    parallelFor(camera.height(), 4, 0, [&](int begin, int end) {
        for (int i = begin * camera.width(); i < end * camera.width(); ++i) {
            Vector3d sum = Vector3d::Zero();
            for (int part = 0; part < kParts * kParts; ++part) {
                const Vector2d offset((part % kParts + 0.5) / kParts - 0.5,
                                      (part / kParts + 0.5) / kParts - 0.5);
                const Vector2d pixel(i % camera.width(), i / camera.width());
                sum += bilinear(photo, *projection.photoPixel(pixel + offset)) / (kParts * kParts);
            }
            for (int c = 0; c < 3; ++c) {
                result.at(i % camera.width(), i / camera.width())[c] = static_cast<float>(sum[c]);
            }
        }
    });
    return result;
}

/// Squared errors in one part of the pictures.
struct Errors {
    double squares = 0;
    int count = 0;
    double worst = 0;

    void add(double error) {
        squares += error * error;
        ++count;
        worst = std::max(worst, std::abs(error));
    }

    double rms() const { return std::sqrt(squares / count); }
};

} // namespace

// Looks at the seam from one pole to the other, at the photo's place and beside it, and leaves the pictures,
// with eight times the error below each, to be looked at.
TEST(PolesAndSeam, LookLikeTheRestAtEveryPitch) {
    const practice::PracticeRoom room;
    const RgbImage picture = room.spherical(kRoomFromPhoto, kPhoto);
    const PhotoPlane plane(picture);
    const CameraModel camera(CameraIntrinsics::pinhole(240, 240, std::numbers::pi / 2));
    WorkerPool pool;
    Workspace workspace;
    Errors special;
    Errors rest;
    std::vector<RgbImage> views;
    std::vector<RgbImage> errors;
    for (const double offsetM : {0.0, 0.14}) {
        for (int pitch = -90; pitch <= 90; pitch += 30) {
            const Rigid3 pose = acrossTheSeam(pitch, {offsetM, -offsetM, 0});
            const double ratio = minification(camera, kPhoto.width);
            RgbImage view;
            renderView(RayTable(camera, samplesPerAxis(Sampling::Footprint, ratio)), pose,
                       {plane.view(), kRoomFromPhoto, SceneKind::Sphere, kRadiusM}, Sampling::Footprint, pool,
                       0, workspace, view);
            const Image<float, 3> expected = areaReference(picture, camera, pose);
            const Projection projection(camera, pose, kRoomFromPhoto, kPhoto, SceneKind::Sphere, kRadiusM);
            RgbImage error(view.width(), view.height());
            for (int y = 0; y < view.height(); ++y) {
                for (int x = 0; x < view.width(); ++x) {
                    const Vector2d at = *projection.photoPixel(Vector2d(x, y));
                    const bool isSpecial =
                        at.x() < 3 || at.x() > kPhoto.width - 4 || at.y() < 12 || at.y() > kPhoto.height - 13;
                    for (int c = 0; c < 3; ++c) {
                        const double off = view.at(x, y)[c] - static_cast<double>(expected.at(x, y)[c]);
                        (isSpecial ? special : rest).add(off);
                        error.at(x, y)[c] = static_cast<std::uint8_t>(std::clamp(128 + 8 * off, 0.0, 255.0));
                    }
                }
            }
            views.push_back(std::move(view));
            errors.push_back(std::move(error));
        }
    }
    std::vector<RgbImage> sheet;
    for (std::size_t row = 0; row < 2; ++row) {
        const auto from = static_cast<std::ptrdiff_t>(7 * row);
        sheet.insert(sheet.end(), views.begin() + from, views.begin() + from + 7);
        sheet.insert(sheet.end(), errors.begin() + from, errors.begin() + from + 7);
    }
    const std::filesystem::path folder = SPHEREWALK_TEST_PICTURES;
    std::filesystem::create_directories(folder);
    photo::writePng(folder / "poles-and-seam.png", photo::contactSheet(sheet, 7, 240));
    std::printf(
        "  poles and seam: rms %.2f, worst %.1f of %d values; elsewhere: rms %.2f, worst %.1f grey levels; "
        "pictures in %s\n",
        special.rms(), special.worst, special.count, rest.rms(), rest.worst, folder.string().c_str());
    EXPECT_GT(special.count, 10000);
    EXPECT_LT(special.rms(), 1.25 * rest.rms());
    EXPECT_LT(special.worst, rest.worst);
    EXPECT_LT(rest.rms(), 2.3); // 41 dB
}

} // namespace spherewalk::render
