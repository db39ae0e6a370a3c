// SPDX-License-Identifier: Apache-2.0
#include "depth_simd.h"

#include "lattice.h"
#include "photo_plane.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "depth_simd.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using V = hn::Vec<F>;
using I = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<I>;

constexpr int kCell = 16;

// Not hn::MulAdd: where the processor has one, it rounds once instead of twice.
template <class Vec>
HWY_INLINE Vec mulAdd(Vec a, Vec b, Vec c) {
    return hn::Add(hn::Mul(a, b), c);
}

/// Where points are in the view that are q / w from the camera.
template <class D, class Vec = hn::Vec<D>>
HWY_INLINE void toView(D d, const SurfaceCamera& camera, Vec qx, Vec qy, Vec qz, Vec w, float* x, float* y,
                       float* value) {
    const Vec farthest = hn::Set(d, ProjectedPart::kFarthestPx);
    const Vec scale = hn::Div(hn::Set(d, 1.0F), qz);
    const Vec atX = mulAdd(hn::Mul(hn::Set(d, camera.fx), qx), scale, hn::Set(d, camera.cx));
    const Vec atY = mulAdd(hn::Mul(hn::Set(d, camera.fy), qy), scale, hn::Set(d, camera.cy));
    const auto isPlaced = hn::And(hn::Gt(qz, hn::Mul(hn::Set(d, camera.nearestM), w)),
                                  hn::And(hn::Lt(hn::Abs(atX), farthest), hn::Lt(hn::Abs(atY), farthest)));
    hn::StoreU(atX, d, x);
    hn::StoreU(atY, d, y);
    hn::StoreU(hn::IfThenElseZero(isPlaced, hn::Mul(w, scale)), d, value);
}

void projectPart(const SurfaceCamera& camera, const SurfacePart& part, ProjectedPart& out) {
    const hn::CappedTag<float, 8> d;
    using V8 = hn::Vec<decltype(d)>;
    const std::array<float, 9>& m = camera.rotation;
    const std::array<float, 3>& t = camera.translation;
    for (int row = 0; row < part.rows; ++row) {
        const float level = part.cosElevation[row];
        const float up = part.sinElevation[row];
        for (int i = 0; i < ProjectedPart::kPitch; i += static_cast<int>(hn::Lanes(d))) {
            const V8 cosine = hn::LoadU(d, part.cosAzimuth + i);
            const V8 sine = hn::LoadU(d, part.sinAzimuth + i);
            const V8 w = hn::LoadU(d, part.inverseM + row * part.pitch + i);
            const auto component = [&](std::size_t k) {
                const V8 turned =
                    mulAdd(hn::Set(d, m[3 * k] * level), cosine,
                           mulAdd(hn::Set(d, m[3 * k + 1] * level), sine, hn::Set(d, m[3 * k + 2] * up)));
                return mulAdd(w, hn::Set(d, t[k]), turned);
            };
            const std::ptrdiff_t to = std::ptrdiff_t{row} * ProjectedPart::kPitch + i;
            toView(d, camera, component(0), component(1), component(2), w, out.x.data() + to,
                   out.y.data() + to, out.value.data() + to);
        }
    }
}

void projectSixteen(const SurfaceCamera& camera, const SixteenPoints& points, SixteenVertices& out) {
    const F d;
    const std::array<float, 9>& m = camera.rotation;
    for (std::size_t i = 0; i < 16; i += hn::Lanes(d)) {
        const V x = hn::LoadU(d, points.x.data() + i);
        const V y = hn::LoadU(d, points.y.data() + i);
        const V z = hn::LoadU(d, points.z.data() + i);
        const V w = hn::LoadU(d, points.inverseM.data() + i);
        const auto component = [&](std::size_t k) {
            const V turned =
                mulAdd(hn::Set(d, m[3 * k]), x,
                       mulAdd(hn::Set(d, m[3 * k + 1]), y, hn::Mul(hn::Set(d, m[3 * k + 2]), z)));
            return mulAdd(w, hn::Set(d, camera.translation[k]), turned);
        };
        toView(d, camera, component(0), component(1), component(2), w, out.x.data() + i, out.y.data() + i,
               out.value.data() + i);
    }
}

/// The least of each value and the four after it, from the first of each square.
HWY_INLINE void leastOfFives(const float* values, float* out) {
    const hn::CappedTag<float, 8> d;
    for (int i = 0; i < ProjectedPart::kPitch - 8; i += static_cast<int>(hn::Lanes(d))) {
        const auto at = [&](int more) { return hn::LoadU(d, values + i + more); };
        hn::StoreU(hn::Min(hn::Min(hn::Min(at(0), at(1)), hn::Min(at(2), at(3))), at(4)), d, out + i);
    }
}

void boxes(const ProjectedPart& part, int rows, PartBoxes& out) {
    const hn::CappedTag<float, 8> d;
    constexpr int kPitch = ProjectedPart::kPitch;
    constexpr int kSquares = PartBoxes::kSquares;
    const auto beyond = hn::Set(d, PartBoxes::kEverywherePx);
    std::array<std::array<float, kPitch + 8>, 6> least; // of x, -x, y, -y, value, -value
    std::array<std::array<float, kPitch>, 6> ofSquare;
    for (int j = 0; j < kSquares; ++j) {
        const std::ptrdiff_t first = std::ptrdiff_t{j} * PartBoxes::kSquare * kPitch;
        const int end = std::min(PartBoxes::kSquare + 1, rows - j * PartBoxes::kSquare);
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
            leastOfFives(least[k].data(), ofSquare[k].data());
        }
        for (int i = 0; i < kSquares; ++i) {
            const auto to = static_cast<std::size_t>(j * kSquares + i);
            const auto x = static_cast<std::size_t>(i * PartBoxes::kSquare);
            const bool isPartly = ofSquare[4][x] == 0 && ofSquare[5][x] < 0;
            const float all = PartBoxes::kEverywherePx;
            out.left[to] = isPartly ? -all : ofSquare[0][x];
            out.right[to] = isPartly ? all : -ofSquare[1][x];
            out.top[to] = isPartly ? -all : ofSquare[2][x];
            out.bottom[to] = isPartly ? all : -ofSquare[3][x];
        }
    }
}

