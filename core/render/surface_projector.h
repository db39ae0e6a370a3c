// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_mesh.h"
#include "depth_simd.h"
#include "inverse_buffer.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <array>

namespace spherewalk::render {

/// From a photo's surface to a view. Threads: const, any number.
class SurfaceProjector {
  public:
    /// camera: outlives the projector.
    SurfaceProjector(const Rigid3& cameraFromPhoto, const CameraModel& camera);

    /// Adds them. Range: there is room.
    void project(const simd::SurfacePatches& patches, simd::Quads& out) const;

    /// All vertices of a block.
    void project(const simd::SurfacePart& block, simd::ProjectedPart& out) const;

    /// Whether a block may show in cells that are open.
    bool mayShow(const DepthMesh::Bound& bound, const OpenCells& open) const;

    /// Pixels that a point moves by, about, if its 1 / distance changes by 1 per metre.
    float pixelsPerInverse() const;

    /// Through a lens straight edges are bent: large quads are not drawn as such.
    int largestLevel() const { return m_isPinhole ? DepthMesh::kLevels - 1 : 2; }

  private:
    struct Vertex {
        float x = 0, y = 0;
        float value = 0; ///< as ProjectedPart
    };

    Vertex throughLens(const Eigen::Vector3f& direction, float inverseM) const;

    Eigen::Matrix3f m_rotation;
    Eigen::Vector3f m_translation;
    const CameraModel& m_camera;
    bool m_isPinhole;
    simd::SurfaceCamera m_pinhole;
    std::array<Eigen::Vector3f, 5> m_sides; ///< of what the pinhole sees, and a pixel more: inward normals
};

} // namespace spherewalk::render
