// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "headless_gl.h"
#include "simulation.h"

#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/overlay.h"

#include <vector>

namespace mujoco_example {

/// The camera that MuJoCo renders objects with for a robot's camera: the same where that has no lens and its
/// axis meets the picture's centre, which is all that MuJoCo knows; else one of the same size that sees as
/// much.
spherewalk::CameraIntrinsics objectCamera(const spherewalk::CameraModel& camera);

/// Renders what is in a simulation besides the room, to be laid into views. Threads: the one that made it.
class ObjectRenderer {
  public:
    /// camera: as objectCamera() gives it, and as the world was made for. Owner: the simulation must outlive
    /// it.
    ObjectRenderer(Simulation& simulation, const spherewalk::CameraIntrinsics& camera);
    ~ObjectRenderer();
    ObjectRenderer(const ObjectRenderer&) = delete;
    ObjectRenderer& operator=(const ObjectRenderer&) = delete;

    /// Lights objects as the photos show the light at a place, and lets the ball cast a shadow in it on the
    /// floor and the table. Before the first call MuJoCo's own light falls on them, without a shadow.
    void light(const spherewalk::render::LightProbe& probe);

    /// Objects as the camera sees them now. wantsRoomDepth: that of the walls as MuJoCo has them comes along,
    /// to hide objects where views have no scene model with surfaces.
    spherewalk::render::Overlay overlay(bool wantsRoomDepth);

  private:
    struct Rendered;

    enum class Part { Objects, Room, Ground };

    Rendered rendered(Part part);
    void putLight();
    spherewalk::Image<float, 1> shadow(const spherewalk::DepthImage& ground,
                                       const spherewalk::DepthImage& room) const;

    HeadlessGl m_gl;
    Simulation& m_simulation;
    spherewalk::CameraIntrinsics m_camera;
    spherewalk::render::DominantLight m_light;                  ///< For what MuJoCo renders.
    std::vector<spherewalk::render::DirectionalLight> m_lights; ///< For shadows.
    mjvScene m_scene{};
    mjrContext m_context{};
};

} // namespace mujoco_example
