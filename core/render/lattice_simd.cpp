// SPDX-License-Identifier: Apache-2.0
#include "lattice_simd.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lattice_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Not hn::MulAdd: where the processor has one, it rounds once instead of twice.
template <class Vector>
HWY_INLINE Vector mulAdd(Vector a, Vector b, Vector c) {
    return hn::Add(hn::Mul(a, b), c);
}

/// atan(numerator / denominator) in [0, pi/2], off by less than 3e-16. Range: both >= 0; 0 if both are 0.
HWY_INLINE V arcTangent(D d, V numerator, V denominator) {
    // To [0, 1] by atan(1/t) = pi/2 - atan(t), and to [-tan(pi/8), tan(pi/8)] by atan(t) = pi/4 +
    // atan((t - 1) / (t + 1)). There, an interpolation of atan(sqrt z) / sqrt(z) at eleven Chebyshev points
    // in z is off by less than 4e-17.
    const V least = hn::Min(numerator, denominator);
    const V greatest = hn::Max(numerator, denominator);
    const auto steep = hn::Gt(numerator, denominator);
    const auto upper = hn::Gt(least, hn::Mul(greatest, hn::Set(d, 0.41421356237309503)));
    const V top = hn::IfThenElse(upper, hn::Sub(least, greatest), least);
    const V bottom = hn::IfThenElse(upper, hn::Add(least, greatest), greatest);
    const V t = hn::Div(top, hn::Max(bottom, hn::Set(d, 1e-300)));
    const V z = hn::Mul(t, t);
    V sum = hn::Set(d, 0.02113535694575133);
    sum = mulAdd(sum, z, hn::Set(d, -0.04348050891958043));
    sum = mulAdd(sum, z, hn::Set(d, 0.056883487686028446));
    sum = mulAdd(sum, z, hn::Set(d, -0.06640233842869744));
    sum = mulAdd(sum, z, hn::Set(d, 0.07689953486227682));
    sum = mulAdd(sum, z, hn::Set(d, -0.09090773074092884));
    sum = mulAdd(sum, z, hn::Set(d, 0.11111106180425145));
    sum = mulAdd(sum, z, hn::Set(d, -0.1428571418097571));
    sum = mulAdd(sum, z, hn::Set(d, 0.199999999988551));
    sum = mulAdd(sum, z, hn::Set(d, -0.3333333333332844));
    sum = mulAdd(sum, z, hn::Set(d, 1.0));
    V angle = hn::Mul(t, sum);
    angle = hn::Add(angle, hn::IfThenElseZero(upper, hn::Set(d, std::numbers::pi / 4)));
    return hn::IfThenElse(steep, hn::Sub(hn::Set(d, std::numbers::pi / 2), angle), angle);
}

HWY_INLINE V product(D d, const double* row, V x, V y, V z) {
    return mulAdd(hn::Set(d, row[0]), x, mulAdd(hn::Set(d, row[1]), y, hn::Mul(hn::Set(d, row[2]), z)));
}

struct Outputs {
    double* u;
    double* v;
    double* cosine;
    double* along;
};

HWY_INLINE void project(D d, const Lattice& lattice, V rayX, V rayY, V rayZ, const Outputs& out, int at) {
    const double* m = lattice.photoFromRay.data();
    V x = product(d, m, rayX, rayY, rayZ);
    V y = product(d, m + 3, rayX, rayY, rayZ);
    V z = product(d, m + 6, rayX, rayY, rayZ);
    if (lattice.displaced) {
        // directionOnSphere() for rays of any length.
        const double* p = lattice.displacement.data();
        const double room = 1 - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        const V square = mulAdd(x, x, mulAdd(y, y, hn::Mul(z, z)));
        const V along = product(d, p, x, y, z);
        const V root = hn::Sqrt(mulAdd(along, along, hn::Mul(square, hn::Set(d, room))));
        const auto ahead = hn::Gt(along, hn::Zero(d));
        const V t = hn::Div(hn::IfThenElse(ahead, hn::Set(d, room), hn::Sub(root, along)),
                            hn::IfThenElse(ahead, hn::Add(root, along), square));
        if (out.along != nullptr) {
            hn::StoreU(hn::Div(along, hn::Sqrt(square)), d, out.along + at);
        }
        x = mulAdd(t, x, hn::Set(d, p[0]));
        y = mulAdd(t, y, hn::Set(d, p[1]));
        z = mulAdd(t, z, hn::Set(d, p[2]));
    }
    const V across2 = mulAdd(x, x, hn::Mul(y, y));
    const V across = hn::Sqrt(across2);
    if (out.cosine != nullptr) {
        hn::StoreU(hn::Div(across, hn::Sqrt(mulAdd(z, z, across2))), d, out.cosine + at);
    }
    V azimuth = arcTangent(d, hn::Abs(y), hn::Abs(x));
    azimuth = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, std::numbers::pi), azimuth), azimuth);
    azimuth = hn::CopySignToAbs(azimuth, y);
    const V elevation = hn::CopySignToAbs(arcTangent(d, hn::Abs(z), across), z);
    const double perRadian = lattice.width / (2 * std::numbers::pi);
    const double perRadianV = lattice.height / std::numbers::pi;
    hn::StoreU(mulAdd(azimuth, hn::Set(d, -perRadian), hn::Set(d, 0.5 * lattice.width - 0.5)), d, out.u + at);
    hn::StoreU(mulAdd(elevation, hn::Set(d, -perRadianV), hn::Set(d, 0.5 * lattice.height - 0.5)), d,
               out.v + at);
}

