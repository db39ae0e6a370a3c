// SPDX-License-Identifier: Apache-2.0
#include "sphere/lattice_simd.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sphere/lattice_patches.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

/// Twice what a biquadratic can change, and two pixels: samples lie within the nodes, so that this is safe,
/// and patches at the seam are few.
constexpr double kSeamReach = 2;

/// The biquadratics of one coordinate for the patches from `first` on. edges, centres: of three rows of
/// nodes. period: of the coordinate, in pixels. Back: the sum of the coefficients' magnitudes.
HWY_INLINE V fit(D d, const std::array<const double*, 3>& edges, const std::array<const double*, 3>& centres,
                 double period, const std::array<float*, 9>& out, int first) {
    const hn::Rebind<float, D> df;
    const V middle = hn::LoadU(d, centres[1] + first);
    const V turn = hn::Set(d, period);
    const V limit = hn::Set(d, 0.5 * period);
    const auto relative = [&](const double* at) {
        const V difference = hn::Sub(hn::LoadU(d, at), middle);
        const V down = hn::IfThenElseZero(hn::Gt(difference, limit), turn);
        const V up = hn::IfThenElseZero(hn::Lt(difference, hn::Neg(limit)), turn);
        return hn::Add(hn::Sub(difference, down), up);
    };
    const V half = hn::Set(d, 0.5);
    const V unit = hn::Set(d, double{kFixedOne});
    // Left, middle and right to value, slope and curvature; the same along y.
    const auto form = [&](V a, V b, V c, V& slope, V& curvature) {
        slope = hn::Mul(half, hn::Sub(c, a));
        curvature = hn::Sub(hn::Mul(half, hn::Add(c, a)), b);
    };
    V rows[3][3];
    for (std::size_t y = 0; y < 3; ++y) {
        rows[0][y] = relative(centres[y] + first);
        form(relative(edges[y] + first), rows[0][y], relative(edges[y] + first + 1), rows[1][y], rows[2][y]);
    }
    V magnitude = hn::Zero(d);
    const auto store = [&](V value, std::size_t index) {
        magnitude = hn::Add(magnitude, hn::Abs(value));
        hn::StoreU(hn::DemoteTo(df, hn::Mul(unit, value)), df, out[index] + first);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        V slope;
        V curvature;
        form(rows[i][0], rows[i][1], rows[i][2], slope, curvature);
        store(rows[i][1], 3 * i);
        store(slope, 3 * i + 1);
        store(curvature, 3 * i + 2);
    }
    return magnitude;
}

HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> fixedPoint(D d, V value, double offset) {
    const hn::Rebind<std::int32_t, D> di;
    // Positive, so that cutting off after adding a half rounds.
    const V unit = hn::Set(d, double{kFixedOne});
    return hn::DemoteTo(di, mulAdd(hn::Add(value, hn::Set(d, offset)), unit, hn::Set(d, 0.5)));
}

void fitPatches(const LatticeFrame& frame, const std::array<NodeRow, 3>& rows, int begin, int end,
                const PatchRow& out) {
    const D d;
    const hn::Rebind<std::int32_t, D> di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int i = begin; i < end; i += lanes) {
        const V reach = fit(d, {rows[0].edges.u, rows[1].edges.u, rows[2].edges.u},
                            {rows[0].centres.u, rows[1].centres.u, rows[2].centres.u}, frame.width, out.u, i);
        fit(d, {rows[0].edges.v, rows[1].edges.v, rows[2].edges.v},
            {rows[0].centres.v, rows[1].centres.v, rows[2].centres.v}, 4 * frame.height, out.v, i);
        const V u = hn::LoadU(d, rows[1].centres.u + i);
        hn::StoreU(fixedPoint(d, u, kOffsetU), di, out.centreU + i);
        hn::StoreU(fixedPoint(d, hn::LoadU(d, rows[1].centres.v + i), kOffsetV), di, out.centreV + i);
        const V safe = hn::Mul(hn::Set(d, kSeamReach), hn::Add(reach, hn::Set(d, kSeamReach)));
        const V fromLeft = hn::Sub(hn::Add(u, hn::Set(d, 0.5)), safe);
        const V fromRight = hn::Sub(hn::Sub(hn::Set(d, frame.width - 0.5), u), safe);
        hn::StoreU(hn::Min(fromLeft, fromRight), d, out.fromSeam + i);
    }
}

