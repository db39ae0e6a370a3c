// SPDX-License-Identifier: GPL-3.0-or-later
// The example with MuJoCo, against what is known of balls and walls without it.
#include "../../core/jobs/parts/practice_dataset.h"
#include "object_camera.h"
#include "program.h"
#include "room_world.h"
#include "simulation.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/object_overlay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mujoco_example {

using spherewalk::CameraIntrinsics;
using spherewalk::CameraModel;
using spherewalk::DepthImage;
using spherewalk::Rigid3;

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(160, 120, 1.2));

spherewalk::render::DatasetInfo rectangle() {
    spherewalk::render::DatasetInfo info;
    info.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    info.ceilingM = 2.5;
    return info;
}

/// The robot in the middle of a room of 4 x 3 m, looking along x.
WorldOptions inTheMiddle() {
    WorldOptions options;
    options.startM = {2, 1.5};
    options.ballM = {3.2, 1.5, 0.25};
    return options;
}

Simulation simulated(const WorldOptions& options) {
    return Simulation(roomWorld(rectangle(), objectCamera(kCamera), options));
}

spherewalk::render::Overlay exactBall(const WorldOptions& options, const Rigid3& pose) {
    spherewalk::jobs::Ball ball;
    ball.centreM = options.ballM;
    ball.radiusM = options.ballRadiusM;
    return spherewalk::jobs::ballOverlay(ball, kCamera, pose);
}

std::size_t seen(const DepthImage& depth) {
    return static_cast<std::size_t>(
        std::ranges::count_if(depth.values(), [](float z) { return std::isfinite(z); }));
}

/// How much of the picture overlays cover when they are laid over the room, pixels.
int shown(const spherewalk::render::Overlay& overlay) {
    spherewalk::RgbImage picture(kCamera.width(), kCamera.height());
    spherewalk::MaskImage mask;
    spherewalk::WorkerPool pool(1);
    spherewalk::render::Composer().compose({&overlay, 1}, kCamera, {}, {}, pool, picture, &mask);
    return static_cast<int>(std::ranges::count(mask.values(), 255));
}

} // namespace

TEST(MujocoExample, RendersABallWhereItIsAndAsFarAwayAsItIs) {
    WorldOptions options = inTheMiddle();
    for (const double aside : {-0.4, 0.0, 0.5}) {
        options.ballM = {3.3, 1.5 + aside, 0.5 + aside};
        Simulation simulation = simulated(options);
        ObjectRenderer renderer(simulation, objectCamera(kCamera));
        const DepthImage depth = renderer.overlay(false).depth;
        const DepthImage exact = exactBall(options, simulation.roomFromCamera()).depth;
        int differ = 0;
        std::vector<double> errors; // MuJoCo's balls have facets, which lie deep at the rim
        for (std::size_t i = 0; i < depth.values().size(); ++i) {
            if (std::isfinite(depth.values()[i]) != std::isfinite(exact.values()[i])) {
                ++differ;
            } else if (std::isfinite(exact.values()[i])) {
                errors.push_back(std::abs(depth.values()[i] - exact.values()[i]));
            }
        }
        EXPECT_GT(seen(exact), 300U);
        EXPECT_LT(differ, 0.08 * static_cast<double>(seen(exact)));
        EXPECT_LT(spherewalk::median(errors), 0.005);
        EXPECT_LT(std::ranges::max(errors), 0.1);
    }
}

TEST(MujocoExample, ShowsObjectsBeforeWallsAndNotThoseBehind) {
    WorldOptions options = inTheMiddle();
    options.ballM = {3.3, 1.5, 0.8};
    const auto overlayOf = [&](bool wantsRoomDepth) {
        Simulation simulation = simulated(options);
        return ObjectRenderer(simulation, objectCamera(kCamera)).overlay(wantsRoomDepth);
    };
    const int inFront = shown(overlayOf(true));
    EXPECT_EQ(inFront, shown(overlayOf(false)));
    EXPECT_GT(inFront, 300);
    options.ballM.x() = 4; // half in the wall
    const int halfWay = shown(overlayOf(true));
    EXPECT_GT(halfWay, 50);
    EXPECT_LT(halfWay, shown(overlayOf(false)));
    options.ballM.x() = 4.5; // beyond it
    EXPECT_EQ(shown(overlayOf(true)), 0);
    EXPECT_GT(shown(overlayOf(false)), 100);
}

