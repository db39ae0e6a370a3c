// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/aligned_buffer.h"
#include "pixels/fixed_point.h"
#include "sphere/ray_table.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"

#include <array>
#include <cstdint>

namespace spherewalk::render {

/// Photo coordinates of a view's samples in fixed point. They are exact in double precision on a sparse
/// lattice of nodes, and biquadratic between. The error of a cell has a bound: resources/docs/render.md, "The
/// bound", proves it. Where the bound exceeds the tolerance, the cell's nodes are two or four times as dense;
/// the bound falls with the cube of their distance. Beyond that every sample is computed exactly. All
/// arithmetic is IEEE addition, multiplication, division and square root, or integer: it is the same on every
/// machine, for any width of SIMD.

/// The parameters of one view's lattice. Units: errors are angles on the sphere in pixels of the photo at its
/// equator. A difference in u counts cos(elevation) times.
struct LatticeFrame {
    /// roomFromCamera: the pose of the optical frame, with a unit quaternion. scene: Sphere displaces rays,
    /// all other kinds only turn them. sphereRadiusM: the radius for Sphere, > 0; a camera beyond
    /// kLargestDisplacement radii is taken to stand there. tolerancePx: the bound that the interpolation's
    /// error must keep, > 0. Owner: rays must outlive the frame.
    LatticeFrame(const RayTable& rays, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
                 const EquirectSize& photo, SceneKind scene, double sphereRadiusM,
                 double tolerancePx = kTolerancePx);

    /// For photoCoordinates() of directions that are known already, and only turned.
    LatticeFrame(const Eigen::Matrix3d& photoFromRay, const EquirectSize& photo);

    static constexpr double kTolerancePx = 0.018; ///< With rounding to fixed point the whole error is 0.02.

    const RayTable* rays = nullptr;
    std::array<double, 9> photoFromRay;   ///< Row after row. Rays are as the table has them.
    std::array<double, 3> displacement{}; ///< The camera minus the photo, in the photo's frame. Units: radii.
    bool displaced = false;               ///< Whether `displacement` counts: for SceneKind::Sphere.
    double width;
    double height;
    double tolerancePx = kTolerancePx;
};

/// How a cell's coordinates are computed.
enum class CellMode : std::uint8_t {
    Coarse, ///< By one biquadratic patch.
    Fine,   ///< By 2 x 2 patches.
    Finest, ///< By 4 x 4 patches.
    Exact,  ///< Every sample by itself.
};

/// Values at nodes, one after the other. The pointers cosine and along may be null.
struct NodeValues {
    double* u;
    double* v;
    double* cosine; ///< The cosine of the elevation.
    double* along;  ///< The displacement along the ray: the a of the bound.
};

/// A row of nodes: those on the patches' left edges, and those between.
struct NodeRow {
    NodeValues edges;
    NodeValues centres;
};

/// A row of patches. In each, u and v are biquadratic in s and t from -1 to 1. Units: 2^-16 pixels.
struct PatchRow {
    std::array<float*, 9> u; ///< Relative to the centre. [3 i + j] is the coefficient of s^i t^j.
    std::array<float*, 9> v;
    std::int32_t* centreU;
    std::int32_t* centreV;
    /// The samples are at least so many pixels from the seam. Some may lie beyond the seam only where the
    /// value is negative.
    double* fromSeam;
};

/// The lattice of one row of cells, and the coordinates of its cells. It keeps its memory. Threads: one.
class LatticeRow {
  public:
    LatticeRow() = default;
    /// cellsX: the most cells side by side.
    explicit LatticeRow(int cellsX);

    /// Forgets the row before. Call this before the first row of a frame.
    void restart() { m_cellY = -2; }

    /// Goes to a row: computes its nodes and patches and chooses each cell's mode. Cost: less when rows are
    /// taken one after the other, since they share nodes.
    void beginRow(const LatticeFrame& frame, int cellY);

    /// The coordinates of a cell of that row in fixed point. Shape: u and v have kCell * kCell * n^2 values
    /// for n samples along an axis. Sample (i, j) of pixel (x, y), i to the right and j down, is at
    /// ((y * n + j) * n + i) * 16 + x.
    void coordinates(const LatticeFrame& frame, int cellX, std::int32_t* u, std::int32_t* v);

    /// The same as places, and the fractions that were cut off. A fraction is the way to the next pixel in
    /// 2^-16: to the right in the lower half of the number, down in the upper half.
    void places(const LatticeFrame& frame, int cellX, const Placing& placing, std::int32_t* places,
                std::int32_t* fractions);

    CellMode mode(int cellX) const { return m_mode[static_cast<std::size_t>(cellX)]; }

    /// The bound of the error of a coarse cell. The bounds of finer modes are 8 and 64 times less.
    double boundPx(int cellX) const { return m_bound[static_cast<std::size_t>(cellX)]; }

  private:
    /// Cells of one mode, cut into parts x parts patches each.
    struct Level {
        Level() = default;
        Level(int cellsX, int partsOfCell);

        int parts = 1;
        AlignedBuffer<double> values;
        AlignedBuffer<float> coefficients;
        AlignedBuffer<std::int32_t> centres;
        std::array<NodeRow, 3> nodes{};
        std::array<PatchRow, 4> patches{};
    };

    void evaluateRow(const LatticeFrame& frame, const Level& level, int nodeY, int begin, int end,
                     const NodeRow& row);
    void interpolateRays(const RayTable& table, const Eigen::Vector2d& first, double step, int count);
    void refine(const LatticeFrame& frame, Level& level, int begin, int end);
    void chooseModes(const LatticeFrame& frame);
    bool crossesSeam(int cellX) const;

    const Level& levelOf(int cellX) const { return m_levels[static_cast<std::size_t>(mode(cellX))]; }

    void exact(const LatticeFrame& frame, int cellX, std::int32_t* u, std::int32_t* v);

    int m_cellY = -2;
    std::array<Level, 3> m_levels;
    AlignedBuffer<double> m_bound;
    AlignedBuffer<CellMode> m_mode;
    AlignedBuffer<double> m_rays; ///< The rays of one row of nodes or samples: x, then y, then z.
    int m_raysPitch = 0;
};

} // namespace spherewalk::render