/// Biquadratics along one line of samples: coefficients of 1, t and t^2.
template <class D>
struct Curve {
    hn::Vec<D> value;
    hn::Vec<D> slope;
    hn::Vec<D> curvature;
};

template <class D>
HWY_INLINE Curve<D> curveAt(D d, hn::Vec<D> s, const std::array<float*, 9>& c, int patch) {
    const auto along = [&](std::size_t power) {
        return mulAdd(s, mulAdd(s, hn::Set(d, c[6 + power][patch]), hn::Set(d, c[3 + power][patch])),
                      hn::Set(d, c[power][patch]));
    };
    return {along(0), along(1), along(2)};
}

/// A coordinate in fixed point and its forward differences.
template <class DI>
struct Steps {
    hn::Vec<DI> at;
    hn::Vec<DI> first;
};

template <class D, class DI = hn::Rebind<std::int32_t, D>>
HWY_INLINE Steps<DI> stepsFrom(D d, const Curve<D>& curve, float t, float step, std::int32_t centre) {
    const auto at = mulAdd(hn::Set(d, t), mulAdd(hn::Set(d, t), curve.curvature, curve.slope), curve.value);
    const auto first =
        hn::Mul(hn::Set(d, step), mulAdd(hn::Set(d, 2 * t + step), curve.curvature, curve.slope));
    return {hn::Add(hn::NearestInt(at), hn::Set(DI(), centre)), hn::NearestInt(first)};
}

/// Where a patch's samples go: as coordinates.
struct ToCoordinates {
    std::int32_t* u;
    std::int32_t* v;

    std::int32_t roundingU() const { return 0; }

    std::int32_t roundingV() const { return 0; }

    template <class DI>
    HWY_INLINE void store(DI d, hn::Vec<DI> atU, hn::Vec<DI> atV, std::ptrdiff_t to) const {
        hn::StoreU(atU, d, u + to);
        hn::StoreU(atV, d, v + to);
    }
};

/// Stores samples as places and fractions.
struct ToPlaces {
    Placing placing;
    std::int32_t* places;
    std::int32_t* fractions;

    std::int32_t roundingU() const { return placing.roundingU; }

    std::int32_t roundingV() const { return placing.roundingV; }

    template <class DI>
    HWY_INLINE void store(DI d, hn::Vec<DI> atU, hn::Vec<DI> atV, std::ptrdiff_t to) const {
        static_assert(PlaneLayout::kPixelBytes == 3);
        const auto column = hn::ShiftRight<kFractionBits>(atU);
        const auto row = hn::ShiftRight<kFractionBits>(atV);
        const auto rowBytes = hn::Mul(row, hn::Set(d, placing.stride * PlaneLayout::kPixelBytes));
        hn::StoreU(hn::Add(rowBytes, hn::Add(column, hn::ShiftLeft<1>(column))), d, places + to);
        const auto right = hn::And(atU, hn::Set(d, (1 << kFractionBits) - 1));
        hn::StoreU(hn::Or(right, hn::ShiftLeft<kFractionBits>(atV)), d, fractions + to);
    }
};

