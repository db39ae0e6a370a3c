// SPDX-License-Identifier: Apache-2.0
#include "sphere/lattice_simd.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sphere/lattice_simd.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

/// A quotient, brought to [-tan(pi/8), tan(pi/8)].
struct Reduced {
    V t;
    V quarter;           ///< This is added to the arc tangent.
    hn::Mask<D> isSteep; ///< Whether the result is taken from pi/2.
};

/// atan(1/t) = pi/2 - atan(t) brings it to [0, 1], and atan(t) = pi/4 + atan((t - 1) / (t + 1)) further.
HWY_INLINE Reduced reduced(D d, V numerator, V denominator) {
    const V least = hn::Min(numerator, denominator);
    const V greatest = hn::Max(numerator, denominator);
    const auto upper = hn::Gt(least, hn::Mul(greatest, hn::Set(d, 0.41421356237309503)));
    const V top = hn::IfThenElse(upper, hn::Sub(least, greatest), least);
    const V bottom = hn::IfThenElse(upper, hn::Add(least, greatest), greatest);
    return {hn::Div(top, hn::Max(bottom, hn::Set(d, 1e-300))),
            hn::IfThenElseZero(upper, hn::Set(d, std::numbers::pi / 4)), hn::Gt(numerator, denominator)};
}

/// The arc tangent of a reduced quotient, in [0, pi/2], with an error below 4e-16.
HWY_INLINE V arcTangent(D d, const Reduced& from) {
    // An interpolation of atan(sqrt z) / sqrt(z) at eleven Chebyshev points in z is off by less than 4e-17.
    // In pairs, so that the terms do not wait for each other.
    const V z = hn::Mul(from.t, from.t);
    const V z2 = hn::Mul(z, z);
    const V z4 = hn::Mul(z2, z2);
    const auto pair = [&](double low, double high) { return mulAdd(hn::Set(d, high), z, hn::Set(d, low)); };
    const V low = mulAdd(pair(0.199999999988551, -0.1428571418097571), z2, pair(1.0, -0.3333333333332844));
    const V middle = mulAdd(pair(0.07689953486227682, -0.06640233842869744), z2,
                            pair(0.11111106180425145, -0.09090773074092884));
    const V high =
        mulAdd(hn::Set(d, 0.02113535694575133), z2, pair(0.056883487686028446, -0.04348050891958043));
    const V sum = mulAdd(mulAdd(high, z4, middle), z4, low);
    const V angle = hn::Add(hn::Mul(from.t, sum), from.quarter);
    return hn::IfThenElse(from.isSteep, hn::Sub(hn::Set(d, std::numbers::pi / 2), angle), angle);
}

HWY_INLINE V product(D d, const double* row, V x, V y, V z) {
    return mulAdd(hn::Set(d, row[0]), x, mulAdd(hn::Set(d, row[1]), y, hn::Mul(hn::Set(d, row[2]), z)));
}

/// The numbers of a frame, where no store can change them.
struct Projector {
    explicit Projector(const LatticeFrame& frame)
        : m(frame.photoFromRay),
          p(frame.displacement),
          isDisplaced(frame.displaced),
          room(1 - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])),
          perRadianU(frame.width / (2 * std::numbers::pi)),
          perRadianV(frame.height / std::numbers::pi),
          middleU(0.5 * frame.width - 0.5),
          middleV(0.5 * frame.height - 0.5) {}

    std::array<double, 9> m;
    std::array<double, 3> p;
    bool isDisplaced;
    double room;
    double perRadianU, perRadianV;
    double middleU, middleV;
};

struct Direction {
    V x;
    V y;
    V z;
};

// Each step ends with its slowest operation, a root or a quotient. Two vectors of rays take the steps in
// turns, so that they hardly wait.

HWY_INLINE Direction turned(D d, const Projector& by, const Direction& ray) {
    const double* m = by.m.data();
    return {product(d, m, ray.x, ray.y, ray.z), product(d, m + 3, ray.x, ray.y, ray.z),
            product(d, m + 6, ray.x, ray.y, ray.z)};
}

/// How a ray goes from a displaced camera to the sphere: directionOnSphere() for rays of any length.
struct Hit {
    V square;
    V along;
    V root;
};

