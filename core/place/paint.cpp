// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/place/surface.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::place {

namespace {

constexpr int kVerticesAGrain = 4096;
constexpr float kGrey = 128;

/// The picture's colour in a direction, between its pixels.
Eigen::Vector3f colourIn(const RgbImage& picture, const Eigen::Vector3d& direction) {
    const Eigen::Vector2d at = pixel({picture.width(), picture.height()}, direction);
    const auto left = static_cast<int>(std::floor(at.x()));
    const int top = std::clamp(static_cast<int>(std::floor(at.y())), 0, picture.height() - 2);
    const auto x = static_cast<float>(at.x() - left);
    const auto y = static_cast<float>(std::clamp(at.y() - top, 0.0, 1.0));
    const auto colour = [&](int column, int row) {
        const std::uint8_t* rgb = picture.at((column + picture.width()) % picture.width(), row);
        return Eigen::Vector3f(rgb[0], rgb[1], rgb[2]);
    };
    return (1 - y) * ((1 - x) * colour(left, top) + x * colour(left + 1, top)) +
           y * ((1 - x) * colour(left, top + 1) + x * colour(left + 1, top + 1));
}

} // namespace

SurfacePainter::SurfacePainter(Surface& surface, double withinM)
    : m_surface(surface), m_withinM(withinM), m_sums(surface.vertices.size(), Eigen::Vector4f::Zero()) {
}

void SurfacePainter::add(const SeenDepth& depth, const RgbImage& picture, int threads) {
    const Eigen::Vector3d& eye = depth.roomFromPhoto().translation;
    const auto count = static_cast<int>(m_sums.size());
    parallelFor(count, kVerticesAGrain, threads, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const SurfaceVertex& vertex = m_surface.vertices[i];
            const Sight sight = depth.sight(vertex.pInRoom);
            if (sight.isEdge || !vertex.isShownBy(depth, sight, m_withinM)) {
                continue;
            }
            const Eigen::Vector3d ray = (eye - vertex.pInRoom).normalized();
            const float facing = vertex.normal.dot(ray.cast<float>());
            const float share = facing / std::max(sight.pointM, 0.1F);
            const float weight = share * share * share * share; // nearly all is the best photo's
            m_sums[i].head<3>() += weight * colourIn(picture, depth.directionTo(vertex.pInRoom));
            m_sums[i].w() += weight;
        }
    });
}

void SurfacePainter::finish() {
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float value = m_sums[i].w() > 0 ? m_sums[i][c] / m_sums[i].w() : kGrey;
            m_surface.vertices[i].colour[static_cast<std::size_t>(c)] =
                static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
        }
    }
}

} // namespace spherewalk::place