/// Down the pixel rows by forward differences, two additions a value. With 16 fractional bits, rounding the
/// second difference costs at most 2^-17 * 16 * 15 / 2 = 0.001 pixels at the end. offsets: of the first
/// pixel's samples, in half patches from the centre. to: of the patch's first sample.
template <int kSize, class Target>
HWY_INLINE void fillPatch(const PatchRow& row, int patch, int n, const float* offsets, const Target& target,
                          std::ptrdiff_t to) {
    const hn::CappedTag<float, kSize> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    constexpr float kStep = 2.0F / kSize;
    const std::int32_t centreU = row.centreU[patch] + target.roundingU();
    const std::int32_t centreV = row.centreV[patch] + target.roundingV();
    for (int i = 0; i < n; ++i) {
        for (int x = 0; x < kSize; x += lanes) {
            const auto s =
                mulAdd(hn::Iota(d, static_cast<float>(x)), hn::Set(d, kStep), hn::Set(d, offsets[i]));
            const auto curveU = curveAt(d, s, row.u, patch);
            const auto curveV = curveAt(d, s, row.v, patch);
            const auto secondU = hn::NearestInt(hn::Mul(hn::Set(d, 2 * kStep * kStep), curveU.curvature));
            const auto secondV = hn::NearestInt(hn::Mul(hn::Set(d, 2 * kStep * kStep), curveV.curvature));
            for (int j = 0; j < n; ++j) {
                auto u = stepsFrom(d, curveU, offsets[j], kStep, centreU);
                auto v = stepsFrom(d, curveV, offsets[j], kStep, centreV);
                std::ptrdiff_t at = to + (j * n + i) * kCell + x;
                for (int y = 0; y < kSize; ++y, at += n * n * kCell) {
                    target.store(di, u.at, v.at, at);
                    u.at = hn::Add(u.at, u.first);
                    v.at = hn::Add(v.at, v.first);
                    u.first = hn::Add(u.first, secondU);
                    v.first = hn::Add(v.first, secondV);
                }
            }
        }
    }
}

template <int kSize, class Target>
HWY_INLINE void fillCellOf(const PatchRow* rows, int cellX, int n, const Target& target) {
    constexpr int kParts = kCell / kSize;
    std::array<float, 8> offsets{};
    for (int i = 0; i < n; ++i) {
        offsets[static_cast<std::size_t>(i)] =
            ((static_cast<float>(i) + 0.5F) / static_cast<float>(n) - 0.5F * kSize) * (2.0F / kSize);
    }
    for (int i = 0; i < kParts * kParts; ++i) {
        const int to = i / kParts * kSize * n * n * kCell + i % kParts * kSize;
        fillPatch<kSize>(rows[i / kParts], kParts * cellX + i % kParts, n, offsets.data(), target, to);
    }
}

template <class Target>
HWY_INLINE void fillCell(const PatchRow* rows, int parts, int cellX, int n, const Target& target) {
    switch (parts) {
    case 1:
        return fillCellOf<16>(rows, cellX, n, target);
    case 2:
        return fillCellOf<8>(rows, cellX, n, target);
    default:
        return fillCellOf<4>(rows, cellX, n, target);
    }
}

void fillCoordinates(const PatchRow* rows, int parts, int cellX, int n, std::int32_t* u, std::int32_t* v) {
    fillCell(rows, parts, cellX, n, ToCoordinates{u, v});
}

void fillPlaces(const PatchRow* rows, int parts, int cellX, int n, const Placing& placing,
                std::int32_t* places, std::int32_t* fractions) {
    fillCell(rows, parts, cellX, n, ToPlaces{placing, places, fractions});
}

void locate(const Placing& placing, int count, std::int32_t* u, std::int32_t* v) {
    const hn::ScalableTag<std::int32_t> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const ToPlaces target{placing, u, v};
    for (int i = 0; i < count; i += lanes) {
        target.store(d, hn::Add(hn::LoadU(d, u + i), hn::Set(d, placing.roundingU)),
                     hn::Add(hn::LoadU(d, v + i), hn::Set(d, placing.roundingV)), i);
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

HWY_EXPORT(fitPatches);
HWY_EXPORT(fillCoordinates);
HWY_EXPORT(fillPlaces);
HWY_EXPORT(locate);
HWY_EXPORT(wrapFixed);

void fitPatches(const LatticeFrame& frame, const std::array<NodeRow, 3>& rows, int begin, int end,
                const PatchRow& out) {
    HWY_DYNAMIC_DISPATCH(fitPatches)(frame, rows, begin, end, out);
}

void fillCoordinates(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, std::int32_t* u,
                     std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(fillCoordinates)(rows, parts, cellX, samplesPerAxis, u, v);
}

void fillPlaces(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, const Placing& placing,
                std::int32_t* places, std::int32_t* fractions) {
    HWY_DYNAMIC_DISPATCH(fillPlaces)(rows, parts, cellX, samplesPerAxis, placing, places, fractions);
}

void locate(const Placing& placing, int count, std::int32_t* u, std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(locate)(placing, count, u, v);
}

void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period) {
    HWY_DYNAMIC_DISPATCH(wrapFixed)(values, count, least, period);
}

} // namespace spherewalk::render::simd

#endif
