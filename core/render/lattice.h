// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "aligned_buffer.h"
#include "ray_table.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_model.h"

#include <array>
#include <cstdint>

namespace spherewalk::render {

/// Photo coordinates of a view's samples in fixed point: exact in double precision on a sparse lattice,
/// interpolated between, with a bound on the error. All arithmetic is IEEE addition, multiplication, division
/// and square root, or integer: the same on every machine, whatever the width of its SIMD.
///
/// The bound. In a cell, u and v are interpolated by the biquadratic through nodes h pixels apart. In one
/// dimension a quadratic through three equidistant nodes is off by at most h^3 / (9 sqrt 3) max|f'''|; in
/// two, with I_x and I_y the interpolation along each axis, I - I_x I_y = (I - I_x) + I_x (I - I_y), and I_x
/// enlarges by at most 5/4, so
///     |error| <= h^3 / (9 sqrt 3) (max|d3f/dx3| + 5/4 max|d3f/dy3|).                                    (1)
/// Third derivatives follow from how the direction q seen in the photo moves over the unit sphere along a
/// line of the view: with its speed G, covariant acceleration A and covariant jerk J, T = tan(elevation), V
/// the velocity as a complex number (north + i east), and the frame turning by T Im V,
///     elevation'''             = Re J - 3 T Im V Im A - Re V (Im V)^2 (1 + 3 T^2)
///     cos(elevation) azimuth''' = Im J + 3 T Im(V A) + 2 Im V (Re V)^2 + 2 T^2 Im(V^3)
/// and as |sin^2 cos| <= 0.385,
///     |elevation'''|             <= J + 3 |T| G A + 0.385 (1 + 3 T^2) G^3
///     cos(elevation) |azimuth'''| <= J + 3 |T| G A + (0.77 + 2 T^2) G^3.                                (2)
/// |T| is bounded over the cell by the elevation at its centre and the way that G allows to its corners. G, A
/// and J of the camera's own rays s come from the RayTable and do not change with its rotation. A displaced
/// camera sees q = p + t s, |q| = |p + t s| = 1; with a = p.s, r = sqrt(a^2 + 1 - |p|^2), t = r - a, the sine
/// of the angle between s and q being e = sqrt(|p|^2 - a^2), and dt/da = -t/r, d2t/da2 = (1 - |p|^2) / r^3,
/// d3t/da3 = -3 (1 - |p|^2) a / r^5, the chain rule gives bounds of t', t'' and t''', and
///     G_q <= G t / r
///     A_q <= e (|t''| + t G^2) + 2 |t'| G + t A
///     J_q <= e (|t'''| + 3 |t'| G^2 + 3 t G A + G_q^2 |t'|) + (3 |t''| + t |G_q^2 - G^2|) G + 3 |t'| A + t
///     J.
/// A cell whose bound (1) exceeds the tolerance has its nodes twice or four times as dense (the bound falls
/// with h^3), and beyond that every sample is computed exactly; so are cells that a pole may lie in. Azimuths
/// are interpolated as differences from the cell's centre, modulo 2 pi: there is no seam.
///
/// Units: errors are angles on the sphere in pixels of the photo at its equator; a difference in u counts
/// cos(elevation) times.
struct Lattice {
    /// roomFromCamera: of the optical frame, its rotation a unit quaternion. sphereRadiusM: for
    /// SceneKind::Sphere. tolerancePx: bound of the interpolation's error, > 0.
    Lattice(const RayTable& rays, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
            const EquirectSize& photo, SceneKind scene, double sphereRadiusM,
            double tolerancePx = kTolerancePx);

    static constexpr double kTolerancePx = 0.018; ///< with rounding to fixed point, 0.02 in all

