// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/look.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <numbers>

namespace spherewalk::ui {

void Look::turn(Radians left, Radians higher) {
    constexpr double kPole = std::numbers::pi / 2;
    yaw = wrapped(yaw + left);
    up = Radians(std::clamp((up + higher).value(), -kPole, kPole));
}

void Look::zoom(double factor) {
    fov = Radians(std::clamp(fov.value() * factor, Radians(kNarrowest).value(), Radians(kWidest).value()));
}

Rigid3 Look::roomFromCamera(const Eigen::Vector3d& at) const {
    return {rotation({yaw, -up, Radians(0)}) * bodyFromOptical(), at};
}

CameraIntrinsics Look::camera(int width, int height) const {
    return CameraIntrinsics::pinhole(width, height, fov.value());
}

} // namespace spherewalk::ui