void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, double* u, double* v,
                      double* cosine, double* along) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Outputs out{u, v, cosine, along};
    for (int i = 0; i < count; i += lanes) {
        project(d, lattice, hn::LoadU(d, rays.x + i), hn::LoadU(d, rays.y + i), hn::LoadU(d, rays.z + i), out,
                i);
    }
}

void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, double* u, double* v,
                       double* cosine, double* along) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Outputs out{u, v, cosine, along};
    for (int i = 0; i < count; i += lanes) {
        const V x = mulAdd(hn::Iota(d, i), hn::Set(d, row.step), hn::Set(d, row.x));
        project(d, lattice, x, hn::Set(d, row.y), hn::Set(d, 1.0), out, i);
    }
}

/// G, A and J of lattice.h.
struct Motion {
    V speed;
    V acceleration;
    V jerk;
};

/// How a displacement bends rays over a cell: bounds of the quantities of lattice.h.
struct Bending {
    V leastT;
    V t;
    V stretch;   ///< t / r
    V along;     ///< |a|
    V sine;      ///< e
    V overR;     ///< 1 / r
    V curvature; ///< (1 - |p|^2) / r^3
};

HWY_INLINE Bending bending(D d, const Lattice& lattice, V along, V reach) {
    const double* p = lattice.displacement.data();
    const double length2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    const V length = hn::Set(d, std::sqrt(length2));
    const V room = hn::Set(d, 1 - length2);
    const V spread = hn::Mul(length, reach);
    const V least = hn::Max(hn::Sub(along, spread), hn::Neg(length));
    const V greatest = hn::Min(hn::Add(along, spread), length);
    const V absLeast = hn::Max(hn::Zero(d), hn::Max(least, hn::Neg(greatest)));
    const V rOfLeast = hn::Sqrt(mulAdd(least, least, room));
    const V rOfGreatest = hn::Sqrt(mulAdd(greatest, greatest, room));
    Bending b;
    b.leastT = hn::Sub(rOfGreatest, greatest);
    b.t = hn::Sub(rOfLeast, least);
    b.stretch = hn::Div(b.t, rOfLeast);
    b.along = hn::Max(hn::Abs(least), hn::Abs(greatest));
    b.sine = hn::Sqrt(hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, length2), hn::Mul(absLeast, absLeast))));
    b.overR = hn::Div(hn::Set(d, 1.0), hn::Sqrt(mulAdd(absLeast, absLeast, room)));
    b.curvature = hn::Mul(room, hn::Mul(b.overR, hn::Mul(b.overR, b.overR)));
    return b;
}