TEST(MujocoExample, HidesTheRoomFromTheCameraAndNotFromRays) {
    Simulation simulation = simulated(inTheMiddle());
    ObjectRenderer renderer(simulation, objectCamera(kCamera));
    const spherewalk::render::Overlay overlay = renderer.overlay(true);
    EXPECT_LT(seen(overlay.depth), overlay.depth.values().size() / 2); // the ball alone
    EXPECT_EQ(seen(overlay.roomDepth), overlay.roomDepth.values().size());
    const mjtNum from[] = {2, 2.5, 0.5};
    const mjtNum along[] = {1, 0, 0};
    int geom = -1;
    const mjtNum metres = mj_ray(&simulation.model(), &simulation.data(), from, along, nullptr, 1, -1, &geom);
    EXPECT_NEAR(metres, 2, 1e-6); // the wall at x = 4
    EXPECT_EQ(simulation.model().geom_group[geom], kRoomGroup);
}

// A window in the wall at y = 3 and a dim room.
TEST(MujocoExample, LightsTheBallFromTheWindowsSideAndDarkensTheGroundBehindIt) {
    spherewalk::render::LightProbe probe;
    probe.radiance = spherewalk::render::RadianceImage(64, 32);
    for (int v = 0; v < 32; ++v) {
        for (int u = 0; u < 64; ++u) {
            const Eigen::Vector3d towards = spherewalk::direction({64, 32}, Eigen::Vector2d(u, v));
            std::fill_n(probe.radiance.at(u, v), 3, towards.y() > 0.8 && towards.z() > 0.1 ? 4.0F : 0.1F);
        }
    }
    WorldOptions options = inTheMiddle();
    options.ballM.x() = 3.6;
    Simulation simulation = simulated(options);
    ObjectRenderer renderer(simulation, objectCamera(kCamera));
    EXPECT_TRUE(renderer.overlay(false).shadow.empty()); // in MuJoCo's own light
    renderer.light(probe);
    const spherewalk::render::Overlay overlay = renderer.overlay(false);
    const Rigid3 cameraFromRoom = simulation.roomFromCamera().inverse();
    const auto pixelOf = [&](const Eigen::Vector3d& pInRoom) {
        const auto at = kCamera.project(cameraFromRoom * pInRoom);
        return std::pair(static_cast<int>(std::lround(at->x())), static_cast<int>(std::lround(at->y())));
    };
    const auto brightness = [&](double aside) { // of the side towards the camera; stripes differ in red least
        const auto [x, y] = pixelOf(options.ballM + Eigen::Vector3d(-0.2, aside, 0));
        return static_cast<int>(overlay.picture.at(x, y)[0]);
    };
    EXPECT_GT(brightness(0.12), 1.3 * brightness(-0.12));
    const auto shadowAt = [&](double x, double y) {
        const auto [u, v] = pixelOf({x, y, 0});
        return *overlay.shadow.at(u, v);
    };
    EXPECT_LT(shadowAt(3.6, 1.1), 0.7);      // the window's light ends here
    EXPECT_GT(shadowAt(3.6, 1.95), 0.9);     // between ball and window
    EXPECT_EQ(*overlay.shadow.at(80, 2), 1); // a wall
}

TEST(MujocoExample, ABallLiesOnATableThatThePhotosShow) {
    WorldOptions options = inTheMiddle();
    options.tableM = 0.75;
    options.ballM.z() = 0.75 + options.ballRadiusM;
    Simulation simulation = simulated(options);
    simulation.drive(0, 0, 1);
    EXPECT_NEAR(simulation.roomFromBody("ball").translation.z(), 1, 0.01);
    ObjectRenderer renderer(simulation, objectCamera(kCamera));
    EXPECT_LT(seen(renderer.overlay(false).depth), kCamera.width() * kCamera.height() / 2); // no table in it
}

TEST(MujocoExample, AWallStopsTheRobot) {
    WorldOptions options = inTheMiddle();
    options.ballM = {0.5, 0.5, 0.25};
    Simulation simulation = simulated(options);
    simulation.drive(0.4, 0.4, 2);
    EXPECT_NEAR(simulation.roomFromRobot().translation.x(), 2.75, 0.1); // 2 s at 0.4 m/s, less the start
    EXPECT_FALSE(simulation.isBumping());
    simulation.drive(0.4, 0.4, 8);
    EXPECT_TRUE(simulation.isBumping());
    const double stoppedAt = simulation.roomFromRobot().translation.x();
    EXPECT_NEAR(stoppedAt, 3.8, 0.03); // its bumper has a radius of 20 cm
    simulation.drive(0.4, 0.4, 2);
    EXPECT_NEAR(simulation.roomFromRobot().translation.x(), stoppedAt, 0.01);
}