HWY_INLINE Hit hit(D d, const Projector& by, const Direction& s) {
    const V square = mulAdd(s.x, s.x, mulAdd(s.y, s.y, hn::Mul(s.z, s.z)));
    const V along = product(d, by.p.data(), s.x, s.y, s.z);
    return {square, along, hn::Sqrt(mulAdd(along, along, hn::Mul(square, hn::Set(d, by.room))))};
}

HWY_INLINE V distance(D d, const Projector& by, const Hit& h) {
    const auto ahead = hn::Gt(h.along, hn::Zero(d));
    return hn::Div(hn::IfThenElse(ahead, hn::Set(d, by.room), hn::Sub(h.root, h.along)),
                   hn::IfThenElse(ahead, hn::Add(h.root, h.along), h.square));
}

HWY_INLINE Direction met(D d, const Projector& by, const Direction& s, V t) {
    return {mulAdd(t, s.x, hn::Set(d, by.p[0])), mulAdd(t, s.y, hn::Set(d, by.p[1])),
            mulAdd(t, s.z, hn::Set(d, by.p[2]))};
}

HWY_INLINE V across(const Direction& q) {
    return hn::Sqrt(mulAdd(q.x, q.x, hn::Mul(q.y, q.y)));
}

HWY_INLINE void store(D d, const Projector& by, const Direction& q, const Reduced& azimuth,
                      const Reduced& elevation, const NodeValues& out, int at) {
    V u = arcTangent(d, azimuth);
    u = hn::IfThenElse(hn::Lt(q.x, hn::Zero(d)), hn::Sub(hn::Set(d, std::numbers::pi), u), u);
    u = hn::CopySignToAbs(u, q.y);
    const V v = hn::CopySignToAbs(arcTangent(d, elevation), q.z);
    hn::StoreU(mulAdd(u, hn::Set(d, -by.perRadianU), hn::Set(d, by.middleU)), d, out.u + at);
    hn::StoreU(mulAdd(v, hn::Set(d, -by.perRadianV), hn::Set(d, by.middleV)), d, out.v + at);
}

HWY_INLINE void storeForBound(D d, const Direction& q, V acrossQ, const NodeValues& out, int at) {
    const V square = mulAdd(q.z, q.z, hn::Mul(acrossQ, acrossQ));
    hn::StoreU(hn::Div(acrossQ, hn::Sqrt(square)), d, out.cosine + at);
}

/// Projects two vectors of rays. atA, atB: where in `out` they are stored.
HWY_INLINE void project(D d, const Projector& by, const Direction& rayA, const Direction& rayB,
                        const NodeValues& out, int atA, int atB) {
    Direction a = turned(d, by, rayA);
    Direction b = turned(d, by, rayB);
    if (by.isDisplaced) {
        const Hit hitA = hit(d, by, a);
        const Hit hitB = hit(d, by, b);
        const V tA = distance(d, by, hitA);
        const V tB = distance(d, by, hitB);
        if (out.along != nullptr) {
            hn::StoreU(hn::Div(hitA.along, hn::Sqrt(hitA.square)), d, out.along + atA);
            hn::StoreU(hn::Div(hitB.along, hn::Sqrt(hitB.square)), d, out.along + atB);
        }
        a = met(d, by, a, tA);
        b = met(d, by, b, tB);
    }
    const V acrossA = across(a);
    const V acrossB = across(b);
    const Reduced azimuthA = reduced(d, hn::Abs(a.y), hn::Abs(a.x));
    const Reduced azimuthB = reduced(d, hn::Abs(b.y), hn::Abs(b.x));
    const Reduced elevationA = reduced(d, hn::Abs(a.z), acrossA);
    const Reduced elevationB = reduced(d, hn::Abs(b.z), acrossB);
    if (out.cosine != nullptr) {
        storeForBound(d, a, acrossA, out, atA);
        storeForBound(d, b, acrossB, out, atB);
    }
    store(d, by, a, azimuthA, elevationA, out, atA);
    store(d, by, b, azimuthB, elevationB, out, atB);
}

/// rays(i): a vector of rays from the i-th on.
template <class Rays>
HWY_INLINE void projectAll(const LatticeFrame& frame, const Rays& rays, int count, const NodeValues& out) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Projector projector(frame);
    const NodeValues to = out;
    for (int i = 0; i < count; i += 2 * lanes) {
        const int second = i + lanes < count ? i + lanes : i; // an odd one is done twice
        project(d, projector, rays(i), rays(second), to, i, second);
    }
}

