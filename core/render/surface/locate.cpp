// SPDX-License-Identifier: Apache-2.0
#include "pixels/fixed_point.h"
#include "pixels/photo_plane.h"
#include "surface/coordinates.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/locate.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
using I = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<I>;

constexpr auto kPi = std::numbers::pi_v<float>;
constexpr float kOne = kFixedOne;
constexpr auto kAddU = static_cast<float>(PlaneLayout::kGuard + kRoundingU - 0.5);
constexpr auto kAddV = static_cast<float>(PlaneLayout::kGuard - 0.5);

/// The arc tangent of t in [0, 1], off by less than 2e-7. Source: Abramowitz and Stegun 4.4.49.
HWY_INLINE VF arcTangent(F d, VF t) {
    const VF s = hn::Mul(t, t);
    VF sum = hn::Set(d, 0.0028662257F);
    for (const float term : {-0.0161657367F, 0.0429096138F, -0.0752896400F, 0.1065626393F, -0.1420889944F,
                             0.1999355085F, -0.3333314528F}) {
        sum = mulAdd(sum, s, hn::Set(d, term));
    }
    return mulAdd(hn::Mul(t, s), sum, t);
}

/// atan2.
HWY_INLINE VF angle(F d, VF y, VF x) {
    const VF across = hn::Abs(x);
    const VF up = hn::Abs(y);
    const VF quotient = hn::Div(hn::Min(across, up), hn::Add(hn::Max(across, up), hn::Set(d, 1e-30F)));
    VF result = arcTangent(d, quotient);
    result = hn::IfThenElse(hn::Gt(up, across), hn::Sub(hn::Set(d, 0.5F * kPi), result), result);
    result = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, kPi), result), result);
    return hn::IfThenElse(hn::Lt(y, hn::Zero(d)), hn::Neg(result), result);
}

/// The direction's x from the lens that sees it. side: a value with the sign of that lens.
HWY_INLINE VF fromLens(VF x, VF side, VF w, float aheadM) {
    const F d;
    const VF ahead = hn::Mul(w, hn::Set(d, aheadM));
    return hn::Sub(x, hn::IfThenElse(hn::Lt(side, hn::Zero(d)), hn::Neg(ahead), ahead));
}

void locate(const PhotoTarget& target, const std::array<CellRays, 3>& rays, const float* inverse,
            std::ptrdiff_t pitch, std::int32_t* u, std::int32_t* v) {
    const F d;
    const I di;
    const std::array<float, 9> m = target.m;
    const VF perRadian = hn::Set(d, target.perRadian);
    const VF lastU = hn::Set(d, target.lastU);
    const VF lastV = hn::Set(d, target.lastV);
    for (int row = 0; row < kCell; ++row) {
        for (std::size_t i = 0; i < kCell; i += hn::Lanes(d)) {
            const VF rx = hn::LoadU(d, rays[0].first + row * rays[0].pitch + i);
            const VF ry = hn::LoadU(d, rays[1].first + row * rays[1].pitch + i);
            const VF rz = hn::LoadU(d, rays[2].first + row * rays[2].pitch + i);
            const VF w = hn::LoadU(d, inverse + row * pitch + i);
            const auto component = [&](std::size_t k) {
                const VF turned =
                    mulAdd(hn::Set(d, m[3 * k]), rx,
                           mulAdd(hn::Set(d, m[3 * k + 1]), ry, hn::Mul(hn::Set(d, m[3 * k + 2]), rz)));
                return mulAdd(w, hn::Set(d, target.offset[k]), turned);
            };
            const VF middle = component(0);
            const VF x = fromLens(middle, middle, w, target.aheadM);
            const VF y = component(1);
            const VF z = component(2);
            const VF azimuth = angle(d, y, x);
            const VF elevation = angle(d, z, hn::Sqrt(mulAdd(x, x, hn::Mul(y, y))));
            const VF column = mulAdd(hn::Sub(hn::Set(d, kPi), azimuth), perRadian, hn::Set(d, kAddU));
            const VF line = mulAdd(hn::Sub(hn::Set(d, 0.5F * kPi), elevation), perRadian, hn::Set(d, kAddV));
            const std::size_t to = static_cast<std::size_t>(row * kCell) + i;
            hn::StoreU(hn::ConvertTo(di, hn::Mul(hn::Min(column, lastU), hn::Set(d, kOne))), di, u + to);
            hn::StoreU(hn::ConvertTo(di, hn::Mul(hn::Min(line, lastV), hn::Set(d, kOne))), di, v + to);
        }
    }
}

