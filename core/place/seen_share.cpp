// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/place/surface.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace spherewalk::place {

namespace {

/// The cells of a grid in which a surface has vertices. The origin is a vertex, so that a room far away has
/// small coordinates.
class SurfaceCells {
  public:
    SurfaceCells(const Surface& surface, double cellM)
        : m_cellM(cellM), m_originM(surface.vertices.front().pInRoom) {
        for (const SurfaceVertex& vertex : surface.vertices) {
            m_cells.insert(keyOf(vertex.pInRoom));
            m_least = m_least.cwiseMin(vertex.pInRoom);
            m_greatest = m_greatest.cwiseMax(vertex.pInRoom);
        }
    }

    /// Whether a ray meets one. direction: unit length.
    bool areMet(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
        constexpr double kFarthestM = 60; // farther away no depth is sure enough to be fused
        const Eigen::Vector3d farthest = (from - m_least).cwiseAbs().cwiseMax((from - m_greatest).cwiseAbs());
        const double stepM = m_cellM / 2;
        const auto steps = static_cast<int>(std::ceil(std::min(farthest.norm(), kFarthestM) / stepM));
        for (int i = 1; i <= steps; ++i) {
            if (m_cells.contains(keyOf(from + i * stepM * direction))) {
                return true;
            }
        }
        return false;
    }

  private:
    std::uint64_t keyOf(const Eigen::Vector3d& pInRoom) const {
        constexpr std::uint64_t kMask = (1U << 21U) - 1;
        std::uint64_t key = 0;
        for (const double coordinate : Eigen::Vector3d((pInRoom - m_originM) / m_cellM)) {
            key = key << 21U | (static_cast<std::uint64_t>(std::llround(coordinate)) & kMask);
        }
        return key;
    }

    double m_cellM;
    Eigen::Vector3d m_originM;
    Eigen::Vector3d m_least = m_originM;
    Eigen::Vector3d m_greatest = m_originM;
    std::unordered_set<std::uint64_t> m_cells;
};

} // namespace

double seenShare(const Surface& surface, std::span<const SeenDepth> photos, double cellM, int threads,
                 const std::stop_token& stop) {
    constexpr EquirectSize kRays{64, 32};
    if (surface.vertices.empty()) {
        return 0;
    }
    const SurfaceCells cells(surface, cellM);
    std::vector<double> met(photos.size());
    double all = 0;
    for (int y = 0; y < kRays.height; ++y) {
        all += kRays.width * direction(kRays, Eigen::Vector2d(0, y)).head<2>().norm();
    }
    parallelFor(static_cast<int>(photos.size()), 1, threads, [&](int begin, int) {
        const Rigid3& pose = photos[static_cast<std::size_t>(begin)].roomFromPhoto();
        for (int y = 0; y < kRays.height; ++y) {
            throwIfStopped(stop);
            for (int x = 0; x < kRays.width; ++x) {
                const Eigen::Vector3d ray = direction(kRays, Eigen::Vector2d(x, y));
                const bool isMet = cells.areMet(pose.translation, pose.rotation * ray);
                met[static_cast<std::size_t>(begin)] += isMet ? ray.head<2>().norm() / all : 0;
            }
        }
    });
    double sum = 0;
    for (const double share : met) {
        sum += share;
    }
    return sum / static_cast<double>(photos.size());
}

} // namespace spherewalk::place
