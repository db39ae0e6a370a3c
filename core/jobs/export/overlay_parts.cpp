// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/overlay_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::jobs {

PixelBox boxAround(const Eigen::Vector3d& pInCamera, double radius, const CameraModel& camera) {
    const PixelBox whole{0, 0, camera.width(), camera.height()};
    if (pInCamera.squaredNorm() <= 3 * radius * radius) { // the cube is around the camera
        return whole;
    }
    Eigen::Vector2d least(1e9, 1e9);
    Eigen::Vector2d greatest = -least;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                   (corner & 4) != 0 ? 1 : -1);
        const auto pixel = camera.project(pInCamera + radius * side);
        if (!pixel) {
            return whole;
        }
        least = least.cwiseMin(*pixel);
        greatest = greatest.cwiseMax(*pixel);
    }
    const auto inside = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    return {inside(std::floor(least.x()), whole.right), inside(std::floor(least.y()), whole.bottom),
            inside(std::ceil(greatest.x()) + 1, whole.right),
            inside(std::ceil(greatest.y()) + 1, whole.bottom)};
}

render::Overlay emptyOverlay(const CameraModel& camera) {
    render::Overlay overlay;
    overlay.camera = camera.intrinsics();
    overlay.picture = RgbaImage(camera.width(), camera.height());
    overlay.depth = DepthImage(camera.width(), camera.height());
    std::fill(overlay.depth.values().begin(), overlay.depth.values().end(),
              std::numeric_limits<float>::infinity());
    return overlay;
}

void shade(const std::array<std::uint8_t, 3>& colour, double brightness, std::uint8_t* pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
        pixel[c] = static_cast<std::uint8_t>(std::lround(brightness * colour[c]));
    }
    pixel[3] = 255;
}

} // namespace spherewalk::jobs
