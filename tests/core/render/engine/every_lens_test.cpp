// SPDX-License-Identifier: Apache-2.0
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// What a lens shows does not depend on the lens: the same room is seen as well through any.
namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kLensWidth = 640;
constexpr int kLensHeight = 480;
constexpr int kEvery = 13; // pixels are compared
const RoomShape kLensRoom{{{-2, -1.5}, {2.5, -1.5}, {2.5, 2}, {-2, 2}}, 0, 2.6};
const Vector3d kPhotoAt(0.1, 0.2, 1.3);

/// The colour of a point of the walls.
Vector3d colourAt(const Vector3d& p) {
    constexpr double kPerM = 2 * std::numbers::pi / 0.7;
    return {128 + 60 * std::sin(kPerM * p.x()) + 50 * std::sin(kPerM * p.z()),
            128 + 60 * std::sin(kPerM * p.y()) + 50 * std::cos(kPerM * p.z()),
            128 + 50 * std::cos(kPerM * p.x()) + 50 * std::sin(kPerM * (p.y() + p.z()))};
}

Vector3d seenFrom(const Vector3d& place, const Vector3d& direction) {
    return colourAt(place +
                    direction.normalized() / inverseDistance(kLensRoom, place, direction.normalized()));
}

/// One photo of the room with its exact depth.
class Room {
  public:
    /// told: what the dataset says of the lenses.
    explicit Room(const LensPair& lenses = {}, const LensPair& told = {}) {
        const auto world = [&](const Vector3d& direction) {
            return seenFrom(kPhotoAt + lenses.place(direction), direction);
        };
        DatasetInfo info = test::writeTestDataset(m_folder.path(),
                                                  {{Eigen::Quaterniond::Identity(), kPhotoAt}}, world, 2048);
        DatasetPhoto& photo = info.photos[0];
        photo.depth = "depth/0.pgm";
        std::filesystem::create_directories(m_folder.path() / "depth");
        photo.lenses = told;
        writeFile(m_folder.path() / photo.depth,
                  roomDepth(kLensRoom, photo.roomFromPhoto, 1024, lenses).serialised());
        info.roomShape = kLensRoom;
        test::rewriteInfo(m_folder.path(), info);
        m_renderer.emplace(std::make_shared<const Dataset>(Dataset::open(m_folder.path())));
    }

    View view(const CameraModel& camera, const Rigid3& pose, SceneKind scene) const {
        ViewOptions options;
        options.scene = scene;
        options.wantsDepth = true;
        return m_renderer->render(camera, pose, options);
    }

  private:
    test::TemporaryFolder m_folder;
    std::optional<Renderer> m_renderer;
};

/// The exact mean colour of a pixel; nothing where the lens does not see all of it.
std::optional<Vector3d> truth(const CameraModel& camera, const Rigid3& pose, int x, int y) {
    constexpr int kSamples = 3;
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const Vector2d within((i % kSamples + 0.5) / kSamples - 0.5, (i / kSamples + 0.5) / kSamples - 0.5);
        const auto ray = camera.ray(Vector2d(x, y) + within);
        if (!ray) {
            return std::nullopt;
        }
        sum += seenFrom(pose.translation, pose.rotation * *ray);
    }
    return sum / (kSamples * kSamples);
}

struct Likeness {
    double psnrDb = 0;
    double range95 = 0; ///< Relative error of the range that 95 of 100 pixels keep.
};

Likeness likeness(const Room& room, const CameraModel& camera, const Rigid3& pose, SceneKind scene) {
    const View view = room.view(camera, pose, scene);
    double squares = 0;
    int count = 0;
    std::vector<double> ranges;
    for (int y = 0; y < kLensHeight; y += kEvery) {
        for (int x = 0; x < kLensWidth; x += kEvery) {
            const auto expected = truth(camera, pose, x, y);
            if (!expected) {
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                squares += std::pow(view.picture.at(x, y)[c] - (*expected)[c], 2);
            }
            ++count;
            const Vector3d ray = *camera.ray(Vector2d(x, y));
            if (ray.z() > 0.02) {
                const double range = *view.depth.at(x, y) / ray.z();
                ranges.push_back(
                    std::abs(range * inverseDistance(kLensRoom, pose.translation, pose.rotation * ray) - 1));
            }
        }
    }
    const auto at = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() * 95 / 100);
    std::nth_element(ranges.begin(), at, ranges.end());
    return {10 * std::log10(255 * 255 * 3.0 * count / squares), *at};
}