HWY_INLINE Motion bent(D d, const Bending& b, const Motion& s) {
    const V one = hn::Set(d, 1.0);
    const V three = hn::Set(d, 3.0);
    const V g = s.speed;
    const V g2 = hn::Mul(g, g);
    const V ga = hn::Mul(g, s.acceleration);
    const V a1 = hn::Mul(b.sine, g);
    const V a2 = mulAdd(b.sine, s.acceleration, hn::Mul(b.along, g2));
    const V a3 = mulAdd(b.sine, mulAdd(g2, g, s.jerk), hn::Mul(three, hn::Mul(b.along, ga)));
    const V t1 = hn::Mul(b.stretch, a1);
    const V t2 = mulAdd(b.curvature, hn::Mul(a1, a1), hn::Mul(b.stretch, a2));
    const V cubic = hn::Mul(hn::Mul(b.overR, b.overR), hn::Mul(b.along, hn::Mul(a1, a1)));
    const V t3 = mulAdd(hn::Mul(three, b.curvature), hn::Mul(a1, hn::Add(cubic, a2)), hn::Mul(b.stretch, a3));
    Motion q;
    q.speed = hn::Mul(b.stretch, g);
    const V q2 = hn::Mul(q.speed, q.speed);
    const V change = hn::Mul(
        g2, hn::Max(hn::Sub(hn::Mul(b.stretch, b.stretch), one), hn::Sub(one, hn::Mul(b.leastT, b.leastT))));
    q.acceleration = mulAdd(b.sine, mulAdd(b.t, g2, t2),
                            mulAdd(hn::Mul(hn::Set(d, 2.0), t1), g, hn::Mul(b.t, s.acceleration)));
    const V radial =
        hn::Add(mulAdd(hn::Mul(three, t1), g2, t3), mulAdd(hn::Mul(three, b.t), ga, hn::Mul(q2, t1)));
    q.jerk = mulAdd(b.sine, radial,
                    mulAdd(mulAdd(three, t2, hn::Mul(b.t, change)), g,
                           mulAdd(hn::Mul(three, t1), s.acceleration, hn::Mul(b.t, s.jerk))));
    return q;
}

/// Bounds (2) of lattice.h.
struct ThirdDerivatives {
    V elevation;
    V azimuth; ///< times the cosine of the elevation
};

HWY_INLINE ThirdDerivatives thirdDerivatives(D d, const Motion& q, V tangent) {
    const V t2 = hn::Mul(tangent, tangent);
    const V g3 = hn::Mul(q.speed, hn::Mul(q.speed, q.speed));
    const V common = mulAdd(hn::Mul(hn::Set(d, 3.0), tangent), hn::Mul(q.speed, q.acceleration), q.jerk);
    return {mulAdd(mulAdd(t2, hn::Set(d, 1.155), hn::Set(d, 0.385)), g3, common),
            mulAdd(mulAdd(t2, hn::Set(d, 2.0), hn::Set(d, 0.77)), g3, common)};
}

HWY_INLINE Motion loadMotion(D d, const RayTable& rays, int axis, int cellY, int cellX) {
    return {hn::LoadU(d, rays.motion(axis, 1, cellY) + cellX),
            hn::LoadU(d, rays.motion(axis, 2, cellY) + cellX),
            hn::LoadU(d, rays.motion(axis, 3, cellY) + cellX)};
}

HWY_INLINE V errorBound(D d, const Lattice& lattice, int cellY, int cellX,
                        const LatticeScratch::NodeRow& centre) {
    const V half = hn::Set(d, 0.5 * RayTable::kCell);
    Motion alongX = loadMotion(d, *lattice.rays, 0, cellY, cellX);
    Motion alongY = loadMotion(d, *lattice.rays, 1, cellY, cellX);
    if (lattice.displaced) {
        const V reach = hn::Mul(half, hn::Add(alongX.speed, alongY.speed));
        const Bending b = bending(d, lattice, hn::LoadU(d, centre.centreAlong + cellX), reach);
        alongX = bent(d, b, alongX);
        alongY = bent(d, b, alongY);
    }
    const V reach = hn::Mul(half, hn::Add(alongX.speed, alongY.speed));
    const V cosine = hn::LoadU(d, centre.centreCos + cellX);
    const V least = hn::Max(hn::Sub(cosine, reach), hn::Set(d, 1e-6));
    const V greatest = hn::Min(hn::Add(cosine, reach), hn::Set(d, 1.0));
    const V tangent = hn::Sqrt(hn::Sub(hn::Div(hn::Set(d, 1.0), hn::Mul(least, least)), hn::Set(d, 1.0)));
    const ThirdDerivatives x = thirdDerivatives(d, alongX, tangent);
    const ThirdDerivatives y = thirdDerivatives(d, alongY, tangent);
    constexpr double kStep = RayTable::kNodeStep;
    const double scale =
        kStep * kStep * kStep / (9 * std::numbers::sqrt3) * lattice.width / (2 * std::numbers::pi);
    const V inV = mulAdd(y.elevation, hn::Set(d, 1.25), x.elevation);
    const V inU = hn::Mul(mulAdd(y.azimuth, hn::Set(d, 1.25), x.azimuth), hn::Div(greatest, least));
    return hn::Mul(hn::Set(d, scale), hn::Sqrt(mulAdd(inU, inU, hn::Mul(inV, inV))));
}

