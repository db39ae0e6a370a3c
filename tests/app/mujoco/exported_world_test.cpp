// SPDX-License-Identifier: GPL-3.0-or-later
// What MuJoCo itself makes of an exported world.
#include "temporary_folder.h"

#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <mujoco/mujoco.h>
#include <numbers>

namespace spherewalk {
namespace {

constexpr double kTableFromM = 2.5;

/// A room with a table across the robot's way.
dataset::WorldRoom smallRoom() {
    dataset::WorldRoom room{"a room", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.5, 3, {1, 1.5, 1.7}, {}};
    room.furniture.emplace_back(Eigen::Vector3d(kTableFromM, 1, 0.5), Eigen::Vector3d(3.2, 2, 1.2));
    return room;
}

class MujocoWorld : public testing::Test {
  protected:
    MujocoWorld() {
        const std::string file = jobs::exportWorld(smallRoom(), CameraIntrinsics::pinhole(320, 240, 1.1),
                                                   jobs::WorldFormat::Mjcf, folder / "world");
        std::array<char, 1000> error = {};
        model.reset(mj_loadXML((folder / "world" / file).c_str(), nullptr, error.data(), error.size()));
        EXPECT_NE(model, nullptr) << error.data();
        data.reset(model ? mj_makeData(model.get()) : nullptr);
        if (data) {
            mj_forward(model.get(), data.get());
        }
    }

    double rangeM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
        const int robot = mj_name2id(model.get(), mjOBJ_BODY, "robot");
        int geom = -1;
        return mj_ray(model.get(), data.get(), from.data(), along.data(), nullptr, 1, robot, &geom);
    }

    test::TemporaryFolder folder;
    std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, &mj_deleteModel};
    std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, &mj_deleteData};
};

TEST_F(MujocoWorld, HasWallsAndFurnitureWhereTheyAre) {
    const dataset::WorldRoom room = smallRoom();
    const render::RoomShape shape{room.outline, room.floorM, room.ceilingM};
    const Eigen::Vector3d from(1, 1.5, 0.9);
    int met = 0;
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
        const double angle = (azimuth + 0.3) * std::numbers::pi / 180;
        for (const double rise : {-0.4, 0.0, 0.7}) {
            const Eigen::Vector3d along =
                Eigen::Vector3d(std::cos(angle), std::sin(angle), rise).normalized();
            const double wallM = 1 / render::inverseDistance(shape, from, along);
            const double measuredM = rangeM(from, along);
            if (measuredM < wallM - 1e-4) {
                EXPECT_NEAR(room.furniture[0].exteriorDistance(from + measuredM * along), 0, 1e-4);
                ++met;
            } else {
                EXPECT_NEAR(measuredM, wallM, 1e-4) << azimuth << " " << rise;
            }
        }
    }
    EXPECT_GT(met, 30) << "the table";
}

TEST_F(MujocoWorld, TheRobotStopsAtTheTable) {
    const int drive = mj_name2id(model.get(), mjOBJ_ACTUATOR, "x");
    ASSERT_GE(drive, 0);
    data->ctrl[drive] = 0.5;
    while (data->time < 6) {
        mj_step(model.get(), data.get());
    }
    const int robot = mj_name2id(model.get(), mjOBJ_BODY, "robot");
    EXPECT_NEAR(data->xpos[3 * robot], kTableFromM - 0.15, 0.01);
}

TEST_F(MujocoWorld, TheCameraLooksAlongTheRobot) {
    const int camera = mj_name2id(model.get(), mjOBJ_CAMERA, "camera");
    ASSERT_GE(camera, 0);
    const mjtNum* at = data->cam_xpos + 3 * camera;
    EXPECT_NEAR((Eigen::Vector3d(at[0], at[1], at[2]) - smallRoom().cameraAt).norm(), 0, 1e-9);
    const mjtNum* turn = data->cam_xmat + 9 * camera; // row by row; it looks along -z
    EXPECT_NEAR((Eigen::Vector3d(-turn[2], -turn[5], -turn[8]) - Eigen::Vector3d::UnitX()).norm(), 0, 1e-9);
}

} // namespace
} // namespace spherewalk
