// SPDX-License-Identifier: Apache-2.0
#include "surfaces.h"

#include "spherewalk/base/file.h"
#include "spherewalk/render/room_shape.h"

#include <algorithm>

namespace spherewalk::render {

namespace {

constexpr int kRoomWidth = 512; ///< walls are flat between its pixels, only corners are blunt
constexpr std::uint64_t kLargestFile = 128ULL << 20;

} // namespace

Surfaces::Surfaces(std::shared_ptr<const Dataset> dataset) : m_dataset(std::move(dataset)) {
}

bool Surfaces::has(SceneKind kind, std::size_t photo) const {
    const DatasetInfo& info = m_dataset->info();
    return kind == SceneKind::Room ? info.roomShape.has_value()
                                   : kind == SceneKind::Depth && !info.photos[photo].depth.empty();
}

DepthMesh Surfaces::made(SceneKind kind, std::size_t photo) const {
    const DatasetPhoto& of = m_dataset->info().photos[photo];
    if (kind == SceneKind::Room) {
        return DepthMesh(roomDepth(*m_dataset->info().roomShape, of.roomFromPhoto, kRoomWidth));
    }
    const std::filesystem::path file = m_dataset->folder() / of.depth;
    return DepthMesh(DepthMap::parse(readFile(file, kLargestFile), file.string()));
}

std::shared_ptr<const DepthMesh> Surfaces::get(SceneKind kind, std::size_t photo) {
    return m_meshes.get({kind, photo}, [&] { return made(kind, photo); });
}

std::vector<std::size_t> Surfaces::photosFor(SceneKind kind, const Eigen::Vector3d& pInRoom,
                                             std::optional<std::size_t> without) const {
    const std::vector<DatasetPhoto>& photos = m_dataset->info().photos;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (i != without && has(kind, i)) {
            order.push_back(i);
        }
    }
    const auto distance = [&](std::size_t i) {
        return (photos[i].roomFromPhoto.translation - pInRoom).squaredNorm();
    };
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), kPhotosOfView));
    std::partial_sort(order.begin(), middle, order.end(), [&](std::size_t a, std::size_t b) {
        return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
    });
    order.erase(middle, order.end());
    return order;
}

} // namespace spherewalk::render
