// SPDX-License-Identifier: Apache-2.0
#include "sampler.h"

#include "lattice.h"

#include <algorithm>
#include <array>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sampler.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kGroup = RayTable::kCell; // samples side by side

#if HWY_TARGET == HWY_SCALAR

/// The same integers one at a time, for processors without SIMD; it also says what the SIMD code computes.
void sampleBilinear(const PlaneView& photo, const CellSamples& cell) {
    const int parts = cell.samplesPerAxis * cell.samplesPerAxis;
    const int weightSum = 32767 / parts;
    const int gain = (32768 - weightSum * parts) * 32768 / (weightSum * parts);
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    const auto scaled = [](int value, int factor) { return (value * factor + (1 << 14)) >> 15; };
    for (int y = 0; y < cell.height; ++y) {
        for (int x = 0; x < cell.width; ++x) {
            std::array<int, 3> sum{};
            for (int part = 0; part < parts; ++part) {
                const std::int32_t u = cell.u[(y * parts + part) * kGroup + x];
                const std::int32_t v = cell.v[(y * parts + part) * kGroup + x];
                const int right = ((u & 0xFFFF) * 255) >> 16;
                const int below = ((v & 0xFFFF) * weightSum) >> 16;
                const std::int8_t* pixel = photo.data() + (v >> kFractionBits) * stride +
                                           (u >> kFractionBits) * PlaneLayout::kPixelBytes;
                for (std::size_t c = 0; c < 3; ++c) {
                    const int upper = (255 - right) * pixel[c] + right * pixel[c + PlaneLayout::kPixelBytes];
                    const std::int8_t* next = pixel + stride + c;
                    const int lower = (255 - right) * next[0] + right * next[PlaneLayout::kPixelBytes];
                    sum[c] += scaled(upper, weightSum - below) + scaled(lower, below);
                }
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const int level = sum[c] + scaled(sum[c], gain) + (1 << 15);
                cell.out[y * cell.pitch + 3 * x + static_cast<std::ptrdiff_t>(c)] =
                    static_cast<std::uint8_t>((level * 257) >> 16);
            }
        }
    }
}

void sampleNearest(const PlaneView& photo, const CellSamples& cell) {
    for (int y = 0; y < cell.height; ++y) {
        std::uint8_t* to = cell.out + y * cell.pitch;
        for (int x = 0; x < cell.width; ++x) {
            constexpr std::int32_t kHalf = 1 << (kFractionBits - 1);
            const std::ptrdiff_t column = (cell.u[y * kGroup + x] + kHalf) >> kFractionBits;
            const std::ptrdiff_t row = (cell.v[y * kGroup + x] + kHalf) >> kFractionBits;
            const std::int8_t* pixel =
                photo.data() + (row * photo.stride() + column) * PlaneLayout::kPixelBytes;
            for (int channel = 0; channel < 3; ++channel) {
                to[3 * x + channel] = static_cast<std::uint8_t>(pixel[channel] + 128);
            }
        }
    }
}

#else

using D32 = hn::CappedTag<std::int32_t, kGroup>;
using D64 = hn::Repartition<std::uint64_t, D32>;
using D16 = hn::Repartition<std::int16_t, D32>;
using DU16 = hn::Repartition<std::uint16_t, D32>;
using D8 = hn::Repartition<std::uint8_t, D32>;
using V32 = hn::Vec<D32>;
using V64 = hn::Vec<D64>;
using V16 = hn::Vec<D16>;
using VU16 = hn::Vec<DU16>;
using V8 = hn::Vec<D8>;

