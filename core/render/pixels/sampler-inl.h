// SPDX-License-Identifier: Apache-2.0
// What the samplers share; included once for each kind of processor, as Highway's own -inl.h files.
#include "pixels/sampler.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#if defined(SPHEREWALK_SAMPLER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPHEREWALK_SAMPLER_INL_H
#undef SPHEREWALK_SAMPLER_INL_H
#else
#define SPHEREWALK_SAMPLER_INL_H
#endif

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kGroup = kCell; // samples side by side

/// Asks for the pixels of the next cell's row y, so many rows of the photo from `first` on, and does not wait
/// for them.
template <int kRows>
HWY_INLINE void fetchNext(const CellSamples& cell, int y, const std::int8_t* first, std::ptrdiff_t stride) {
    if (cell.next == nullptr) {
        return;
    }
    const int n = cell.samplesPerAxis;
    const std::int32_t* places = cell.next + y * n * n * kGroup;
    for (int part = 0; part < n; ++part, places += n * kGroup) {
        for (std::ptrdiff_t x = 0; x < kGroup; x += cell.nextStep) {
            const std::int8_t* at = first + places[x];
            for (int row = 0; row < kRows; ++row, at += stride) {
                hwy::Prefetch(at);
            }
        }
    }
}

#if HWY_TARGET != HWY_SCALAR

// Vectors of at most one row's 32-bit values; one block where the width is not known when compiling.
using D8 = hn::CappedTag<std::uint8_t, HWY_HAVE_SCALABLE ? 16 : 4 * kGroup>;
using D16 = hn::Repartition<std::int16_t, D8>;
using DU16 = hn::Repartition<std::uint16_t, D8>;
using D32 = hn::Repartition<std::int32_t, D8>;
using D64 = hn::Repartition<std::uint64_t, D8>;
using V8 = hn::Vec<D8>;
using V16 = hn::Vec<D16>;
using VU16 = hn::Vec<DU16>;
using V32 = hn::Vec<D32>;

constexpr int kBlockBytes = 16;

/// Lower and upper 16 bits of each 32-bit lane, signed, times `factors`' likewise, and summed.
HWY_INLINE V32 multiplyHalves(V16 values, V16 factors) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
    return V32{_mm512_madd_epi16(values.raw, factors.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V32{_mm256_madd_epi16(values.raw, factors.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    return V32{_mm_madd_epi16(values.raw, factors.raw)};
#else
    const D32 d;
    const V32 a = hn::BitCast(d, values);
    const V32 b = hn::BitCast(d, factors);
    const V32 low =
        hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(a)), hn::ShiftRight<16>(hn::ShiftLeft<16>(b)));
    return hn::Add(low, hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
#endif
}

/// The same bytes in each block. They should be constants in memory: what was only just written there cannot
/// be loaded at once.
HWY_INLINE V8 inBlocks(const Block& bytes) {
    return hn::LoadDup128(D8(), bytes.data());
}

/// Writes the first 12 bytes of each block, one after the other, and 4 bytes beyond.
template <class D>
HWY_INLINE void storeTwelves(D d, hn::Vec<D> blocks, std::uint8_t* out) {
    if constexpr (hn::MaxLanes(D()) == kBlockBytes) {
        hn::StoreU(blocks, d, out);
    } else {
        const hn::Half<D> half;
        storeTwelves(half, hn::LowerHalf(half, blocks), out);
        storeTwelves(half, hn::UpperHalf(half, blocks), out + 12 * (hn::MaxLanes(half) / kBlockBytes));
    }
}

#endif

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
