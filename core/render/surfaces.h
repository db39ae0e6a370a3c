// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_mesh.h"

#include "spherewalk/base/recently_used.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/scene_model.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spherewalk::render {

/// The surfaces about a dataset's photos, of the scene models that have some. A few are kept. Threads: any.
class Surfaces {
  public:
    /// As many photos are asked for a view.
    static constexpr std::size_t kPhotosOfView = 3;

    explicit Surfaces(std::shared_ptr<const Dataset> dataset);

    /// Whether a photo has a surface of this kind.
    bool has(SceneKind kind, std::size_t photo) const;

    /// Range: one that the photo has. Errors: NotFound, Io; Corrupt for a file that is damaged.
    std::shared_ptr<const DepthMesh> get(SceneKind kind, std::size_t photo);

    /// The photos to ask for a view from there, the nearest first; empty if none has a surface.
    /// without: a photo that is left out.
    std::vector<std::size_t> photosFor(SceneKind kind, const Eigen::Vector3d& pInRoom,
                                       std::optional<std::size_t> without = std::nullopt) const;

  private:
    static constexpr std::size_t kKept = 24; ///< of about 5 MB each

    DepthMesh made(SceneKind kind, std::size_t photo) const;

    std::shared_ptr<const Dataset> m_dataset;
    RecentlyUsed<std::pair<SceneKind, std::size_t>, DepthMesh> m_meshes{kKept};
};

} // namespace spherewalk::render
