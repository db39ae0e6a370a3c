// SPDX-License-Identifier: Apache-2.0
#include "depth_locate.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "depth_locate.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "depth_locate-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

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
            const VF x = component(0);
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

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(locate);

void locate(const PhotoTarget& target, const std::array<CellRays, 3>& rays, const float* inverse,
            std::ptrdiff_t pitch, std::int32_t* u, std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(locate)(target, rays, inverse, pitch, u, v);
}

} // namespace spherewalk::render::simd

#endif