/// Values at three nodes to value, slope and curvature.
HWY_INLINE void form(VF& a, VF& b, VF& c) {
    const F d;
    const VF half = hn::Set(d, 0.5F);
    const VF slope = hn::Mul(half, hn::Sub(c, a));
    c = hn::Sub(hn::Mul(half, hn::Add(c, a)), b);
    a = b;
    b = slope;
}

HWY_INLINE void fitTerms(std::array<VF, CellFits::kTerms>& f, float unit, float* out, std::size_t pitch) {
    const F d;
    for (const std::size_t step : {std::size_t{1}, std::size_t{3}, std::size_t{9}}) {
        for (std::size_t i = 0; i < f.size(); ++i) {
            if (i / step % 3 == 0) {
                form(f[i], f[i + step], f[i + 2 * step]);
            }
        }
    }
    for (std::size_t i = 0; i < f.size(); ++i) {
        hn::StoreU(hn::Mul(f[i], hn::Set(d, unit)), d, out + i * pitch);
    }
}

/// The bound of CellFits. length, across: of the direction at the middle, and of what is horizontal of it.
HWY_INLINE VF errorBound(const PhotoTarget& target, const NodeRays& rays, VF length, VF across, VF halfSpan) {
    const F d;
    constexpr float kNode = NodeRays::kNodes[1];
    const std::array<float, 3>& o = target.offset;
    const VF alongW = hn::Mul(halfSpan, hn::Set(d, std::sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2])));
    const float aside = (kCell - 1 - kNode) * (rays.stepX + rays.stepY);
    const VF reach = hn::Add(alongW, hn::Set(d, aside));
    const VF nearest = hn::Sub(length, reach); // what is not positive makes the bound infinite
    const VF inverse = hn::Div(hn::Set(d, 1.0F), hn::Max(nearest, hn::Set(d, 1e-20F)));
    const VF turn = hn::Mul(reach, inverse);
    const VF cosine = hn::Div(across, length);
    const VF least = hn::Max(hn::Sub(cosine, turn), hn::Set(d, 1e-6F));
    const VF greatest = hn::Min(hn::Add(cosine, turn), hn::Set(d, 1.0F));
    const VF t2 = hn::Sub(hn::Div(hn::Set(d, 1.0F), hn::Mul(least, least)), hn::Set(d, 1.0F));
    const VF common = mulAdd(hn::Set(d, 3.0F), hn::Sqrt(hn::Max(t2, hn::Zero(d))), hn::Set(d, 2.0F));
    const VF inV = hn::Add(common, mulAdd(t2, hn::Set(d, 1.155F), hn::Set(d, 0.385F)));
    const VF inU =
        hn::Mul(hn::Add(common, mulAdd(t2, hn::Set(d, 2.0F), hn::Set(d, 0.77F))), hn::Div(greatest, least));
    const auto cube = [](VF g) { return hn::Mul(g, hn::Mul(g, g)); };
    constexpr float kEnlarged = 1.61F;
    const VF cubes =
        mulAdd(cube(hn::Mul(alongW, inverse)), hn::Set(d, kEnlarged * kEnlarged),
               mulAdd(cube(hn::Mul(hn::Set(d, kNode * rays.stepY), inverse)), hn::Set(d, kEnlarged),
                      cube(hn::Mul(hn::Set(d, kNode * rays.stepX), inverse))));
    const float scale = target.perRadian / (9 * std::numbers::sqrt3_v<float>);
    return hn::Mul(hn::Mul(cubes, hn::Set(d, scale)), hn::Sqrt(mulAdd(inU, inU, hn::Mul(inV, inV))));
}

/// A component of the direction from the photo's middle, for the ray (x, y, 1).
HWY_INLINE VF fromMiddle(const PhotoTarget& target, std::size_t k, VF x, VF y, VF w) {
    const F d;
    const VF turned = mulAdd(hn::Set(d, target.m[3 * k]), x,
                             mulAdd(hn::Set(d, target.m[3 * k + 1]), y, hn::Set(d, target.m[3 * k + 2])));
    return mulAdd(w, hn::Set(d, target.offset[k]), turned);
}