void photoCoordinates(const LatticeFrame& frame, const RayArrays& rays, int count, const NodeValues& out) {
    const D d;
    projectAll(
        frame,
        [&](int i) {
            return Direction{hn::LoadU(d, rays.x + i), hn::LoadU(d, rays.y + i), hn::LoadU(d, rays.z + i)};
        },
        count, out);
}

void affineCoordinates(const LatticeFrame& frame, const PixelRow& row, int count, const NodeValues& out) {
    const D d;
    projectAll(
        frame,
        [&](int i) {
            return Direction{mulAdd(hn::Iota(d, i), hn::Set(d, row.step), hn::Set(d, row.x)),
                             hn::Set(d, row.y), hn::Set(d, 1.0)};
        },
        count, out);
}

void toFixed(const double* values, int count, double offset, std::int32_t* out) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const V unit = hn::Set(d, double{kFixedOne});
    for (int i = 0; i < count; i += lanes) {
        const V value = hn::Add(hn::LoadU(d, values + i), hn::Set(d, offset));
        // Positive, so that cutting off after adding a half rounds.
        hn::StoreU(hn::DemoteTo(di, mulAdd(value, unit, hn::Set(d, 0.5))), di, out + i);
    }
}

/// G, A and J of "The bound" in resources/docs/render.md.
struct Motion {
    V speed;
    V acceleration;
    V jerk;
};

/// How a displacement bends rays over a cell: bounds of the quantities of "The bound".
struct Bending {
    V leastT;
    V t;
    V stretch;   ///< t / r
    V along;     ///< |a|
    V sine;      ///< e
    V overR;     ///< 1 / r
    V curvature; ///< (1 - |p|^2) / r^3
};

HWY_INLINE Bending bending(D d, const LatticeFrame& frame, V along, V reach) {
    const double* p = frame.displacement.data();
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

/// The bounds (2) of "The bound".
struct ThirdDerivatives {
    V elevation;
    V azimuth; ///< This is multiplied by the cosine of the elevation.
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

HWY_INLINE V errorBound(D d, const LatticeFrame& frame, int cellY, int cellX, const NodeValues& centre) {
    const V half = hn::Set(d, 0.5 * kCell);
    Motion alongX = loadMotion(d, *frame.rays, 0, cellY, cellX);
    Motion alongY = loadMotion(d, *frame.rays, 1, cellY, cellX);
    if (frame.displaced) {
        const V reach = hn::Mul(half, hn::Add(alongX.speed, alongY.speed));
        const Bending b = bending(d, frame, hn::LoadU(d, centre.along + cellX), reach);
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
        kStep * kStep * kStep / (9 * std::numbers::sqrt3) * frame.width / (2 * std::numbers::pi);
    const V inV = mulAdd(y.elevation, hn::Set(d, 1.25), x.elevation);
    const V inU = hn::Mul(mulAdd(y.azimuth, hn::Set(d, 1.25), x.azimuth), hn::Div(greatest, least));
    return hn::Mul(hn::Set(d, scale), hn::Sqrt(mulAdd(inU, inU, hn::Mul(inV, inV))));
}

void errorBounds(const LatticeFrame& frame, int cellY, const NodeValues& centres, double* bound) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < frame.rays->cellsX(); x += lanes) {
        hn::StoreU(errorBound(d, frame, cellY, x, centres), d, bound + x);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(photoCoordinates);
HWY_EXPORT(affineCoordinates);
HWY_EXPORT(toFixed);

void photoCoordinates(const LatticeFrame& frame, const RayArrays& rays, int count, const NodeValues& out) {
    HWY_DYNAMIC_DISPATCH(photoCoordinates)(frame, rays, count, out);
}

void affineCoordinates(const LatticeFrame& frame, const PixelRow& row, int count, const NodeValues& out) {
    HWY_DYNAMIC_DISPATCH(affineCoordinates)(frame, row, count, out);
}

void toFixed(const double* values, int count, double offset, std::int32_t* out) {
    HWY_DYNAMIC_DISPATCH(toFixed)(values, count, offset, out);
}

HWY_EXPORT(errorBounds);

void errorBounds(const LatticeFrame& frame, int cellY, const NodeValues& centres, double* bound) {
    HWY_DYNAMIC_DISPATCH(errorBounds)(frame, cellY, centres, bound);
}

} // namespace spherewalk::render::simd

#endif
