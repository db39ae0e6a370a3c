// SPDX-License-Identifier: Apache-2.0
#include "lattice_simd.h"

#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lattice_simd.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

/// A quotient brought to [-tan(pi/8), tan(pi/8)].
struct Reduced {
    V t;
    V quarter;           ///< to be added to the arc tangent
    hn::Mask<D> isSteep; ///< the result is to be taken from pi/2
};

/// By atan(1/t) = pi/2 - atan(t) to [0, 1], and further by atan(t) = pi/4 + atan((t - 1) / (t + 1)).
HWY_INLINE Reduced reduced(D d, V numerator, V denominator) {
    const V least = hn::Min(numerator, denominator);
    const V greatest = hn::Max(numerator, denominator);
    const auto upper = hn::Gt(least, hn::Mul(greatest, hn::Set(d, 0.41421356237309503)));
    const V top = hn::IfThenElse(upper, hn::Sub(least, greatest), least);
    const V bottom = hn::IfThenElse(upper, hn::Add(least, greatest), greatest);
    return {hn::Div(top, hn::Max(bottom, hn::Set(d, 1e-300))),
            hn::IfThenElseZero(upper, hn::Set(d, std::numbers::pi / 4)), hn::Gt(numerator, denominator)};
}

/// The arc tangent of what was reduced, in [0, pi/2], off by less than 4e-16.
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

/// A lattice's numbers, where no store can change them.
struct Projector {
    explicit Projector(const Lattice& lattice)
        : m(lattice.photoFromRay),
          p(lattice.displacement),
          isDisplaced(lattice.displaced),
          room(1 - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])),
          perRadianU(lattice.width / (2 * std::numbers::pi)),
          perRadianV(lattice.height / std::numbers::pi),
          middleU(0.5 * lattice.width - 0.5),
          middleV(0.5 * lattice.height - 0.5) {}

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

// In steps, each of which ends with what takes longest (roots, quotients): two vectors of rays that take them
// in turns hardly wait.

HWY_INLINE Direction turned(D d, const Projector& by, const Direction& ray) {
    const double* m = by.m.data();
    return {product(d, m, ray.x, ray.y, ray.z), product(d, m + 3, ray.x, ray.y, ray.z),
            product(d, m + 6, ray.x, ray.y, ray.z)};
}

/// Of a ray from a displaced camera to the sphere: directionOnSphere() for rays of any length.
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

/// Two vectors of rays, to be stored at these places.
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

/// rays(i): those from the i-th on.
template <class Rays>
HWY_INLINE void projectAll(const Lattice& lattice, const Rays& rays, int count, const NodeValues& out) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const Projector projector(lattice);
    const NodeValues to = out;
    for (int i = 0; i < count; i += 2 * lanes) {
        const int second = i + lanes < count ? i + lanes : i; // an odd one is done twice
        project(d, projector, rays(i), rays(second), to, i, second);
    }
}

void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, const NodeValues& out) {
    const D d;
    projectAll(
        lattice,
        [&](int i) {
            return Direction{hn::LoadU(d, rays.x + i), hn::LoadU(d, rays.y + i), hn::LoadU(d, rays.z + i)};
        },
        count, out);
}

void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, const NodeValues& out) {
    const D d;
    projectAll(
        lattice,
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
    const V unit = hn::Set(d, static_cast<double>(1 << kFractionBits));
    for (int i = 0; i < count; i += lanes) {
        const V value = hn::Add(hn::LoadU(d, values + i), hn::Set(d, offset));
        // Positive, so that cutting off after adding a half rounds.
        hn::StoreU(hn::DemoteTo(di, mulAdd(value, unit, hn::Set(d, 0.5))), di, out + i);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(photoCoordinates);
HWY_EXPORT(affineCoordinates);
HWY_EXPORT(toFixed);

void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, const NodeValues& out) {
    HWY_DYNAMIC_DISPATCH(photoCoordinates)(lattice, rays, count, out);
}

void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, const NodeValues& out) {
    HWY_DYNAMIC_DISPATCH(affineCoordinates)(lattice, row, count, out);
}

void toFixed(const double* values, int count, double offset, std::int32_t* out) {
    HWY_DYNAMIC_DISPATCH(toFixed)(values, count, offset, out);
}

} // namespace spherewalk::render::simd

#endif