    const RayTable* rays;
    std::array<double, 9> photoFromRay;   ///< row after row; rays as the table has them
    std::array<double, 3> displacement{}; ///< of the camera from the photo, in the photo's frame, in radii
    bool displaced = false;
    double width;
    double height;
    double tolerancePx;
};

/// How a cell's coordinates are computed.
enum class CellMode : std::uint8_t {
    Coarse, ///< one biquadratic
    Fine,   ///< 2 x 2
    Finest, ///< 4 x 4
    Exact,  ///< every sample by itself
};

/// Fixed point: 16 fractional bits; (0, 0) is the centre of the photo's pixel (-PlaneLayout::kGuard,
/// -PlaneLayout::kGuard). u carries half of the horizontal weights' step besides, so that cutting bits off
/// rounds.
constexpr int kFractionBits = 16;
constexpr double kRoundingU = 1.0 / 510;

/// Coordinates and more at nodes, one after the other; cosine and along may be null.
struct NodeValues {
    double* u;
    double* v;
    double* cosine; ///< of the elevation
    double* along;  ///< displacement along the ray, the a of the bound
};

/// A row of nodes: those on the patches' left edges, and those between.
struct NodeRow {
    NodeValues edges;
    NodeValues centres;
};

/// A row of patches, in each of which u and v are biquadratic in s and t from -1 to 1. Units: 2^-16 pixels.
struct PatchRow {
    std::array<float*, 9> u; ///< relative to the centre: [3 i + j] is the coefficient of s^i t^j
    std::array<float*, 9> v;
    std::int32_t* centreU;
    std::int32_t* centreV;
    double* fromSeam; ///< pixels from the seam; only where it is negative may a sample lie beyond
};

/// How coordinates become places in a photo's plane.
struct Placing {
    int stride;             ///< pixels from one of the plane's rows to the next
    std::int32_t roundingU; ///< added, so that cutting bits off rounds as the sampling needs
    std::int32_t roundingV;
};

/// Memory for the lattice of one row of cells, and of one cell. Threads: one.
class LatticeScratch {
  public:
    LatticeScratch() = default;
    /// For tables of at most so many cells side by side.
    explicit LatticeScratch(int cellsX);

    /// To be called before the first row of a lattice: what was kept of another one is forgotten.
    void restart() { m_cellY = -2; }

    /// Chooses each cell's mode, and does the row's nodes and patches. Cost: less when rows are taken one
    /// after the other.
    void beginRow(const Lattice& lattice, int cellY);

    /// The coordinates of a cell of that row. Shape: 16 for each part of each pixel row, kCell * kCell *
    /// samplesPerAxis^2 in all; part (i, j) of pixel (x, y) is at ((y * n + j) * n + i) * 16 + x.
    void coordinates(const Lattice& lattice, int cellX, std::int32_t* u, std::int32_t* v);

    /// The same as bytes from the plane's first pixel to the one at the sample's upper left, and what is cut
    /// off: fractions of the way to the next pixel in 2^-16, to the right in the lower half and down in the
    /// upper.
    void places(const Lattice& lattice, int cellX, const Placing& placing, std::int32_t* places,
                std::int32_t* fractions);

    CellMode mode(int cellX) const { return m_mode[static_cast<std::size_t>(cellX)]; }

    /// The bound of a coarse cell's error; those of finer modes are 8 and 64 times less.
    double boundPx(int cellX) const { return m_bound[static_cast<std::size_t>(cellX)]; }

  private:
    /// Cells of one mode are cut into parts x parts patches each.
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

    void evaluateRow(const Lattice& lattice, const Level& level, int nodeY, int begin, int end,
                     const NodeRow& row);
    void interpolateRays(const RayTable& table, const Eigen::Vector2d& first, double step, int count);
    void refine(const Lattice& lattice, Level& level, int begin, int end);
    void chooseModes(const Lattice& lattice);
    bool crossesSeam(int cellX) const;

    const Level& levelOf(int cellX) const { return m_levels[static_cast<std::size_t>(mode(cellX))]; }

    void exact(const Lattice& lattice, int cellX, std::int32_t* u, std::int32_t* v);

    int m_cellY = -2;
    std::array<Level, 3> m_levels;
    AlignedBuffer<double> m_bound;
    AlignedBuffer<CellMode> m_mode;
    AlignedBuffer<double> m_rays; ///< of one row of nodes or samples: x, y, z
    int m_raysPitch = 0;
};

} // namespace spherewalk::render
