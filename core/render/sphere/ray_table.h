// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "aligned_buffer.h"

#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace spherewalk::render {

/// The part of a view's coordinates that depends on the camera alone: rays on a lattice, and how fast they
/// turn. Computed once for a camera, and then used for every frame.
///
/// The picture is cut into cells of kCell x kCell pixels. Column i of nodes has the pixel coordinate
/// kNodeStep * i - 0.5, rows likewise: a cell has nodes at its corners, at the middles of its edges and at
/// its centre, and covers its pixels with all of their area. Frames: rays of cameras without distortion are
/// (pixel x, pixel y, 1), which rayFromPixel takes to the optical frame; those of others are unit vectors of
/// the optical frame. Threads: const, any number.
class RayTable {
  public:
    static constexpr int kCell = 16;
    static constexpr int kNodeStep = kCell / 2;
    static constexpr int kFineStep = kCell / 4;
    static constexpr int kFineParts = 2; ///< a cell's, for the finest nodes that are stored

    /// samplesPerAxis: of each pixel; matters only where a lens cannot be interpolated. Errors: InvalidInput
    /// unless it is in [1, 8].
    RayTable(const CameraModel& camera, int samplesPerAxis);

    int width() const { return m_width; }

    int height() const { return m_height; }

    int samplesPerAxis() const { return m_samples; }

    int cellsX() const { return m_cellsX; }

    int cellsY() const { return m_cellsY; }

    /// Whether rays are (pixel x, pixel y, 1).
    bool affine() const { return m_affine; }

    const Eigen::Matrix3d& rayFromPixel() const { return m_rayFromPixel; }

    /// Values for the cells of a row, one after the other, with room for 16 more: upper bounds over the cell,
    /// along x (axis 0) or y (axis 1), of the speed (order 1), the covariant acceleration (2) and the
    /// covariant jerk (3) of the unit ray, in radians a pixel, a pixel^2 and a pixel^3.
    const double* motion(int axis, int order, int cellY) const;

    /// Coordinate x, y, or z (component) of the rays on the row nodeY of the nodes of cells that are cut into
    /// parts x parts (1 or kFineParts): those at the parts' left edges (edge) or centres, with room for 16
    /// more. Zero where there is no ray. Range: not affine.
    const double* nodes(int parts, int component, bool edge, int nodeY) const;

    /// A ray between the nodes, interpolated with an error far below a thousandth of a photo pixel. Range:
    /// not affine, inside of a cell that is not explicit.
    Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

    /// What is stored for a cell whose rays cannot be interpolated: they end in it or turn too fast.
    struct ExplicitCell {
        /// Rays, x, y, z one after the other, of all samples in the order of CellCoordinates.
        std::vector<double> rays;
        std::vector<std::uint8_t> seen; ///< for each pixel, row after row, 0 where the lens sees nothing
    };

    /// Nothing if the cell's rays can be interpolated.
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
    int m_pitch = 0; ///< of rows of cells or nodes, padded
    bool m_affine = true;
    Eigen::Matrix3d m_rayFromPixel = Eigen::Matrix3d::Identity();
    AlignedBuffer<double> m_motion;                        ///< [axis][order - 1][cellY][cellX]
    std::array<AlignedBuffer<double>, kFineParts> m_nodes; ///< [parts - 1][component][edge][nodeY][part]
    std::vector<std::int32_t> m_explicitIndex;             ///< for each cell, -1 if not explicit
    std::vector<ExplicitCell> m_explicit;
};

} // namespace spherewalk::render