TEST(MujocoExample, ABumpingDriverStaysInTheRoomAndGoesOn) {
    WorldOptions options = inTheMiddle();
    options.ballM = {0.5, 0.5, 0.25};
    Simulation simulation = simulated(options);
    BumpingDriver driver;
    bool wentBack = false;
    while (simulation.timeS() < 20) {
        driver.drive(simulation);
        const Eigen::Vector3d at = simulation.roomFromRobot().translation;
        ASSERT_TRUE(at.x() > 0.15 && at.x() < 3.85 && at.y() > 0.15 && at.y() < 2.85) << at.transpose();
        wentBack = wentBack || (simulation.roomFromRobot().rotation * Eigen::Vector3d::UnitX()).x() < -0.1;
    }
    EXPECT_TRUE(wentBack);
}

TEST(MujocoExample, TheCameraLooksFromTheMastAheadAndDown) {
    Simulation simulation = simulated(inTheMiddle());
    simulation.drive(-0.2, 0.2, 1.5);
    const Rigid3 robot = simulation.roomFromRobot();
    const Rigid3 camera = simulation.roomFromCamera();
    EXPECT_TRUE(camera.translation.isApprox(robot * Eigen::Vector3d(0.1, 0, 1.2), 1e-9));
    const Eigen::Vector3d axis = robot.rotation.conjugate() * (camera.rotation * Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(axis.isApprox(Eigen::Vector3d(std::cos(0.25), 0, -std::sin(0.25)), 1e-9)) << axis.transpose();
    const Eigen::Vector3d right = robot.rotation.conjugate() * (camera.rotation * Eigen::Vector3d::UnitX());
    EXPECT_TRUE(right.isApprox(-Eigen::Vector3d::UnitY(), 1e-9)) << right.transpose();
    EXPECT_GT((robot.rotation * Eigen::Vector3d::UnitX()).y(), 0.3); // it turned left
}

TEST(MujocoExample, RendersForLensesThatMujocoDoesNotKnow) {
    CameraIntrinsics fisheye{160, 120, 100, 100, 82, 58, spherewalk::LensModel::Equidistant, {0, 0, 0, 0}};
    const CameraIntrinsics eyes = objectCamera(CameraModel(fisheye));
    const CameraModel eye(eyes);
    EXPECT_EQ(eyes.lens, spherewalk::LensModel::Pinhole);
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(159, 119)}) {
        const auto at = eye.project(*CameraModel(fisheye).ray(corner));
        ASSERT_TRUE(at);
        EXPECT_TRUE(at->x() > -0.5 && at->x() < 159.5 && at->y() > -0.5 && at->y() < 119.5)
            << at->transpose();
    }
}

TEST(MujocoExample, WritesTheSameFramesInEveryRunAtMujocosPoses) {
    const spherewalk::test::PracticeDataset dataset(2, false);
    const std::filesystem::path& folder = dataset.folder().path();
    spherewalk::writeFile(
        folder / "camera.yaml",
        spherewalk::bytesOf("image_width: 160\nimage_height: 120\n"
                            "camera_matrix: {data: [120, 0, 79.5, 0, 120, 59.5, 0, 0, 1]}\n"));
    for (const char* out : {"a", "b"}) {
        spherewalk::test::Program program({SPHEREWALK_MUJOCO, dataset.path(), folder / out, "--camera",
                                           folder / "camera.yaml", "--seconds", "1.5", "--start", "2", "1.8",
                                           "30"});
        ASSERT_EQ(program.wait(), 0) << program.errors();
        EXPECT_NE(program.output().find("Wrote 15 frames"), std::string::npos) << program.output();
    }
    for (const auto& file : std::filesystem::directory_iterator(folder / "a")) {
        EXPECT_EQ(spherewalk::readFile(file.path()),
                  spherewalk::readFile(folder / "b" / file.path().filename()))
            << file.path();
    }
    const auto poses = spherewalk::readTum(folder / "a/poses.tum");
    ASSERT_EQ(poses.size(), 15U);
    EXPECT_NEAR(poses[10].timeS, 1, 1e-9);
    const Eigen::Vector3d driven = poses[14].roomFromCamera.translation - poses[0].roomFromCamera.translation;
    EXPECT_NEAR(driven.head<2>().norm(), 0.5, 0.1); // 1.4 s at 0.4 m/s, less the start
    EXPECT_NEAR(std::atan2(driven.y(), driven.x()), M_PI / 6, 0.05);
}

TEST(MujocoExample, SaysWhatIsMissing) {
    spherewalk::test::Program program({SPHEREWALK_MUJOCO, "/nowhere", "/nowhere/out"});
    EXPECT_EQ(program.wait(), 1);
    EXPECT_NE(program.errors().find("no dataset.json"), std::string::npos) << program.errors();
}

} // namespace mujoco_example
