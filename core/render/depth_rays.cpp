// SPDX-License-Identifier: Apache-2.0
#include "depth_rays.h"

#include <algorithm>

namespace spherewalk::render {

using Eigen::Vector3d;

RowRays::RowRays(const PixelRays& rays, int width) : m_rays(rays), m_width(width) {
    const CameraIntrinsics& k = rays.camera().intrinsics();
    m_isPinhole = k.lens == LensModel::Pinhole;
    const int rows = m_isPinhole ? 1 : kCell;
    m_x.resize(static_cast<std::size_t>(width * rows));
    m_y.resize(m_isPinhole ? std::size_t{kCell} * kCell : m_x.size());
    m_z.resize(m_isPinhole ? kCell : m_x.size(), 1);
    for (int x = 0; x < width && m_isPinhole; ++x) {
        m_x[static_cast<std::size_t>(x)] = static_cast<float>((x - k.cx) / k.fx);
    }
    for (std::size_t node = 0; node < m_nodes.size() && m_isPinhole; ++node) {
        for (int x = simd::NodeRays::kNodes[node]; x < width; x += kCell) {
            m_nodes[node].push_back(m_x[static_cast<std::size_t>(x)]);
        }
        m_nodes[node].resize(m_nodes[node].size() + kCell); // SIMD reads beyond the end
    }
}

void RowRays::cast(int row) {
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    for (int y = 0; y < kCell; ++y) {
        const int line = row * kCell + y;
        if (m_isPinhole) {
            std::fill_n(m_y.begin() + y * kCell, kCell, static_cast<float>((line - k.cy) / k.fy));
            continue;
        }
        for (int x = 0; x < m_width; ++x) {
            const bool isInView = x < k.width && line < k.height;
            const Vector3d ray = isInView ? m_rays.ray(x, line) : Vector3d(0, 0, 1);
            const auto i = static_cast<std::size_t>(y * m_width + x);
            m_x[i] = static_cast<float>(ray.x());
            m_y[i] = static_cast<float>(ray.y());
            m_z[i] = static_cast<float>(ray.z());
        }
    }
}

std::array<simd::CellRays, 3> RowRays::cell(int x) const {
    if (m_isPinhole) {
        return {{{m_x.data() + x, 0}, {m_y.data(), kCell}, {m_z.data(), 0}}};
    }
    return {{{m_x.data() + x, m_width}, {m_y.data() + x, m_width}, {m_z.data() + x, m_width}}};
}

simd::NodeRays RowRays::nodes() const {
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    simd::NodeRays nodes;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        nodes.x[i] = m_nodes[i].data();
        nodes.y[i] = m_y[static_cast<std::size_t>(simd::NodeRays::kNodes[i] * kCell)];
    }
    nodes.stepX = static_cast<float>(1 / k.fx);
    nodes.stepY = static_cast<float>(1 / k.fy);
    return nodes;
}

} // namespace spherewalk::render
