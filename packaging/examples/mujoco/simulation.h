// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"

#include <memory>
#include <mujoco/mujoco.h>
#include <string>

namespace mujoco_example {

/// A world as roomWorld() writes it, in motion.
class Simulation {
  public:
    /// Errors: std::runtime_error with MuJoCo's message.
    explicit Simulation(const std::string& mjcf);

    const mjModel& model() const { return *m_model; }

    mjData& data() { return *m_data; }

    double timeS() const { return m_data->time; }

    /// Drives with these speeds of the robot's wheels until so much time has passed.
    void drive(double leftMps, double rightMps, double seconds);

    /// Whether the robot touches a wall or an obstacle.
    bool isBumping() const;

    /// The pose of the camera's optical frame (z forward, x right, y down).
    spherewalk::Rigid3 roomFromCamera() const;

    spherewalk::Rigid3 roomFromRobot() const { return roomFromBody("robot"); }

    spherewalk::Rigid3 roomFromBody(const char* name) const;

  private:
    struct Free {
        void operator()(mjModel* model) const { mj_deleteModel(model); }

        void operator()(mjData* data) const { mj_deleteData(data); }
    };

    std::unique_ptr<mjModel, Free> m_model;
    std::unique_ptr<mjData, Free> m_data;
};

/// Goes straight on until it bumps into something, backs off, turns, and goes on.
class BumpingDriver {
  public:
    /// The next tenth of a second.
    void drive(Simulation& simulation);

  private:
    int m_backing = 0; ///< tenths of a second left
    int m_turning = 0;
};

} // namespace mujoco_example