CameraModel lens(LensModel model, double focalPx, std::vector<double> distortion) {
    return CameraModel({kLensWidth, kLensHeight, focalPx, focalPx, 0.5 * kLensWidth - 0.5,
                        0.5 * kLensHeight - 0.5, model, std::move(distortion)});
}

CameraModel pinhole(double fieldDeg) {
    return CameraModel(
        CameraIntrinsics::pinhole(kLensWidth, kLensHeight, Radians(Degrees(fieldDeg)).value()));
}

struct NamedLens {
    std::string name;
    CameraModel camera;
};

std::vector<NamedLens> lenses() {
    std::vector<NamedLens> all;
    const std::vector<std::pair<std::string, std::vector<double>>> fisheyes = {
        {"ideal", {0, 0, 0, 0}},
        {"T265", {-0.0062, 0.0445, -0.0420, 0.0081}},
        {"Kalibr", {-0.013, -0.02, 0.017, -0.0046}}};
    for (const double fieldDeg : {100.0, 140.0, 180.0, 220.0}) {
        for (const auto& [name, distortion] : fisheyes) {
            const double focal = 0.5 * kLensWidth / Radians(Degrees(fieldDeg / 2)).value();
            all.push_back({name + " fisheye of " + std::to_string(fieldDeg),
                           lens(LensModel::Equidistant, focal, distortion)});
        }
    }
    for (const double fieldDeg : {57.0, 120.0, 150.0, 160.0, 170.0, 175.0}) {
        all.push_back({"pinhole of " + std::to_string(fieldDeg), pinhole(fieldDeg)});
    }
    all.push_back({"tilted", lens(LensModel::RationalPolynomial, 340,
                                  {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03, 0.004, -0.002, 0.003, 0.001,
                                   0.05, -0.12})});
    return all;
}

class EveryLens : public testing::TestWithParam<SceneKind> {};

} // namespace

TEST_P(EveryLens, ShowsTheRoomAsWellAsAPinhole) {
    const Room room;
    const std::vector<NamedLens> cameras = lenses();
    const CameraModel common = pinhole(90);
    for (const double pitchDeg : {-90.0, 0.0, 45.0}) {
        const Rigid3 pose{
            (rotation({Radians(0.7), Radians(Degrees(pitchDeg)), Radians(0.1)}) * bodyFromOptical())
                .normalized(),
            kPhotoAt + Vector3d(0.25, -0.2, 0.1)};
        const Likeness expected = likeness(room, common, pose, GetParam());
        EXPECT_LT(expected.range95, 0.01) << "pitch " << pitchDeg;
        for (const NamedLens& of : cameras) {
            SCOPED_TRACE(of.name);
            const Likeness seen = likeness(room, of.camera, pose, GetParam());
            EXPECT_GT(seen.psnrDb, expected.psnrDb - 2) << "pitch " << pitchDeg;
            EXPECT_LT(seen.range95, 0.01) << "pitch " << pitchDeg;
        }
    }
}

TEST_P(EveryLens, ShowsTheRoomAsWellIfTheSphericalCameraHasTwoLenses) {
    const LensPair lenses{0.015};
    const Room plain;
    const Room room(lenses, lenses);
    const Room untold(lenses);
    const Rigid3 level{bodyFromOptical(), kPhotoAt + Vector3d(0.25, -0.2, 0.1)};
    const CameraModel fisheye = lens(LensModel::Equidistant, 300, {0, 0, 0, 0});
    for (const double yaw : {0.2, 1.4, 2.9, -1.6}) { // to the front, the seams and the back
        SCOPED_TRACE(yaw);
        const bool looksAtSeam = std::abs(std::cos(yaw)) < 0.5;
        const Rigid3 pose{(yawRotation(Radians(yaw)) * level.rotation).normalized(), level.translation};
        for (const CameraModel& camera : {pinhole(57), pinhole(90), fisheye}) {
            const Likeness expected = likeness(plain, camera, pose, GetParam());
            const Likeness seen = likeness(room, camera, pose, GetParam());
            // Neither lens sees the 3 cm between them, over which the surface goes on.
            EXPECT_GT(seen.psnrDb, looksAtSeam ? 44 : expected.psnrDb - 2);
            EXPECT_LT(seen.range95, 0.01);
            EXPECT_GT(seen.psnrDb, likeness(untold, camera, pose, GetParam()).psnrDb + 4);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryLens, testing::Values(SceneKind::Room, SceneKind::Depth),
                         [](const auto& scene) { return std::string(name(scene.param)); });

} // namespace spherewalk::render