/// The coefficients of one coordinate for the cells from `cellX` on. period: of the coordinate, in pixels.
HWY_INLINE void fit(D d, const std::array<const double*, 3>& edges,
                    const std::array<const double*, 3>& centres, double period, float* const* out,
                    int cellX) {
    const hn::Rebind<float, D> df;
    const V middle = hn::LoadU(d, centres[1] + cellX);
    const V turn = hn::Set(d, period);
    const V limit = hn::Set(d, 0.5 * period);
    const auto relative = [&](const double* at) {
        const V difference = hn::Sub(hn::LoadU(d, at), middle);
        const V down = hn::IfThenElseZero(hn::Gt(difference, limit), turn);
        const V up = hn::IfThenElseZero(hn::Lt(difference, hn::Neg(limit)), turn);
        return hn::Add(hn::Sub(difference, down), up);
    };
    const V half = hn::Set(d, 0.5);
    const V unit = hn::Set(d, static_cast<double>(1 << kFractionBits));
    // Left, middle and right to value, slope and curvature; the same along y.
    const auto form = [&](V a, V b, V c, V& slope, V& curvature) {
        slope = hn::Mul(half, hn::Sub(c, a));
        curvature = hn::Sub(hn::Mul(half, hn::Add(c, a)), b);
    };
    V rows[3][3];
    for (std::size_t y = 0; y < 3; ++y) {
        rows[0][y] = relative(centres[y] + cellX);
        form(relative(edges[y] + cellX), rows[0][y], relative(edges[y] + cellX + 1), rows[1][y], rows[2][y]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        V slope;
        V curvature;
        form(rows[i][0], rows[i][1], rows[i][2], slope, curvature);
        hn::StoreU(hn::DemoteTo(df, hn::Mul(unit, rows[i][1])), df, out[3 * i] + cellX);
        hn::StoreU(hn::DemoteTo(df, hn::Mul(unit, slope)), df, out[3 * i + 1] + cellX);
        hn::StoreU(hn::DemoteTo(df, hn::Mul(unit, curvature)), df, out[3 * i + 2] + cellX);
    }
}

void biquadratics(const Lattice& lattice, int cellY, const std::array<LatticeScratch::NodeRow, 3>& rows,
                  const LatticeScratch::Quadratics& out, double* bound) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < lattice.rays->cellsX(); x += lanes) {
        fit(d, {rows[0].edgeU, rows[1].edgeU, rows[2].edgeU},
            {rows[0].centreU, rows[1].centreU, rows[2].centreU}, lattice.width, out.u, x);
        fit(d, {rows[0].edgeV, rows[1].edgeV, rows[2].edgeV},
            {rows[0].centreV, rows[1].centreV, rows[2].centreV}, 4 * lattice.height, out.v, x);
        hn::StoreU(errorBound(d, lattice, cellY, x, rows[1]), d, bound + x);
    }
}

