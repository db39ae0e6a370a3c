// SPDX-License-Identifier: Apache-2.0
#include "surface/vertices.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/vertices.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;

/// Where points are in the view that are q / w from the camera.
template <class D, class Vec = hn::Vec<D>>
HWY_INLINE void toView(D d, const SurfaceCamera& camera, Vec qx, Vec qy, Vec qz, Vec w, float* x, float* y,
                       float* value) {
    const Vec farthest = hn::Set(d, ProjectedBlock::kFarthestPx);
    const Vec scale = hn::Div(hn::Set(d, 1.0F), qz);
    const Vec atX = mulAdd(hn::Mul(hn::Set(d, camera.fx), qx), scale, hn::Set(d, camera.cx));
    const Vec atY = mulAdd(hn::Mul(hn::Set(d, camera.fy), qy), scale, hn::Set(d, camera.cy));
    const auto isPlaced = hn::And(hn::Gt(qz, hn::Mul(hn::Set(d, camera.nearestM), w)),
                                  hn::And(hn::Lt(hn::Abs(atX), farthest), hn::Lt(hn::Abs(atY), farthest)));
    hn::StoreU(atX, d, x);
    hn::StoreU(atY, d, y);
    hn::StoreU(hn::IfThenElseZero(isPlaced, hn::Mul(w, scale)), d, value);
}

void projectBlock(const SurfaceCamera& camera, const SurfaceBlock& part, ProjectedBlock& out) {
    const hn::CappedTag<float, 8> d;
    using V8 = hn::Vec<decltype(d)>;
    const std::array<float, 9>& m = camera.rotation;
    const std::array<float, 3>& t = camera.translation;
    for (int row = 0; row < part.rows; ++row) {
        const float level = part.cosElevation[row];
        const float up = part.sinElevation[row];
        for (int i = 0; i < ProjectedBlock::kPitch; i += static_cast<int>(hn::Lanes(d))) {
            const V8 cosine = hn::LoadU(d, part.cosAzimuth + i);
            const V8 sine = hn::LoadU(d, part.sinAzimuth + i);
            const V8 w = hn::LoadU(d, part.inverseM + row * part.pitch + i);
            const auto component = [&](std::size_t k) {
                const V8 turned =
                    mulAdd(hn::Set(d, m[3 * k] * level), cosine,
                           mulAdd(hn::Set(d, m[3 * k + 1] * level), sine, hn::Set(d, m[3 * k + 2] * up)));
                return mulAdd(w, hn::Set(d, t[k]), turned);
            };
            const std::ptrdiff_t to = std::ptrdiff_t{row} * ProjectedBlock::kPitch + i;
            toView(d, camera, component(0), component(1), component(2), w, out.x.data() + to,
                   out.y.data() + to, out.value.data() + to);
        }
    }
}

void projectPatches(const SurfaceCamera& camera, const SurfacePatches& patches, Quads& out) {
    const F d;
    const std::array<float, 9>& m = camera.rotation;
    const auto first = static_cast<std::size_t>(out.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(patches.count); i += hn::Lanes(d)) {
        std::array<VF, 4> cosine;
        std::array<VF, 4> sine;
        for (std::size_t side = 0; side < 4; ++side) {
            cosine[side] = hn::LoadU(d, patches.cosine[side] + i);
            sine[side] = hn::LoadU(d, patches.sine[side] + i);
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::size_t across = corner == 1 || corner == 2 ? 2 : 0;
            const std::size_t up = corner < 2 ? 1 : 3;
            const VF x = hn::Mul(cosine[up], cosine[across]);
            const VF y = hn::Mul(cosine[up], sine[across]);
            const VF z = sine[up];
            const VF w = hn::LoadU(d, patches.inverseM[corner] + i);
            const auto component = [&](std::size_t k) {
                const VF turned =
                    mulAdd(hn::Set(d, m[3 * k]), x,
                           mulAdd(hn::Set(d, m[3 * k + 1]), y, hn::Mul(hn::Set(d, m[3 * k + 2]), z)));
                return mulAdd(w, hn::Set(d, camera.translation[k]), turned);
            };
            toView(d, camera, component(0), component(1), component(2), w, out.x[corner].data() + first + i,
                   out.y[corner].data() + first + i, out.value[corner].data() + first + i);
        }
    }
    out.count += patches.count;
}