void fit(const PhotoTarget& given, const NodeRays& rays, const float* least, const float* greatest,
         std::span<const std::uint8_t> isWanted, CellFits& fits) {
    const F d;
    const I di;
    const PhotoTarget target = given; // which no store can change
    const VF half = hn::Set(d, 0.5F);
    for (std::size_t cell = 0; cell < isWanted.size(); cell += hn::Lanes(d)) {
        if (std::memchr(&isWanted[cell], 1, std::min(hn::Lanes(d), isWanted.size() - cell)) == nullptr) {
            continue;
        }
        const VF from = hn::LoadU(d, least + cell);
        const VF to = hn::LoadU(d, greatest + cell);
        const VF middle = hn::Mul(half, hn::Add(from, to));
        const VF halfSpan = hn::Mul(half, hn::Sub(to, from));
        const std::array<VF, 3> w{from, middle, to};
        std::array<VF, CellFits::kTerms> u;
        std::array<VF, CellFits::kTerms> v;
        VF lengthOfMiddle = hn::Zero(d);
        VF acrossOfMiddle = lengthOfMiddle;
        constexpr std::size_t kMiddle = CellFits::kTerms / 2;
        // All of a cell is seen by the lens that sees its middle, or else the cell is not fitted.
        const VF side = fromMiddle(target, 0, hn::LoadU(d, rays.x[1] + cell), hn::Set(d, rays.y[1]), middle);
        VF leastSame = hn::Set(d, 1.0F);
        for (std::size_t i = 0; i < CellFits::kTerms; ++i) {
            const VF rx = hn::LoadU(d, rays.x[i % 3] + cell);
            const VF ry = hn::Set(d, rays.y[i / 3 % 3]);
            const VF ahead = fromMiddle(target, 0, rx, ry, w[i / 9]);
            const VF x = fromLens(ahead, side, w[i / 9], target.aheadM);
            const VF y = fromMiddle(target, 1, rx, ry, w[i / 9]);
            const VF z = fromMiddle(target, 2, rx, ry, w[i / 9]);
            leastSame = hn::Min(leastSame, hn::IfThenElse(hn::Lt(side, hn::Zero(d)), hn::Neg(ahead), ahead));
            const VF across2 = mulAdd(x, x, hn::Mul(y, y));
            const VF across = hn::Sqrt(across2);
            u[i] = angle(d, y, x);
            v[i] = angle(d, z, across);
            if (i == kMiddle) {
                lengthOfMiddle = hn::Sqrt(mulAdd(z, z, across2));
                acrossOfMiddle = across;
            }
        }
        const VF bound = errorBound(target, rays, lengthOfMiddle, acrossOfMiddle, halfSpan);
        const VF seam = target.aheadM != 0 ? hn::Zero(d) : hn::Set(d, -HUGE_VALF);
        hn::StoreU(hn::IfThenElse(hn::Lt(leastSame, seam), hn::Set(d, HUGE_VALF), bound), d,
                   fits.errorPx.data() + cell);
        hn::StoreU(middle, d, fits.inverse.data() + cell);
        hn::StoreU(hn::Div(hn::Set(d, 1.0F), hn::Max(halfSpan, hn::Set(d, 1e-20F))), d,
                   fits.perSpan.data() + cell);
        const VF azimuth = u[kMiddle];
        const VF elevation = v[kMiddle];
        const VF perRadian = hn::Set(d, target.perRadian);
        const VF column = mulAdd(hn::Sub(hn::Set(d, kPi), azimuth), perRadian, hn::Set(d, kAddU));
        const VF line = mulAdd(hn::Sub(hn::Set(d, 0.5F * kPi), elevation), perRadian, hn::Set(d, kAddV));
        hn::StoreU(hn::NearestInt(hn::Mul(column, hn::Set(d, kOne))), di, fits.middleU.data() + cell);
        hn::StoreU(hn::NearestInt(hn::Mul(line, hn::Set(d, kOne))), di, fits.middleV.data() + cell);
        for (std::size_t i = 0; i < CellFits::kTerms; ++i) {
            const VF more = hn::Sub(u[i], azimuth);
            const VF down = hn::IfThenElseZero(hn::Gt(more, hn::Set(d, kPi)), hn::Set(d, 2 * kPi));
            const VF up = hn::IfThenElseZero(hn::Lt(more, hn::Set(d, -kPi)), hn::Set(d, 2 * kPi));
            u[i] = hn::Add(hn::Sub(more, down), up);
            v[i] = hn::Sub(v[i], elevation);
        }
        fitTerms(u, -target.perRadian * kOne, fits.u.data() + cell, fits.pitch);
        fitTerms(v, -target.perRadian * kOne, fits.v.data() + cell, fits.pitch);
    }
}

/// Along columns of pixels: a quadratic in y by its forward differences.
struct Column {
    VF at;
    VF first;
    VF second;
};

