// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view_depth.h"

#include "spherewalk/render/scene_rays.h"

#include <limits>

namespace spherewalk::render {

DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads) {
    view.validate();
    if (view.scene == SceneKind::None) {
        return {};
    }
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    DepthImage depth(view.rays.camera().width(), view.rays.camera().height());
    pool.run(depth.height(), threads, [&](int y, int) {
        for (int x = 0; x < depth.width(); ++x) {
            const Eigen::Vector3d ray = view.rays.ray(x, y);
            *depth.at(x, y) = ray.z() > 0 ? static_cast<float>(ray.z() * scene.distanceM(ray))
                                          : std::numeric_limits<float>::infinity();
        }
    });
    return depth;
}

} // namespace spherewalk::render
