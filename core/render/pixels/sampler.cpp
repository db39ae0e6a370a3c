// SPDX-License-Identifier: Apache-2.0
#include "pixels/sampler.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pixels/sampler.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "pixels/sampler-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

/// The same integers one at a time, for processors without SIMD; it also says what the SIMD code computes.
void sampleBilinear(const PlaneView& photo, const CellSamples& cell) {
    const int parts = cell.samplesPerAxis * cell.samplesPerAxis;
    const int weightSum = 32767 / parts;
    const int gain = (32768 - weightSum * parts) * 32768 / (weightSum * parts);
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    const auto scaled = [](int value, int factor) { return (value * factor + (1 << 14)) >> 15; };
    for (int y = 0; y < cell.height; ++y) {
        fetchNext<2>(cell, y, photo.data(), stride);
        for (int x = 0; x < cell.width; ++x) {
            std::array<int, 3> sum{};
            for (int part = 0; part < parts; ++part) {
                const int at = (y * parts + part) * kGroup + x;
                const int right = ((cell.fractions[at] & 0xFFFF) * 255) >> 16;
                const int below = ((cell.fractions[at] >> 16 & 0xFFFF) * weightSum) >> 16;
                const std::int8_t* pixel = photo.data() + cell.places[at];
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

#else

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

/// Eight bytes at each of two places.
HWY_INLINE hn::Vec<hn::CappedTag<std::uint8_t, kBlockBytes>> twoPairs(const std::int8_t* base,
                                                                      const std::int32_t* places) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    const auto* first = reinterpret_cast<const __m128i*>(base + places[0]);
    const auto* second = reinterpret_cast<const __m64*>(base + places[1]);
    return {_mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(_mm_loadl_epi64(first)), second))};
#else
    const hn::CappedTag<std::uint8_t, kBlockBytes> d;
    const hn::Half<decltype(d)> half;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(base);
    return hn::Combine(d, hn::LoadU(half, bytes + places[1]), hn::LoadU(half, bytes + places[0]));
#endif
}

/// Eight bytes at each of the first two places of every four.
template <class D>
HWY_INLINE hn::Vec<D> eightBytes(D d, const std::int8_t* base, const std::int32_t* places) {
    if constexpr (hn::MaxLanes(D()) == kBlockBytes) {
        return twoPairs(base, places);
    } else {
        const hn::Half<D> half;
        constexpr int kOn = 4 * static_cast<int>(hn::MaxLanes(hn::Half<D>()) / kBlockBytes);
        return hn::Combine(d, eightBytes(half, base, places + kOn), eightBytes(half, base, places));
    }
}

/// Two neighbouring pixels at each place. Samples are taken in the order of their 128-bit blocks: `kUpper`
/// chooses the upper two of each block's four.
template <bool kUpper>
HWY_INLINE V8 pixelPairs(const std::int8_t* base, const std::int32_t* places) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
    const D32 d;
    const V32 offsets = hn::LoadU(d, places);
    const V32 zero = hn::Zero(d);
    const V32 wide = kUpper ? hn::InterleaveUpper(d, offsets, zero) : hn::InterleaveLower(d, offsets, zero);
    const hn::Repartition<std::int64_t, D32> di;
    return hn::BitCast(
        D8(), hn::GatherOffset(D64(), reinterpret_cast<const std::uint64_t*>(base), hn::BitCast(di, wide)));
#else
    return eightBytes(D8(), base, places + (kUpper ? 2 : 0));
#endif
}

/// Constants that are the same for all samples of a call.
struct Constants {
    VU16 scale;    ///< Factors of the fractions: 255, and the vertical weights' sum.
    V16 weightSum; ///< The sum of a sample's vertical weights.
    V16 gain;      ///< By how much samples^2 * weightSum falls short of 2^15, in 2^-15.
    V8 pairs;      ///< A shuffle that puts each channel's two values side by side.
    V8 horizontalLower, horizontalUpper, verticalLower,
        verticalUpper; ///< Shuffles that repeat a sample's weight.
    V8 complement;
};

HWY_INLINE Constants constants(int samplesPerAxis) {
    static constexpr Block kPairs{0, 3, 1, 4, 2, 5, 6, 7, 8, 11, 9, 12, 10, 13, 14, 15};
    static constexpr Block kHorizontal{0, 0, 0, 0, 0, 0, 0, 0, 4, 4, 4, 4, 4, 4, 4, 4};
    static constexpr Block kVertical{2, 3, 2, 3, 2, 3, 2, 3, 6, 7, 6, 7, 6, 7, 6, 7};
    const D8 d8;
    const D16 d16;
    const DU16 du16;
    const int sum = 32767 / (samplesPerAxis * samplesPerAxis);
    const int total = sum * samplesPerAxis * samplesPerAxis;
    Constants c;
    c.scale = hn::OddEven(hn::Set(du16, static_cast<std::uint16_t>(sum)), hn::Set(du16, 255));
    c.weightSum = hn::Set(d16, static_cast<std::int16_t>(sum));
    c.gain = hn::Set(d16, static_cast<std::int16_t>((32768 - total) * 32768 / total));
    c.pairs = inBlocks(kPairs);
    c.horizontalLower = inBlocks(kHorizontal);
    c.horizontalUpper = hn::Add(c.horizontalLower, hn::Set(d8, 8));
    c.verticalLower = inBlocks(kVertical);
    c.verticalUpper = hn::Add(c.verticalLower, hn::Set(d8, 8));
    c.complement = hn::BitCast(d8, hn::Set(du16, 0x00FF));
    return c;
}

