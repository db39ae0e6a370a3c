// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/place/fusion.h"
#include "spherewalk/place/surface.h"
#include "spherewalk/render/scene_depth.h"

#include <functional>
#include <limits>
#include <vector>

namespace spherewalk::test {

/// Photos of an empty room whose depths are exact, but for what a test changes.
struct SeenRoom {
    using Change = std::function<void(std::size_t photo, Image<float, 1>& inverseM, MaskImage& sure)>;

    explicit SeenRoom(const Eigen::Vector3d& originM = Eigen::Vector3d::Zero(), const Change& change = {},
                      int photos = 4)
        : shape{{}, originM.z(), originM.z() + 2.5} {
        for (const auto& [x, y] : {std::pair{0, 0}, {3, 0}, {3, 2}, {0, 2}}) {
            shape.outline.push_back(originM.head<2>() + Eigen::Vector2d(x, y));
        }
        const std::vector<Eigen::Vector3d> places = {
            {1, 0.8, 1.2}, {2, 0.8, 1.1}, {1.1, 1.3, 1.3}, {2.1, 1.2, 1.2}, {1.5, 1, 1.2}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(photos); ++i) {
            const Eigen::Quaterniond turn(
                Eigen::AngleAxisd(0.7 * static_cast<double>(i), Eigen::Vector3d(0.1, 0.2, 1).normalized()));
            const Rigid3 pose{turn, originM + places[i]};
            const render::DepthMap map = render::roomDepth(shape, pose, kWidth);
            Image<float, 1> inverse = map.inverseM();
            MaskImage sure = map.sure();
            if (change) {
                change(i, inverse, sure);
            }
            depths.emplace_back(render::DepthMap(inverse, sure), pose, LensPair{},
                                std::numeric_limits<double>::infinity());
        }
    }

    place::Volume volume(int threads = 0) const {
        return place::fused(depths, {kVoxelM, threads}, noProgress(), {});
    }

    place::Surface surface() const {
        place::Surface surface = place::surfaceOf(volume());
        surface.weigh(depths, kVoxelM);
        return surface;
    }

    /// Distance from a point to the nearest wall, floor or ceiling.
    double distanceM(const Eigen::Vector3d& pInRoom) const {
        return std::min({distanceToEdge(shape.outline, pInRoom.head<2>()),
                         std::abs(pInRoom.z() - shape.floorM), std::abs(pInRoom.z() - shape.ceilingM)});
    }

    static constexpr int kWidth = 256;
    static constexpr double kVoxelM = 0.04;
    render::RoomShape shape;
    std::vector<place::SeenDepth> depths;
};

} // namespace spherewalk::test