/// The least of each value and the four after it, from the first of each square.
HWY_INLINE void leastOfFives(const float* values, float* out) {
    const hn::CappedTag<float, 8> d;
    for (int i = 0; i < ProjectedBlock::kPitch - 8; i += static_cast<int>(hn::Lanes(d))) {
        const auto at = [&](int more) { return hn::LoadU(d, values + i + more); };
        hn::StoreU(hn::Min(hn::Min(hn::Min(at(0), at(1)), hn::Min(at(2), at(3))), at(4)), d, out + i);
    }
}

void boxes(const ProjectedBlock& part, int rows, BlockBoxes& out) {
    const hn::CappedTag<float, 8> d;
    constexpr int kPitch = ProjectedBlock::kPitch;
    constexpr int kSubBlocks = BlockBoxes::kSubBlocks;
    const auto beyond = hn::Set(d, BlockBoxes::kEverywherePx);
    std::array<std::array<float, kPitch + 8>, 6> least; // of x, -x, y, -y, value, -value
    std::array<std::array<float, kPitch>, 6> ofSubBlock;
    for (int j = 0; j < kSubBlocks; ++j) {
        const std::ptrdiff_t first = std::ptrdiff_t{j} * BlockBoxes::kSubBlock * kPitch;
        const int end = std::min(BlockBoxes::kSubBlock + 1, rows - j * BlockBoxes::kSubBlock);
        for (int i = 0; i < kPitch; i += static_cast<int>(hn::Lanes(d))) {
            std::array<hn::Vec<decltype(d)>, 6> best{beyond, beyond, beyond, beyond, beyond, beyond};
            for (int y = 0; y < end; ++y) {
                const std::ptrdiff_t at = first + std::ptrdiff_t{y} * kPitch + i;
                const auto value = hn::LoadU(d, part.value.data() + at);
                const auto isPlaced = hn::Gt(value, hn::Zero(d));
                const auto x = hn::LoadU(d, part.x.data() + at);
                const auto down = hn::LoadU(d, part.y.data() + at);
                best[0] = hn::Min(best[0], hn::IfThenElse(isPlaced, x, beyond));
                best[1] = hn::Min(best[1], hn::IfThenElse(isPlaced, hn::Neg(x), beyond));
                best[2] = hn::Min(best[2], hn::IfThenElse(isPlaced, down, beyond));
                best[3] = hn::Min(best[3], hn::IfThenElse(isPlaced, hn::Neg(down), beyond));
                best[4] = hn::Min(best[4], value);
                best[5] = hn::Min(best[5], hn::Neg(value));
            }
            for (std::size_t k = 0; k < best.size(); ++k) {
                hn::StoreU(best[k], d, least[k].data() + i);
            }
        }
        for (std::size_t k = 0; k < least.size(); ++k) {
            leastOfFives(least[k].data(), ofSubBlock[k].data());
        }
        for (int i = 0; i < kSubBlocks; ++i) {
            const auto to = static_cast<std::size_t>(j * kSubBlocks + i);
            const auto x = static_cast<std::size_t>(i * BlockBoxes::kSubBlock);
            const bool isPartly = ofSubBlock[4][x] == 0 && ofSubBlock[5][x] < 0;
            const float all = BlockBoxes::kEverywherePx;
            out.left[to] = isPartly ? -all : ofSubBlock[0][x];
            out.right[to] = isPartly ? all : -ofSubBlock[1][x];
            out.top[to] = isPartly ? -all : ofSubBlock[2][x];
            out.bottom[to] = isPartly ? all : -ofSubBlock[3][x];
        }
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(projectBlock);
HWY_EXPORT(projectPatches);
HWY_EXPORT(boxes);

void project(const SurfaceCamera& camera, const SurfaceBlock& part, ProjectedBlock& out) {
    HWY_DYNAMIC_DISPATCH(projectBlock)(camera, part, out);
}

void project(const SurfaceCamera& camera, const SurfacePatches& patches, Quads& out) {
    HWY_DYNAMIC_DISPATCH(projectPatches)(camera, patches, out);
}

void boxes(const ProjectedBlock& part, int rows, BlockBoxes& out) {
    HWY_DYNAMIC_DISPATCH(boxes)(part, rows, out);
}

} // namespace spherewalk::render::simd

#endif