/// The weighted values of one sample each, in 1/255 grey level less 128, times weightSum / 2^15; four
/// channels side by side.
template <bool kUpper>
HWY_INLINE V16 bilinearPart(const Constants& c, const std::int8_t* upperRow, const std::int8_t* lowerRow,
                            const std::int32_t* places, V8 weights) {
    const D16 d16;
    const V8 x =
        hn::Xor(hn::TableLookupBytes(weights, kUpper ? c.horizontalUpper : c.horizontalLower), c.complement);
    const V16 lowerWeight =
        hn::BitCast(d16, hn::TableLookupBytes(weights, kUpper ? c.verticalUpper : c.verticalLower));
    const V16 upperWeight = hn::Sub(c.weightSum, lowerWeight);
    const V8 upper = hn::TableLookupBytes(pixelPairs<kUpper>(upperRow, places), c.pairs);
    const V8 lower = hn::TableLookupBytes(pixelPairs<kUpper>(lowerRow, places), c.pairs);
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

/// Writes 3 bytes a pixel, and 4 bytes beyond. Lower values are samples 0 and 1 of each block, upper ones 2
/// and 3.
HWY_INLINE void storePixels(VU16 lower, VU16 upper, std::uint8_t* out) {
    const V8 both = hn::BitCast(D8(), hn::Or(lower, hn::ShiftLeft<8>(upper)));
    static constexpr Block kPacked{0, 2, 4, 8, 10, 12, 1, 3, 5, 9, 11, 13, 6, 6, 6, 6};
    storeTwelves(D8(), hn::TableLookupBytes(both, inBlocks(kPacked)), out);
}

/// kParts: samples of a pixel, 0 if known only when running.
template <int kParts>
HWY_INLINE void sampleParts(const PlaneView& photo, const CellSamples& given) {
    const CellSamples cell = given; // which no store to its pixels can change
    const D32 d32;
    const DU16 du16;
    const int lanes = static_cast<int>(hn::Lanes(d32));
    const int parts = kParts != 0 ? kParts : cell.samplesPerAxis * cell.samplesPerAxis;
    const Constants c = constants(cell.samplesPerAxis);
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    const std::int8_t* upperRow = photo.data();
    const std::int8_t* lowerRow = upperRow + stride;
    for (int y = 0; y < cell.height; ++y) {
        fetchNext<2>(cell, y, upperRow, stride);
        HWY_ALIGN std::uint8_t buffer[3 * kGroup + 16];
        std::uint8_t* out = cell.out + y * cell.pitch;
        std::uint8_t* pixels = cell.spill && cell.width == kGroup ? out : buffer;
        for (int x = 0; x < kGroup; x += lanes) {
            V16 lower = hn::Zero(D16());
            V16 upper = hn::Zero(D16());
            for (int part = 0; part < parts; ++part) {
                const int at = (y * parts + part) * kGroup + x;
                const VU16 fractions = hn::BitCast(du16, hn::LoadU(d32, cell.fractions + at));
                const V8 weights = hn::BitCast(D8(), hn::MulHigh(fractions, c.scale));
                const std::int32_t* places = cell.places + at;
                lower = hn::Add(lower, bilinearPart<false>(c, upperRow, lowerRow, places, weights));
                upper = hn::Add(upper, bilinearPart<true>(c, upperRow, lowerRow, places, weights));
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

#endif

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(sampleBilinear);

int stepToOtherMemory(const std::int32_t* places, int count, int stride) {
    constexpr int kLine = 64;
    constexpr int kRow = 16;
    const int rowBytes = stride * PlaneLayout::kPixelBytes;
    int lines = 0;
    for (const int row : {0, count - kRow}) { // the cell's first and last
        const int apart = std::abs(places[row + kRow - 1] - places[row]);
        const int down = (apart + rowBytes / 2) / rowBytes;
        lines = std::max(lines, down + std::abs(apart - down * rowBytes) / kLine);
    }
    return lines < 1 ? 8 : lines < 3 ? 4 : lines < 7 ? 2 : 1;
}

void sampleBilinear(const PlaneView& photo, const CellSamples& cell) {
    HWY_DYNAMIC_DISPATCH(sampleBilinear)(photo, cell);
}

void sample(const PlaneView& photo, Sampling sampling, const CellSamples& cell) {
    switch (sampling) {
    case Sampling::Nearest:
        return sampleNearest(photo, cell);
    case Sampling::Bicubic:
        return sampleBicubic(photo, cell);
    default:
        return sampleBilinear(photo, cell);
    }
}

Placing placing(const PlaneView& photo, Sampling sampling) {
    constexpr std::int32_t kHalf = 1 << (kFractionBits - 1);
    switch (sampling) {
    case Sampling::Nearest:
        return {photo.stride(), kHalf, kHalf};
    case Sampling::Bicubic: // u is rounded to its weights' steps already, see kRoundingU
        return {photo.stride(), 0, kHalf / 256};
    default:
        return {photo.stride(), 0, 0};
    }
}

void sampleNearest(const PlaneView& photo, const CellSamples& cell) {
    const std::int8_t* data = photo.data();
    const int full = cell.spill ? cell.width : cell.width - 1; // these may write a byte beyond themselves
    for (int y = 0; y < cell.height; ++y) {
        HWY_STATIC_DISPATCH(fetchNext<1>)(cell, y, data, 0);
        const std::int32_t* places = cell.places + y * kCell;
        std::uint8_t* to = cell.out + y * cell.pitch;
        for (int x = 0; x < full; ++x, to += 3) {
            std::uint32_t rgb = 0;
            std::memcpy(&rgb, data + places[x], sizeof rgb);
            rgb ^= 0x80808080U;
            std::memcpy(to, &rgb, sizeof rgb);
        }
        for (int x = full; x < cell.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                to[c] = static_cast<std::uint8_t>(data[places[x] + c] + 128);
            }
        }
    }
}

} // namespace spherewalk::render::simd

#endif