int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofParts) {
    const F d;
    const I di;
    constexpr int kPart = 4;
    std::array<std::int32_t, kCell * kCell / kPart> ofColumns;
    VI any = hn::Zero(di);
    for (int y = 0; y < kCell; y += kPart) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            VI count = hn::Zero(di);
            for (int i = 0; i < kPart; ++i) {
                const V value = hn::LoadU(d, values + (y + i) * pitch + x);
                const auto isZero = hn::RebindMask(di, hn::Eq(value, hn::Zero(d)));
                count = hn::Add(count, hn::IfThenElseZero(isZero, hn::Set(di, 1)));
            }
            any = hn::Or(any, count);
            hn::StoreU(count, di, ofColumns.data() + y * (kCell / kPart) + x);
        }
    }
    ofParts = {};
    if (hn::AllTrue(di, hn::Eq(any, hn::Zero(di)))) {
        return 0;
    }
    int all = 0;
    for (std::size_t i = 0; i < ofColumns.size(); ++i) {
        ofParts[i / kPart] += ofColumns[i];
        all += ofColumns[i];
    }
    return all;
}

std::uint32_t takeUnseen(const float* seen, float* values, std::ptrdiff_t pitch,
                         std::array<std::int32_t, 256>& isTaken) {
    const F d;
    const I di;
    std::uint32_t rows = 0;
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const V mine = hn::LoadU(d, values + y * pitch + x);
            const V other = hn::LoadU(d, seen + y * pitch + x);
            const auto takes = hn::And(hn::Eq(mine, hn::Zero(d)), hn::Gt(other, hn::Zero(d)));
            hn::StoreU(hn::IfThenElse(takes, other, mine), d, values + y * pitch + x);
            hn::StoreU(hn::IfThenElseZero(hn::RebindMask(di, takes), hn::Set(di, 1)), di,
                       isTaken.data() + y * kCell + x);
            rows |= hn::AllFalse(d, takes) ? 0 : 1U << y;
        }
    }
    return rows;
}

void placeRows(const PartPlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows, int apart,
               std::int32_t* places, std::int32_t* fractions) {
    static_assert(PlaneLayout::kPixelBytes == 3);
    const I d;
    const VI addU = hn::Set(d, placing.addU);
    const VI addV = hn::Set(d, placing.addV);
    const VI first = hn::Set(d, placing.first);
    const VI turn = hn::Set(d, placing.turn);
    const VI beyond = hn::Set(d, placing.first + placing.turn);
    const VI lastV = hn::Set(d, placing.lastV);
    const VI rowBytes = hn::Set(d, placing.rowBytes);
    for (int y = 0; y < rows; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            VI atU = hn::Add(hn::LoadU(d, u + y * kCell + x), addU);
            atU = hn::Add(atU, hn::IfThenElseZero(hn::Lt(atU, first), turn));
            atU = hn::Sub(atU, hn::IfThenElseZero(hn::Not(hn::Lt(atU, beyond)), turn));
            atU = hn::Min(hn::Max(atU, hn::Zero(d)), beyond); // of another photo's size
            VI atV = hn::Add(hn::LoadU(d, v + y * kCell + x), addV);
            atV = hn::Min(hn::Max(atV, first), lastV);
            const VI column = hn::ShiftRight<kFractionBits>(atU);
            const VI row = hn::ShiftRight<kFractionBits>(atV);
            const std::ptrdiff_t to = std::ptrdiff_t{y} * apart * kCell + x;
            hn::StoreU(hn::Add(hn::Mul(row, rowBytes), hn::Add(column, hn::ShiftLeft<1>(column))), d,
                       places + to);
            const VI right = hn::And(atU, hn::Set(d, (1 << kFractionBits) - 1));
            hn::StoreU(hn::Or(right, hn::ShiftLeft<kFractionBits>(atV)), d, fractions + to);
        }
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(projectPart);
HWY_EXPORT(projectSixteen);
HWY_EXPORT(boxes);
HWY_EXPORT(zeros);
HWY_EXPORT(takeUnseen);
HWY_EXPORT(placeRows);

void project(const SurfaceCamera& camera, const SurfacePart& part, ProjectedPart& out) {
    HWY_DYNAMIC_DISPATCH(projectPart)(camera, part, out);
}

void project(const SurfaceCamera& camera, const SixteenPoints& points, SixteenVertices& out) {
    HWY_DYNAMIC_DISPATCH(projectSixteen)(camera, points, out);
}

void boxes(const ProjectedPart& part, int rows, PartBoxes& out) {
    HWY_DYNAMIC_DISPATCH(boxes)(part, rows, out);
}

int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofParts) {
    return HWY_DYNAMIC_DISPATCH(zeros)(values, pitch, ofParts);
}

std::uint32_t takeUnseen(const float* seen, float* values, std::ptrdiff_t pitch,
                         std::array<std::int32_t, 256>& isTaken) {
    return HWY_DYNAMIC_DISPATCH(takeUnseen)(seen, values, pitch, isTaken);
}

void placeRows(const PartPlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows, int apart,
               std::int32_t* places, std::int32_t* fractions) {
    HWY_DYNAMIC_DISPATCH(placeRows)(placing, u, v, rows, apart, places, fractions);
}

} // namespace spherewalk::render::simd

#endif