/// Down the pixel rows by forward differences, two additions a value. With 16 fractional bits, rounding the
/// second difference costs at most 2^-17 * 16 * 15 / 2 = 0.001 pixels at the end.
template <int kSize>
HWY_INLINE void fillPatchOf(int n, const std::array<float, 9>& c, std::int32_t base, std::int32_t* out) {
    const hn::CappedTag<float, kSize> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    constexpr float kHalf = 0.5F * (kSize - 1);
    constexpr float kStep = 2.0F / kSize;
    const auto line = [&](std::size_t power, auto s) {
        return mulAdd(s, mulAdd(s, hn::Set(d, c[6 + power]), hn::Set(d, c[3 + power])), hn::Set(d, c[power]));
    };
    const auto inUnits = [&](float pixel, int part) {
        return (pixel + (static_cast<float>(part) + 0.5F) / static_cast<float>(n) - 0.5F - kHalf) * kStep;
    };
    for (int i = 0; i < n; ++i) {
        for (int x = 0; x < kSize; x += lanes) {
            const auto s =
                mulAdd(hn::Iota(d, static_cast<float>(x)), hn::Set(d, kStep), hn::Set(d, inUnits(0, i)));
            const auto value = line(0, s);
            const auto slope = line(1, s);
            const auto curvature = line(2, s);
            const auto second = hn::NearestInt(hn::Mul(hn::Set(d, 2 * kStep * kStep), curvature));
            for (int j = 0; j < n; ++j) {
                const float t = inUnits(0, j);
                auto at = hn::Add(
                    hn::NearestInt(mulAdd(hn::Set(d, t), mulAdd(hn::Set(d, t), curvature, slope), value)),
                    hn::Set(di, base));
                auto first = hn::NearestInt(
                    hn::Mul(hn::Set(d, kStep), mulAdd(hn::Set(d, 2 * t + kStep), curvature, slope)));
                std::int32_t* to = out + (j * n + i) * RayTable::kCell + x;
                for (int y = 0; y < kSize; ++y) {
                    hn::StoreU(at, di, to);
                    at = hn::Add(at, first);
                    first = hn::Add(first, second);
                    to += n * n * RayTable::kCell;
                }
            }
        }
    }
}

void fillPatch(const PatchShape& shape, const std::array<float, 9>& coefficients, std::int32_t base,
               std::int32_t* out) {
    switch (shape.size) {
    case 16:
        return fillPatchOf<16>(shape.samplesPerAxis, coefficients, base, out);
    case 8:
        return fillPatchOf<8>(shape.samplesPerAxis, coefficients, base, out);
    default:
        return fillPatchOf<4>(shape.samplesPerAxis, coefficients, base, out);
    }
}

void toFixed(const double* values, int count, double offset, std::int32_t* out) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const V unit = hn::Set(d, static_cast<double>(1 << kFractionBits));
    for (int i = 0; i < count; i += lanes) {
        const V value = hn::Add(hn::LoadU(d, values + i), hn::Set(d, offset));
        // Positive, so that cutting off after adding a half rounds.
        hn::StoreU(hn::DemoteTo(di, mulAdd(value, unit, hn::Set(d, 0.5))), di, out + i);
    }
}

void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period) {
    const hn::ScalableTag<std::int32_t> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int i = 0; i < count; i += lanes) {
        auto value = hn::LoadU(d, values + i);
        value = hn::Add(value, hn::IfThenElseZero(hn::Lt(value, hn::Set(d, least)), hn::Set(d, period)));
        const auto beyond = hn::Gt(value, hn::Set(d, least + period - 1));
        hn::StoreU(hn::Sub(value, hn::IfThenElseZero(beyond, hn::Set(d, period))), d, values + i);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(photoCoordinates);
HWY_EXPORT(affineCoordinates);
HWY_EXPORT(biquadratics);
HWY_EXPORT(fillPatch);
HWY_EXPORT(toFixed);
HWY_EXPORT(wrapFixed);

void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, double* u, double* v,
                      double* cosine, double* along) {
    HWY_DYNAMIC_DISPATCH(photoCoordinates)(lattice, rays, count, u, v, cosine, along);
}

void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, double* u, double* v,
                       double* cosine, double* along) {
    HWY_DYNAMIC_DISPATCH(affineCoordinates)(lattice, row, count, u, v, cosine, along);
}

void biquadratics(const Lattice& lattice, int cellY, const std::array<LatticeScratch::NodeRow, 3>& rows,
                  const LatticeScratch::Quadratics& out, double* bound) {
    HWY_DYNAMIC_DISPATCH(biquadratics)(lattice, cellY, rows, out, bound);
}

void fillPatch(const PatchShape& shape, const std::array<float, 9>& coefficients, std::int32_t base,
               std::int32_t* out) {
    HWY_DYNAMIC_DISPATCH(fillPatch)(shape, coefficients, base, out);
}

void toFixed(const double* values, int count, double offset, std::int32_t* out) {
    HWY_DYNAMIC_DISPATCH(toFixed)(values, count, offset, out);
}

void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period) {
    HWY_DYNAMIC_DISPATCH(wrapFixed)(values, count, least, period);
}

} // namespace spherewalk::render::simd

#endif
