// SPDX-License-Identifier: Apache-2.0
#include "surface_projector.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

using Eigen::Vector3f;
using simd::ProjectedPart;

namespace {

constexpr float kNearestM = 0.005F; ///< in front of the camera

} // namespace

SurfaceProjector::SurfaceProjector(const Rigid3& cameraFromPhoto, const CameraModel& camera)
    : m_rotation(cameraFromPhoto.rotation.toRotationMatrix().cast<float>()),
      m_translation(cameraFromPhoto.translation.cast<float>()),
      m_camera(camera),
      m_isPinhole(camera.intrinsics().lens == LensModel::Pinhole) {
    const CameraIntrinsics& k = camera.intrinsics();
    for (int i = 0; i < 9; ++i) {
        m_pinhole.rotation[static_cast<std::size_t>(i)] = m_rotation(i / 3, i % 3);
    }
    for (int i = 0; i < 3; ++i) {
        m_pinhole.translation[static_cast<std::size_t>(i)] = m_translation[i];
    }
    m_pinhole.fx = static_cast<float>(k.fx);
    m_pinhole.fy = static_cast<float>(k.fy);
    m_pinhole.cx = static_cast<float>(k.cx);
    m_pinhole.cy = static_cast<float>(k.cy);
    m_pinhole.nearestM = kNearestM;
    const auto width = static_cast<float>(k.width);
    const auto height = static_cast<float>(k.height);
    m_sides = {Vector3f(0, 0, 1), Vector3f(m_pinhole.fx, 0, m_pinhole.cx + 1).normalized(),
               Vector3f(-m_pinhole.fx, 0, width - m_pinhole.cx).normalized(),
               Vector3f(0, m_pinhole.fy, m_pinhole.cy + 1).normalized(),
               Vector3f(0, -m_pinhole.fy, height - m_pinhole.cy).normalized()};
}

SurfaceProjector::Vertex SurfaceProjector::throughLens(const Vector3f& direction, float inverseM) const {
    const Vector3f q = m_rotation * direction + inverseM * m_translation; // the point, times inverseM
    const float length = q.norm();
    if (!(length > kNearestM * inverseM)) {
        return {};
    }
    const auto pixel = m_camera.project(q.cast<double>());
    if (!pixel) {
        return {};
    }
    const Vertex at{static_cast<float>(pixel->x()), static_cast<float>(pixel->y()), inverseM / length};
    const bool isNear =
        std::abs(at.x) < ProjectedPart::kFarthestPx && std::abs(at.y) < ProjectedPart::kFarthestPx;
    return isNear ? at : Vertex{};
}

void SurfaceProjector::project(const simd::SurfacePatches& patches, simd::Quads& out) const {
    if (m_isPinhole) {
        simd::project(m_pinhole, patches, out);
        return;
    }
    for (int i = 0; i < patches.count; ++i, ++out.count) {
        const auto to = static_cast<std::size_t>(out.count);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::size_t across = corner == 1 || corner == 2 ? 2 : 0;
            const std::size_t up = corner < 2 ? 1 : 3;
            const Vector3f direction(patches.cosine[up][i] * patches.cosine[across][i],
                                     patches.cosine[up][i] * patches.sine[across][i], patches.sine[up][i]);
            const Vertex at = throughLens(direction, patches.inverseM[corner][i]);
            out.x[corner][to] = at.x;
            out.y[corner][to] = at.y;
            out.value[corner][to] = at.value;
        }
    }
}

void SurfaceProjector::project(const simd::SurfacePart& block, ProjectedPart& out) const {
    if (m_isPinhole) {
        simd::project(m_pinhole, block, out);
        return;
    }
    for (int row = 0; row < block.rows; ++row) {
        for (int column = 0; column <= DepthMesh::kBlock; ++column) {
            const Vector3f direction(block.cosElevation[row] * block.cosAzimuth[column],
                                     block.cosElevation[row] * block.sinAzimuth[column],
                                     block.sinElevation[row]);
            const Vertex at = throughLens(direction, block.inverseM[row * block.pitch + column]);
            const auto to = static_cast<std::size_t>(row * ProjectedPart::kPitch + column);
            out.x[to] = at.x;
            out.y[to] = at.y;
            out.value[to] = at.value;
        }
    }
}

bool SurfaceProjector::mayShow(const DepthMesh::Bound& bound, const OpenCells& open) const {
    if (!m_isPinhole) {
        return true;
    }
    // In the view, what is farther moves along a line to what is nearer: the ends have all between them.
    const Vector3f turned = m_rotation * bound.centre;
    const std::array<Vector3f, 2> ends{turned + bound.least * m_translation,
                                       turned + bound.most * m_translation};
    const float radius = bound.radius;
    for (const Vector3f& inward : m_sides) {
        if (inward.dot(ends[0]) < -radius && inward.dot(ends[1]) < -radius) {
            return false;
        }
    }
    if (std::min(ends[0].z(), ends[1].z()) - radius <= 1e-3F) {
        return true;
    }
    float left = HUGE_VALF;
    float right = -HUGE_VALF;
    float top = HUGE_VALF;
    float bottom = -HUGE_VALF;
    for (const Vector3f& q : ends) {
        const float near = 1 / (q.z() - radius);
        const float far = 1 / (q.z() + radius);
        left = std::min(left, (q.x() - radius) * (q.x() > radius ? far : near));
        right = std::max(right, (q.x() + radius) * (q.x() > -radius ? near : far));
        top = std::min(top, (q.y() - radius) * (q.y() > radius ? far : near));
        bottom = std::max(bottom, (q.y() + radius) * (q.y() > -radius ? near : far));
    }
    return open.anyIn(m_pinhole.fx * left + m_pinhole.cx - 1, m_pinhole.fy * top + m_pinhole.cy - 1,
                      m_pinhole.fx * right + m_pinhole.cx + 1, m_pinhole.fy * bottom + m_pinhole.cy + 1);
}

float SurfaceProjector::pixelsPerInverse() const {
    return m_translation.norm() * std::max(m_pinhole.fx, m_pinhole.fy);
}

} // namespace spherewalk::render