/// Products of an unsigned byte of `weights` and a signed one of `pixels`, sums of neighbours: 16 bits each.
/// Range: no sum beyond 16 bits.
HWY_INLINE V16 multiplyPairs(V8 weights, V8 pixels) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
    return V16{_mm512_maddubs_epi16(weights.raw, pixels.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V16{_mm256_maddubs_epi16(weights.raw, pixels.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    return V16{_mm_maddubs_epi16(weights.raw, pixels.raw)};
#else
    const D16 d;
    const V16 low = hn::ShiftRight<8>(hn::ShiftLeft<8>(hn::BitCast(d, pixels)));
    const V16 high = hn::ShiftRight<8>(hn::BitCast(d, pixels));
    const DU16 du;
    const VU16 w = hn::BitCast(du, weights);
    const V16 lowWeight = hn::BitCast(d, hn::And(w, hn::Set(du, 0xFF)));
    const V16 highWeight = hn::BitCast(d, hn::ShiftRight<8>(w));
    return hn::Add(hn::Mul(low, lowWeight), hn::Mul(high, highWeight));
#endif
}

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

/// Eight bytes, two neighbouring pixels, at each offset. Samples are taken in the order of their 128-bit
/// blocks: `kUpper` chooses the upper two of each block's four.
template <bool kUpper>
HWY_INLINE V64 pixelPairs(const std::int8_t* base, V32 byteOffsets) {
    const D64 d;
#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
    const D32 d32;
    const V32 zero = hn::Zero(d32);
    const V32 wide =
        kUpper ? hn::InterleaveUpper(d32, byteOffsets, zero) : hn::InterleaveLower(d32, byteOffsets, zero);
    const hn::Repartition<std::int64_t, D32> di;
    return hn::GatherOffset(d, reinterpret_cast<const std::uint64_t*>(base), hn::BitCast(di, wide));
#else
    const D32 d32;
    HWY_ALIGN std::int32_t offsets[kGroup];
    HWY_ALIGN std::uint64_t pairs[kGroup / 2];
    hn::Store(byteOffsets, d32, offsets);
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t sample = i / 2 * 4 + i % 2 + (kUpper ? 2 : 0);
        std::memcpy(pairs + i, base + offsets[sample], sizeof(std::uint64_t));
    }
    return hn::Load(d, pairs);
#endif
}

/// What is the same for all samples of a call.
struct Constants {
    V16 stride;    ///< 1 and the plane's stride, in turns
    VU16 scale;    ///< of the fractions: 255, and the vertical weights' sum
    V16 weightSum; ///< of a sample's vertical weights
    V16 gain;      ///< what is missing from samples^2 * weightSum to 2^15, in 2^-15
    V8 pairs;      ///< shuffle: each channel's two values side by side
    V8 horizontalLower, horizontalUpper, verticalLower,
        verticalUpper; ///< shuffles: a sample's weight, repeated
    V8 complement;
};

HWY_INLINE V8 shuffle(const std::array<std::uint8_t, 16>& bytes) {
    return hn::LoadDup128(D8(), bytes.data());
}

HWY_INLINE V8 repeated(int first, int second, int step) {
    std::array<std::uint8_t, 16> bytes{};
    for (int i = 0; i < 16; ++i) {
        bytes[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>((i < 8 ? first : second) + i % 2 * step);
    }
    return shuffle(bytes);
}

HWY_INLINE Constants constants(const PlaneView& photo, int samplesPerAxis) {
    const D16 d16;
    const DU16 du16;
    const int sum = 32767 / (samplesPerAxis * samplesPerAxis);
    const int total = sum * samplesPerAxis * samplesPerAxis;
    Constants c;
    c.stride = hn::OddEven(hn::Set(d16, static_cast<std::int16_t>(photo.stride())), hn::Set(d16, 1));
    c.scale = hn::OddEven(hn::Set(du16, static_cast<std::uint16_t>(sum)), hn::Set(du16, 255));
    c.weightSum = hn::Set(d16, static_cast<std::int16_t>(sum));
    c.gain = hn::Set(d16, static_cast<std::int16_t>((32768 - total) * 32768 / total));
    c.pairs = shuffle({0, 3, 1, 4, 2, 5, 6, 7, 8, 11, 9, 12, 10, 13, 14, 15});
    c.horizontalLower = repeated(0, 4, 0);
    c.horizontalUpper = repeated(8, 12, 0);
    c.verticalLower = repeated(2, 6, 1);
    c.verticalUpper = repeated(10, 14, 1);
    c.complement = hn::BitCast(D8(), hn::Set(du16, 0x00FF));
    return c;
}

/// The weighted values of one sample each, in 1/255 grey level less 128, times weightSum / 2^15; four
/// channels side by side.
template <bool kUpper>
HWY_INLINE V16 bilinearPart(const Constants& c, const std::int8_t* upperRow, const std::int8_t* lowerRow,
                            V32 offsets, V8 weights) {
    const D8 d8;
    const D16 d16;
    const V8 x =
        hn::Xor(hn::TableLookupBytes(weights, kUpper ? c.horizontalUpper : c.horizontalLower), c.complement);
    const V16 lowerWeight =
        hn::BitCast(d16, hn::TableLookupBytes(weights, kUpper ? c.verticalUpper : c.verticalLower));
    const V16 upperWeight = hn::Sub(c.weightSum, lowerWeight);
    const V8 upper = hn::TableLookupBytes(hn::BitCast(d8, pixelPairs<kUpper>(upperRow, offsets)), c.pairs);
    const V8 lower = hn::TableLookupBytes(hn::BitCast(d8, pixelPairs<kUpper>(lowerRow, offsets)), c.pairs);
    return hn::Add(hn::MulFixedPoint15(multiplyPairs(x, upper), upperWeight),
                   hn::MulFixedPoint15(multiplyPairs(x, lower), lowerWeight));
}

/// Sums to grey levels in 16 bits.
HWY_INLINE VU16 greyLevels(const Constants& c, V16 sum) {
    const DU16 du16;
    const V16 full = hn::Add(sum, hn::MulFixedPoint15(sum, c.gain));
    // + 128 * 255 for the sign and + 128 to round; then (x * 257) >> 16 is x / 255.
    const VU16 positive = hn::Xor(hn::BitCast(du16, full), hn::Set(du16, 0x8000));
    return hn::MulHigh(positive, hn::Set(du16, 257));
}

/// Writes the first 12 bytes of each block, one after the other, and 4 bytes beyond.
HWY_INLINE void storeBlocks(V8 packed, std::uint8_t* out) {
    const D8 d8;
    HWY_ALIGN std::uint8_t bytes[4 * kGroup];
    hn::Store(packed, d8, bytes);
    for (std::size_t block = 0; block < hn::Lanes(d8) / 16; ++block) {
        std::memcpy(out + 12 * block, bytes + 16 * block, 16);
    }
}

/// Writes 3 bytes a pixel, and 4 bytes beyond.
HWY_INLINE void storePixels(VU16 lower, VU16 upper, std::uint8_t* out) {
    const D8 d8;
    // Lower bytes are samples 0 and 1 of each block, upper ones 2 and 3.
    const V8 both = hn::BitCast(d8, hn::Or(lower, hn::ShiftLeft<8>(upper)));
    const V8 packed =
        hn::TableLookupBytes(both, shuffle({0, 2, 4, 8, 10, 12, 1, 3, 5, 9, 11, 13, 6, 6, 6, 6}));
    storeBlocks(packed, out);
}

/// kParts: samples of a pixel, 0 if known only when running.
template <int kParts>
HWY_INLINE void sampleParts(const PlaneView& photo, const CellSamples& cell) {
    const D32 d32;
    const D16 d16;
    const DU16 du16;
    const int lanes = static_cast<int>(hn::Lanes(d32));
    const int parts = kParts != 0 ? kParts : cell.samplesPerAxis * cell.samplesPerAxis;
    const Constants c = constants(photo, cell.samplesPerAxis);
    const std::int8_t* upperRow = photo.data();
    const std::int8_t* lowerRow =
        upperRow + static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    for (int y = 0; y < cell.height; ++y) {
        HWY_ALIGN std::uint8_t buffer[3 * kGroup + 16];
        std::uint8_t* out = cell.out + y * cell.pitch;
        std::uint8_t* pixels = cell.spill && cell.width == kGroup ? out : buffer;
        for (int x = 0; x < kGroup; x += lanes) {
            V16 lower = hn::Zero(d16);
            V16 upper = hn::Zero(d16);
            for (int part = 0; part < parts; ++part) {
                const int at = (y * parts + part) * kGroup + x;
                const V32 u = hn::LoadU(d32, cell.u + at);
                const V32 v = hn::LoadU(d32, cell.v + at);
                const V16 whole = hn::OddEven(hn::BitCast(d16, v), hn::BitCast(d16, hn::ShiftRight<16>(u)));
                const VU16 fraction =
                    hn::OddEven(hn::BitCast(du16, hn::ShiftLeft<16>(v)), hn::BitCast(du16, u));
                const V32 pixel = multiplyHalves(whole, c.stride);
                const V32 offsets = hn::Add(pixel, hn::ShiftLeft<1>(pixel)); // three bytes each
                const V8 weights = hn::BitCast(D8(), hn::MulHigh(fraction, c.scale));
                lower = hn::Add(lower, bilinearPart<false>(c, upperRow, lowerRow, offsets, weights));
                upper = hn::Add(upper, bilinearPart<true>(c, upperRow, lowerRow, offsets, weights));
            }
            storePixels(greyLevels(c, lower), greyLevels(c, upper), pixels + 3 * x);
        }
        if (pixels != out) {
            std::memcpy(out, pixels, static_cast<std::size_t>(3 * cell.width));
        }
    }
}

void sampleBilinear(const PlaneView& photo, const CellSamples& cell) {
    switch (cell.samplesPerAxis) {
    case 1:
        return sampleParts<1>(photo, cell);
    case 2:
        return sampleParts<4>(photo, cell);
    default:
        return sampleParts<0>(photo, cell);
    }
}

void sampleNearest(const PlaneView& photo, const CellSamples& cell) {
    const D32 d32;
    const D16 d16;
    const D8 d8;
    const int lanes = static_cast<int>(hn::Lanes(d32));
    const V16 stride = constants(photo, 1).stride;
    const V32 half = hn::Set(d32, 1 << (kFractionBits - 1));
    for (int y = 0; y < cell.height; ++y) {
        HWY_ALIGN std::uint8_t buffer[3 * kGroup + 16];
        std::uint8_t* out = cell.out + y * cell.pitch;
        std::uint8_t* pixels = cell.spill && cell.width == kGroup ? out : buffer;
        for (int x = 0; x < kGroup; x += lanes) {
            const V32 u = hn::Add(hn::LoadU(d32, cell.u + y * kGroup + x), half);
            const V32 v = hn::Add(hn::LoadU(d32, cell.v + y * kGroup + x), half);
            const V16 whole = hn::OddEven(hn::BitCast(d16, v), hn::BitCast(d16, hn::ShiftRight<16>(u)));
            const V32 pixel = multiplyHalves(whole, stride);
            HWY_ALIGN std::int32_t offsets[kGroup];
            hn::Store(hn::Add(pixel, hn::ShiftLeft<1>(pixel)), d32, offsets);
            HWY_ALIGN std::int32_t loaded[kGroup];
            for (int i = 0; i < lanes; ++i) {
                std::memcpy(loaded + i, photo.data() + offsets[i], sizeof(std::int32_t));
            }
            const V8 values = hn::Xor(hn::BitCast(d8, hn::Load(d32, loaded)), hn::Set(d8, 0x80));
            storeBlocks(
                hn::TableLookupBytes(values, shuffle({0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 3, 3, 3})),
                pixels + 3 * x);
        }
        if (pixels != out) {
            std::memcpy(out, pixels, static_cast<std::size_t>(3 * cell.width));
        }
    }
}

#endif

/// Catmull-Rom weights of the pixels at -1, 0, 1, 2 for a position of step / 256, in 2^-14; they sum to 2^14.
std::array<std::int32_t, 4> cubicWeights(std::int32_t step) {
    const std::int32_t t = step; // in 1/256: exact in 32 bits up to the division
    const std::int32_t t2 = t * t;
    const std::int32_t t3 = t2 * t;
    constexpr std::int32_t kToWeight = 1 << 11; // 2^24 * 2 / 2^14
    const std::int32_t before = (-t3 + 512 * t2 - 65536 * t) / kToWeight;
    const std::int32_t right = (-3 * t3 + 4 * 256 * t2 + 65536 * t) / kToWeight;
    const std::int32_t after = (t3 - 256 * t2) / kToWeight;
    return {before, (1 << 14) - before - right - after, right, after};
}

void sampleBicubic(const PlaneView& photo, const CellSamples& cell) {
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    for (int y = 0; y < cell.height; ++y) {
        for (int x = 0; x < cell.width; ++x) {
            constexpr std::int32_t kHalfStep = 1 << (kFractionBits - 9);
            const std::int32_t u = cell.u[y * kGroup + x];
            const std::int32_t v = cell.v[y * kGroup + x] + kHalfStep;
            const std::array<std::int32_t, 4> across = cubicWeights((u & 0xFFFF) >> (kFractionBits - 8));
            const std::array<std::int32_t, 4> down = cubicWeights((v & 0xFFFF) >> (kFractionBits - 8));
            const std::int8_t* row = photo.data() + ((v >> kFractionBits) - 1) * stride +
                                     ((u >> kFractionBits) - 1) * PlaneLayout::kPixelBytes;
            std::array<std::int32_t, 3> sum{1 << 20, 1 << 20, 1 << 20};
            for (std::size_t j = 0; j < 4; ++j, row += stride) {
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const std::int32_t line = (1 << 6) + row[channel] * across[0] +
                                              row[channel + 3] * across[1] + row[channel + 6] * across[2] +
                                              row[channel + 9] * across[3];
                    sum[channel] += (line >> 7) * down[j];
                }
            }
            std::uint8_t* to = cell.out + y * cell.pitch + 3 * x;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                to[channel] = static_cast<std::uint8_t>(std::clamp((sum[channel] >> 21) + 128, 0, 255));
            }
        }
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

void prefetch(const PlaneView& photo, const CellSamples& cell) {
    // Of each row of samples, the lines that hold its pixels if it is not minified by more than three.
    const int n = cell.samplesPerAxis;
    for (int row = 0; row < cell.height * n; ++row) {
        const int at = row * n * RayTable::kCell;
        for (const int x : {0, 7, 14}) {
            const std::ptrdiff_t column = cell.u[at + x] >> kFractionBits;
            const std::ptrdiff_t line = cell.v[at + x] >> kFractionBits;
            hwy::Prefetch(photo.data() + (line * photo.stride() + column) * PlaneLayout::kPixelBytes);
        }
    }
}

HWY_EXPORT(sampleBilinear);
HWY_EXPORT(sampleNearest);
HWY_EXPORT(sampleBicubic);

void sampleBilinear(const PlaneView& photo, const CellSamples& cell) {
    HWY_DYNAMIC_DISPATCH(sampleBilinear)(photo, cell);
}

void sampleNearest(const PlaneView& photo, const CellSamples& cell) {
    HWY_DYNAMIC_DISPATCH(sampleNearest)(photo, cell);
}

void sampleBicubic(const PlaneView& photo, const CellSamples& cell) {
    HWY_DYNAMIC_DISPATCH(sampleBicubic)(photo, cell);
}

} // namespace spherewalk::render::simd

#endif
