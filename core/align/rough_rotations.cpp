// SPDX-License-Identifier: GPL-3.0-or-later
#include "rough_rotations.h"

#include "pose_graph.h"
#include "rotation_average.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <limits>

namespace spherewalk::align {

RoughRotations roughRotations(int photos, std::span<const PairEstimate> estimates) {
    for (const PairEstimate& estimate : estimates) {
        if (std::min(estimate.a, estimate.b) < 0 || std::max(estimate.a, estimate.b) >= photos) {
            throw Error(ErrorKind::InvalidInput, text("A pair names the photos ", estimate.a, " and ",
                                                      estimate.b, ", but there are ", photos, " photos."));
        }
    }
    RoughRotations result;
    result.partFromPhoto.assign(static_cast<std::size_t>(photos), Eigen::Quaterniond::Identity());
    result.part.assign(static_cast<std::size_t>(photos), -1);
    result.residualRad.assign(estimates.size(), std::numeric_limits<double>::infinity());
    std::vector<int> indexOf(static_cast<std::size_t>(photos), 0);
    for (const Component& component : poseGraph(photos, estimates, 1).components) {
        for (std::size_t i = 0; i < component.photos.size(); ++i) {
            const auto photo = static_cast<std::size_t>(component.photos[i]);
            indexOf[photo] = static_cast<int>(i);
            result.part[photo] = result.parts;
            result.partFromPhoto[photo] = component.rootFromPhoto[i];
        }
        for (const GraphEdge& edge : component.edges) {
            result.residualRad[static_cast<std::size_t>(edge.pair)] =
                disagreement(edge, component.rootFromPhoto, indexOf).norm();
        }
        ++result.parts;
    }
    return result;
}

} // namespace spherewalk::align