HWY_INLINE Column columnOf(VF x, const float* terms, std::size_t pitch) {
    const F d;
    const auto along = [&](std::size_t j) {
        const float* of = terms + 3 * j * pitch;
        return mulAdd(x, mulAdd(x, hn::Set(d, of[2 * pitch]), hn::Set(d, of[pitch])), hn::Set(d, of[0]));
    };
    constexpr float kStep = 1.0F / NodeRays::kNodes[1];
    const VF slope = along(1);
    const VF curvature = along(2);
    return {hn::Add(hn::Sub(along(0), slope), curvature),
            mulAdd(hn::Set(d, kStep), slope, hn::Mul(hn::Set(d, kStep * kStep - 2 * kStep), curvature)),
            hn::Mul(hn::Set(d, 2 * kStep * kStep), curvature)};
}

HWY_INLINE void step(Column& column) {
    column.at = hn::Add(column.at, column.first);
    column.first = hn::Add(column.first, column.second);
}

void locateFitted(const CellFits& fits, int cell, const float* inverse, std::ptrdiff_t pitch, std::int32_t* u,
                  std::int32_t* v) {
    const F d;
    const I di;
    const auto at = static_cast<std::size_t>(cell);
    const VF middle = hn::Set(d, fits.inverse[at]);
    const VF perSpan = hn::Set(d, fits.perSpan[at]);
    const VI middleU = hn::Set(di, fits.middleU[at]);
    const VI middleV = hn::Set(di, fits.middleV[at]);
    constexpr auto kNode = static_cast<float>(NodeRays::kNodes[1]);
    for (int i = 0; i < kCell; i += static_cast<int>(hn::Lanes(d))) {
        const VF x =
            hn::Mul(hn::Sub(hn::Iota(d, static_cast<float>(i)), hn::Set(d, kNode)), hn::Set(d, 1 / kNode));
        std::array<Column, 3> ofU;
        std::array<Column, 3> ofV;
        for (std::size_t k = 0; k < 3; ++k) {
            ofU[k] = columnOf(x, fits.u.data() + 9 * k * fits.pitch + at, fits.pitch);
            ofV[k] = columnOf(x, fits.v.data() + 9 * k * fits.pitch + at, fits.pitch);
        }
        for (int y = 0; y < kCell; ++y) {
            const VF w = hn::Mul(hn::Sub(hn::LoadU(d, inverse + y * pitch + i), middle), perSpan);
            const VF inU = mulAdd(w, mulAdd(w, ofU[2].at, ofU[1].at), ofU[0].at);
            const VF inV = mulAdd(w, mulAdd(w, ofV[2].at, ofV[1].at), ofV[0].at);
            hn::StoreU(hn::Add(hn::NearestInt(inU), middleU), di, u + y * kCell + i);
            hn::StoreU(hn::Add(hn::NearestInt(inV), middleV), di, v + y * kCell + i);
            for (std::size_t k = 0; k < 3; ++k) {
                step(ofU[k]);
                step(ofV[k]);
            }
        }
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(locate);

void locate(const PhotoTarget& target, const std::array<CellRays, 3>& rays, const float* inverse,
            std::ptrdiff_t pitch, std::int32_t* u, std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(locate)(target, rays, inverse, pitch, u, v);
}

HWY_EXPORT(fit);
HWY_EXPORT(locateFitted);

CellFits::CellFits(int cells)
    : pitch(static_cast<std::size_t>(cells + 16)),
      u(kTerms * pitch),
      v(kTerms * pitch),
      middleU(pitch),
      middleV(pitch),
      errorPx(pitch),
      inverse(pitch),
      perSpan(pitch) {
}

void fit(const PhotoTarget& target, const NodeRays& rays, const float* least, const float* greatest,
         std::span<const std::uint8_t> isWanted, CellFits& fits) {
    HWY_DYNAMIC_DISPATCH(fit)(target, rays, least, greatest, isWanted, fits);
}

void locate(const CellFits& fits, int cell, const float* inverse, std::ptrdiff_t pitch, std::int32_t* u,
            std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(locateFitted)(fits, cell, inverse, pitch, u, v);
}

std::array<std::int32_t, 4> slopes(const CellFits& fits, int cell, float inverse) {
    const auto at = static_cast<std::size_t>(cell);
    const float w = (inverse - fits.inverse[at]) * fits.perSpan[at];
    const auto along = [&](const std::vector<float>& terms, std::size_t term) {
        const float* of = terms.data() + term * fits.pitch + at;
        const float perNode = of[0] + w * (of[9 * fits.pitch] + w * of[18 * fits.pitch]);
        return static_cast<std::int32_t>(std::lround(perNode / NodeRays::kNodes[1]));
    };
    return {along(fits.u, 1), along(fits.v, 1), along(fits.u, 3), along(fits.v, 3)};
}

} // namespace spherewalk::render::simd

#endif
