// SPDX-License-Identifier: Apache-2.0
#include "layers/layer_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "layers/sphere_depths.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

/// With rays (x, y, 1) the depth along the axis is radius * t of |from + t * ray| = 1, whose root has two
/// forms that do not cancel.
void sphereDepths(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                  std::span<float> depths) {
    const D d;
    const hn::Rebind<float, D> df;
    const double down = (y - camera.cy) / camera.fy;
    const V perPixel = hn::Set(d, 1 / camera.fx);
    const V forward = hn::Set(d, inCamera.fromPhoto().y() * down + inCamera.fromPhoto().z());
    const V across = hn::Set(d, inCamera.fromPhoto().x());
    const V inside = hn::Set(d, inCamera.inside());
    const V rest = hn::Set(d, down * down + 1);
    const V middle = hn::Set(d, camera.cx);
    const V radius = hn::Set(d, radiusM);
    const auto depthsFrom = [&](std::size_t x) {
        const V right = hn::Mul(hn::Sub(hn::Iota(d, static_cast<double>(x)), middle), perPixel);
        const V along = mulAdd(across, right, forward);
        const V length2 = mulAdd(right, right, rest);
        const V root = hn::Sqrt(mulAdd(along, along, hn::Mul(inside, length2)));
        const auto ahead = hn::Gt(along, hn::Zero(d));
        const V above = hn::IfThenElse(ahead, inside, hn::Sub(root, along));
        const V below = hn::IfThenElse(ahead, hn::Add(along, root), length2);
        return hn::DemoteTo(df, hn::Div(hn::Mul(radius, above), below));
    };
    const std::size_t lanes = hn::Lanes(d);
    std::size_t x = 0;
    for (; x + lanes <= depths.size(); x += lanes) {
        hn::StoreU(depthsFrom(x), df, depths.data() + x);
    }
    if (x < depths.size()) {
        std::array<float, hn::MaxLanes(decltype(d){})> last;
        hn::StoreU(depthsFrom(x), df, last.data());
        std::copy_n(last.data(), depths.size() - x, depths.data() + x);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(sphereDepths);

void sphereDepths(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                  std::span<float> depths) {
    HWY_DYNAMIC_DISPATCH(sphereDepths)(camera, inCamera, radiusM, y, depths);
}

} // namespace spherewalk::render::simd

#endif
