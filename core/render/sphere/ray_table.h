// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/aligned_buffer.h"
#include "pixels/fixed_point.h"

#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace spherewalk::render {

/// The part of a view's coordinates that depends on the camera alone: rays on a lattice, and how fast they
/// turn. It is computed once for a camera and used for every frame.
///
/// The picture is cut into cells of kCell x kCell pixels. Column i of nodes has the pixel coordinate
/// kNodeStep * i - 0.5; rows likewise. So a cell has nodes at its corners, at the middles of its edges and at
/// its centre, and covers its pixels with all of their area. Frames: rays of cameras without distortion are
/// (pixel x, pixel y, 1), and rayFromPixel() takes them to the optical frame. Rays of other cameras are unit
/// vectors of the optical frame. Threads: const functions may run on any number at a time.
class RayTable {
  public:
    static constexpr int kNodeStep = kCell / 2;
    static constexpr int kFineStep = kCell / 4;
    static constexpr int kFineParts =
        2; ///< A cell has so many parts along an axis at the finest stored nodes.

    /// samplesPerAxis: samples of each pixel. It matters only where a lens cannot be interpolated. Errors:
    /// InvalidInput unless it is in [1, 8].
    RayTable(const CameraModel& camera, int samplesPerAxis);

    int width() const { return m_width; }

    int height() const { return m_height; }

    int samplesPerAxis() const { return m_samples; }

    int cellsX() const { return m_cellsX; }

    int cellsY() const { return m_cellsY; }

    /// Whether rays are (pixel x, pixel y, 1).
    bool affine() const { return m_affine; }

    const Eigen::Matrix3d& rayFromPixel() const { return m_rayFromPixel; }

    /// Upper bounds of the motion of the unit ray over each cell of a row, with room for 16 cells more. axis:
    /// 0 along x, 1 along y. order: 1 for the speed, 2 for the covariant acceleration, 3 for the covariant
    /// jerk. Units: radians a pixel, a pixel^2 and a pixel^3.
    const double* motion(int axis, int order, int cellY) const;

    /// One coordinate of the rays on a row of nodes, with room for 16 more. Cells are cut into parts x parts
    /// (1 or kFineParts). component: 0 for x, 1 for y, 2 for z. edge: whether the nodes are those at the
    /// parts' left edges or those at their centres. It is zero where there is no ray. Range: not affine.
    const double* nodes(int parts, int component, bool edge, int nodeY) const;

    /// A ray between the nodes, interpolated. The error is far below a thousandth of a photo pixel. Range:
    /// not affine, inside a cell that is not explicit.
    Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

    /// The rays of a cell that cannot be interpolated: they end in it or turn too fast.
    struct ExplicitCell {
        /// The rays of all samples in the order of LatticeRow::coordinates(): all x, then all y, then all z.
        std::vector<double> rays;
        std::vector<std::uint8_t> seen; ///< One value a pixel, row after row: 0 where the lens sees nothing.
    };

    /// Null if the cell's rays can be interpolated.
    const ExplicitCell* explicitCell(int cellX, int cellY) const;

  private:
    void tabulateAffine(const CameraIntrinsics& camera);
    void tabulateLens(const CameraModel& camera);
    void tabulateNodes(const CameraModel& camera, int parts);
    bool interpolates(const CameraModel& camera, int cellX, int cellY) const;
    void measureMotion(int cellX, int cellY);
    ExplicitCell madeExplicit(const CameraModel& camera, int cellX, int cellY) const;
    int nodesPitch(int parts) const;
    double& motionAt(int axis, int order, int cellX, int cellY);
    Eigen::Vector3d fineRay(int fineX, int fineY) const;

    int m_width = 0;
    int m_height = 0;
    int m_samples = 1;
    int m_cellsX = 0;
    int m_cellsY = 0;
    int m_pitch = 0; ///< Values in a row of cells or nodes, padding included.
    bool m_affine = true;
    Eigen::Matrix3d m_rayFromPixel = Eigen::Matrix3d::Identity();
    AlignedBuffer<double> m_motion;                        ///< The order is [axis][order - 1][cellY][cellX].
    std::array<AlignedBuffer<double>, kFineParts> m_nodes; ///< [parts - 1][component][edge][nodeY][part].
    std::vector<std::int32_t> m_explicitIndex;             ///< One a cell: -1 if the cell is not explicit.
    std::vector<ExplicitCell> m_explicit;
};

} // namespace spherewalk::render
