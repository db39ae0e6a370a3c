// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/scene_depth.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

void RoomShape::validate() const {
    const bool isFinite = std::all_of(outline.begin(), outline.end(),
                                      [](const Eigen::Vector2d& corner) { return corner.allFinite(); });
    if (outline.size() < 3 || !isFinite || !std::isfinite(floorM) || !std::isfinite(ceilingM) ||
        !(ceilingM > floorM)) {
        throw Error(ErrorKind::InvalidInput, "A room needs an outline of at least three corners, and a "
                                             "ceiling above its floor.");
    }
}

double inverseDistance(const RoomShape& room, const Eigen::Vector3d& pInRoom,
                       const Eigen::Vector3d& direction) {
    const double height = direction.z() < 0 ? room.floorM - pInRoom.z() : room.ceilingM - pInRoom.z();
    double greatest = std::abs(height) > 1e-9 ? std::max(0.0, direction.z() / height) : 0;
    for (std::size_t i = 0; i < room.outline.size(); ++i) {
        const Eigen::Vector2d a = room.outline[i] - pInRoom.head<2>();
        const Eigen::Vector2d wall = room.outline[(i + 1) % room.outline.size()] - room.outline[i];
        const double across = direction.x() * wall.y() - direction.y() * wall.x();
        const double along = a.x() * direction.y() - a.y() * direction.x(); // times across
        const double reach = a.x() * wall.y() - a.y() * wall.x();
        const double share = across != 0 ? along / across : -1;
        if (share >= 0 && share <= 1 && std::abs(reach) > 1e-9 && across / reach > 0) {
            greatest = std::max(greatest, across / reach);
        }
    }
    return greatest / direction.norm();
}

DepthMap roomDepth(const RoomShape& room, const Rigid3& roomFromPhoto, int width, const LensPair& lenses) {
    room.validate();
    const EquirectSize size{width, width / 2};
    Image<float, 1> inverse(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d inPhoto = direction(size, Eigen::Vector2d(x, y));
            const Eigen::Vector3d ray = roomFromPhoto.rotation * inPhoto;
            *inverse.at(x, y) =
                static_cast<float>(inverseDistance(room, roomFromPhoto * lenses.place(inPhoto), ray));
        }
    }
    return DepthMap(std::move(inverse));
}

} // namespace spherewalk::render
