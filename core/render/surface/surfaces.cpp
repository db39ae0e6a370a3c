// SPDX-License-Identifier: Apache-2.0
#include "surface/surface_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/scene_depth.h"

#include <utility>

namespace spherewalk::render {

namespace {

/// The width of a room's depth. Walls are flat between its pixels, only corners are blunt.
constexpr int kRoomWidth = 512;

} // namespace

Surfaces::Surfaces(std::shared_ptr<const Dataset> dataset) : m_dataset(std::move(dataset)) {
}

bool Surfaces::has(SceneKind kind, std::size_t photo) const {
    const DatasetInfo& info = m_dataset->info();
    return kind == SceneKind::Room ? info.roomShape.has_value()
                                   : usesDepths(kind) && !info.photos[photo].depth.empty();
}

SurfaceMesh Surfaces::made(SceneKind kind, std::size_t photo) const {
    const DatasetPhoto& of = m_dataset->info().photos[photo];
    if (kind == SceneKind::Room) {
        return SurfaceMesh(roomDepth(*m_dataset->info().roomShape, of.roomFromPhoto, kRoomWidth, of.lenses));
    }
    std::shared_ptr<const DepthSteps> depth = m_dataset->depth(photo);
    if (depth->width() % SurfaceMesh::kBlock != 0) {
        throw Error(ErrorKind::Corrupt,
                    text("The depth ", (m_dataset->folder() / of.depth).string(),
                         " is damaged: its width of ", depth->width(), " pixels is no multiple of ",
                         SurfaceMesh::kBlock, "; export the dataset again."));
    }
    return SurfaceMesh(std::move(depth));
}

std::shared_ptr<const SurfaceMesh> Surfaces::get(SceneKind kind, std::size_t photo) {
    const SceneKind of = usesDepths(kind) ? SceneKind::Depth : kind;
    return m_meshes.get({of, photo}, [&] { return made(of, photo); });
}

} // namespace spherewalk::render
