// SPDX-License-Identifier: Apache-2.0
#include "simulation.h"

#include "room_world.h"

#include <array>
#include <cstring>
#include <stdexcept>

namespace mujoco_example {

namespace {

constexpr double kWheelRadiusM = 0.08;
constexpr double kSpeedMps = 0.4;

mjModel* load(const std::string& mjcf) {
    const auto files = std::make_unique<mjVFS>(); // megabytes
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "room.xml", static_cast<int>(mjcf.size()));
    std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
    std::array<char, 1000> message{};
    mjModel* const model = mj_loadXML("room.xml", files.get(), message.data(), message.size());
    mj_deleteVFS(files.get());
    if (model == nullptr) {
        throw std::runtime_error(std::string("MuJoCo refuses the world: ") + message.data());
    }
    return model;
}

Eigen::Quaterniond rotationOf(const mjtNum* rowMajor) {
    return Eigen::Quaterniond(Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(rowMajor))
        .normalized();
}

} // namespace

Simulation::Simulation(const std::string& mjcf) : m_model(load(mjcf)), m_data(mj_makeData(m_model.get())) {
    mj_forward(m_model.get(), m_data.get());
}

void Simulation::drive(double leftMps, double rightMps, double seconds) {
    m_data->ctrl[0] = leftMps / kWheelRadiusM;
    m_data->ctrl[1] = rightMps / kWheelRadiusM;
    for (const double end = timeS() + seconds - m_model->opt.timestep / 2; timeS() < end;) {
        mj_step(m_model.get(), m_data.get());
    }
    mj_forward(m_model.get(), m_data.get()); // a step leaves the poses of bodies and cameras where it began
}

bool Simulation::isBumping() const {
    const int bumper = mj_name2id(m_model.get(), mjOBJ_GEOM, "bumper");
    for (int i = 0; i < m_data->ncon; ++i) {
        const mjContact& contact = m_data->contact[i];
        const int other = contact.geom1 == bumper ? contact.geom2 : contact.geom1;
        const bool isBumper = contact.geom1 == bumper || contact.geom2 == bumper;
        if (isBumper && m_model->geom_group[other] == kRoomGroup) {
            return true;
        }
    }
    return false;
}

spherewalk::Rigid3 Simulation::roomFromCamera() const {
    const int eyes = mj_name2id(m_model.get(), mjOBJ_CAMERA, "eyes");
    // MuJoCo's cameras look along -z, with y up.
    const Eigen::Quaterniond cameraFromOptical(0, 1, 0, 0);
    return {rotationOf(m_data->cam_xmat + 9 * eyes) * cameraFromOptical,
            Eigen::Map<const Eigen::Vector3d>(m_data->cam_xpos + 3 * eyes)};
}

spherewalk::Rigid3 Simulation::roomFromBody(const char* name) const {
    const int body = mj_name2id(m_model.get(), mjOBJ_BODY, name);
    return {rotationOf(m_data->xmat + 9 * body), Eigen::Map<const Eigen::Vector3d>(m_data->xpos + 3 * body)};
}

void BumpingDriver::drive(Simulation& simulation) {
    constexpr double kTickS = 0.1;
    if (m_backing == 0 && m_turning == 0 && simulation.isBumping()) {
        m_backing = 8;
        m_turning = 12;
    }
    if (m_backing > 0) {
        --m_backing;
        simulation.drive(-kSpeedMps, -kSpeedMps, kTickS);
    } else if (m_turning > 0) {
        --m_turning;
        simulation.drive(-kSpeedMps / 2, kSpeedMps / 2, kTickS);
    } else {
        simulation.drive(kSpeedMps, kSpeedMps, kTickS);
    }
}

} // namespace mujoco_example
