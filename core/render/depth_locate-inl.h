// SPDX-License-Identifier: Apache-2.0
// What the sources that find photo coordinates of pixels share; included once for each kind of processor, as
// Highway's own -inl.h files.
#include "lattice.h"
#include "photo_plane.h"

#include <numbers>

#if defined(SPHEREWALK_DEPTH_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPHEREWALK_DEPTH_LOCATE_INL_H
#undef SPHEREWALK_DEPTH_LOCATE_INL_H
#else
#define SPHEREWALK_DEPTH_LOCATE_INL_H
#endif

#include "lattice-inl.h"

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
using I = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<I>;

constexpr int kCell = 16;
constexpr auto kPi = std::numbers::pi_v<float>;
constexpr float kOne = 1 << kFractionBits;
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

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
