// SPDX-License-Identifier: Apache-2.0
#include "lattice_simd.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lattice_bound.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

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

HWY_INLINE V errorBound(D d, const Lattice& lattice, int cellY, int cellX, const NodeValues& centre) {
    const V half = hn::Set(d, 0.5 * RayTable::kCell);
    Motion alongX = loadMotion(d, *lattice.rays, 0, cellY, cellX);
    Motion alongY = loadMotion(d, *lattice.rays, 1, cellY, cellX);
    if (lattice.displaced) {
        const V reach = hn::Mul(half, hn::Add(alongX.speed, alongY.speed));
        const Bending b = bending(d, lattice, hn::LoadU(d, centre.along + cellX), reach);
        alongX = bent(d, b, alongX);
        alongY = bent(d, b, alongY);
    }
    const V reach = hn::Mul(half, hn::Add(alongX.speed, alongY.speed));
    const V cosine = hn::LoadU(d, centre.cosine + cellX);
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

void errorBounds(const Lattice& lattice, int cellY, const NodeValues& centres, double* bound) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < lattice.rays->cellsX(); x += lanes) {
        hn::StoreU(errorBound(d, lattice, cellY, x, centres), d, bound + x);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(errorBounds);

void errorBounds(const Lattice& lattice, int cellY, const NodeValues& centres, double* bound) {
    HWY_DYNAMIC_DISPATCH(errorBounds)(lattice, cellY, centres, bound);
}

} // namespace spherewalk::render::simd

#endif
