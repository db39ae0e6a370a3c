// SPDX-License-Identifier: Apache-2.0
#include "pixels/sampler.h"

#include <algorithm>
#include <array>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pixels/sampler_bicubic.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "pixels/sampler-inl.h"
// clang-format on

#ifndef SPHEREWALK_SAMPLER_BICUBIC_TABLE
#define SPHEREWALK_SAMPLER_BICUBIC_TABLE

namespace spherewalk::render::simd {

/// Catmull-Rom weights of the pixels at -1, 0, 1, 2 for a position of step / 256, in 2^-14; they sum to 2^14.
constexpr std::array<std::int16_t, 4> cubicWeights(std::int32_t step) {
    const std::int32_t t = step; // in 1/256: exact in 32 bits up to the division
    const std::int32_t t2 = t * t;
    const std::int32_t t3 = t2 * t;
    constexpr std::int32_t kToWeight = 1 << 11; // 2^24 * 2 / 2^14
    const std::int32_t before = (-t3 + 512 * t2 - 65536 * t) / kToWeight;
    const std::int32_t right = (-3 * t3 + 4 * 256 * t2 + 65536 * t) / kToWeight;
    const std::int32_t after = (t3 - 256 * t2) / kToWeight;
    return {static_cast<std::int16_t>(before), static_cast<std::int16_t>((1 << 14) - before - right - after),
            static_cast<std::int16_t>(right), static_cast<std::int16_t>(after)};
}

constexpr int kCubicSteps = 256;

constexpr std::array<std::array<std::int16_t, 4>, kCubicSteps> cubicTable() {
    std::array<std::array<std::int16_t, 4>, kCubicSteps> table{};
    for (int step = 0; step < kCubicSteps; ++step) {
        table[static_cast<std::size_t>(step)] = cubicWeights(step);
    }
    return table;
}

constexpr std::array<std::array<std::int16_t, 4>, kCubicSteps> kCubic = cubicTable();

constexpr int kShiftAcross = 8; // of fractions, to the table's step
constexpr int kShiftDown = 24;

inline const std::array<std::int16_t, 4>& cubicAt(std::int32_t fractions, int shift) {
    return kCubic[static_cast<std::size_t>(fractions >> shift & (kCubicSteps - 1))];
}

// A row's pixels, weighted, are halved to two sums and cut to 16 bits, with 7 bits for the fraction; what
// cutting takes is half of the last bit, each time. Then the rows are weighted, with 14 bits more, and 128
// added: the plane's values are less that.
constexpr int kRowShift = 7;
constexpr int kResultShift = 21;
constexpr std::int32_t kRoundResult = (1 << (kResultShift - 1)) + (1 << 14) + (128 << kResultShift);

constexpr std::uint8_t kZero = 0x80; ///< Makes a zero in a shuffle.

/// The shuffle that takes a block's bytes 0 and 8 to these.
constexpr Block bytesAt(std::size_t first, std::size_t second) {
    Block block{};
    for (std::uint8_t& byte : block) {
        byte = kZero;
    }
    block[first] = 0;
    block[second] = 8;
    return block;
}

} // namespace spherewalk::render::simd

#endif

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

/// The same integers one at a time; it also says what the SIMD code computes.
void sampleBicubic(const PlaneView& photo, const CellSamples& cell) {
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    const std::int8_t* first = photo.data() - stride - PlaneLayout::kPixelBytes;
    for (int y = 0; y < cell.height; ++y) {
        fetchNext<4>(cell, y, first, stride);
        for (int x = 0; x < cell.width; ++x) {
            const int at = y * kGroup + x;
            const std::array<std::int16_t, 4>& across = cubicAt(cell.fractions[at], kShiftAcross);
            const std::array<std::int16_t, 4>& down = cubicAt(cell.fractions[at], kShiftDown);
            const std::int8_t* row = first + cell.places[at];
            std::array<std::int32_t, 3> sum{kRoundResult, kRoundResult, kRoundResult};
            for (std::size_t j = 0; j < 4; ++j, row += stride) {
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const std::int8_t* p = row + channel;
                    sum[channel] += ((p[0] * across[0] + p[3] * across[1]) >> kRowShift) * down[j];
                    sum[channel] += ((p[6] * across[2] + p[9] * across[3]) >> kRowShift) * down[j];
                }
            }
            std::uint8_t* to = cell.out + y * cell.pitch + 3 * x;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                to[channel] = static_cast<std::uint8_t>(std::clamp(sum[channel] >> kResultShift, 0, 255));
            }
        }
    }
}

#else

/// A block from each of the first of every four places.
template <class D>
HWY_INLINE hn::Vec<D> blocksAt(D d, const std::int8_t* base, const std::int32_t* places) {
    if constexpr (hn::MaxLanes(D()) == kBlockBytes) {
        return hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(base + *places));
    } else {
        const hn::Half<D> half;
        constexpr int kOn = 4 * static_cast<int>(hn::MaxLanes(hn::Half<D>()) / kBlockBytes);
        return hn::Combine(d, blocksAt(half, base, places + kOn), blocksAt(half, base, places));
    }
}

/// The weights of the first of every four samples, twice in each block.
template <class D>
HWY_INLINE hn::Vec<D> weightsAt(D d, const std::int32_t* fractions, int shift) {
    const hn::Half<D> half;
    if constexpr (hn::MaxLanes(D()) == kBlockBytes / 2) {
        const auto weights = hn::LoadU(half, cubicAt(*fractions, shift).data());
        return hn::Combine(d, weights, weights);
    } else {
        constexpr int kOn = 4 * static_cast<int>(2 * hn::MaxLanes(hn::Half<D>()) / kBlockBytes);
        return hn::Combine(d, weightsAt(half, fractions + kOn, shift), weightsAt(half, fractions, shift));
    }
}

struct CubicConstants {
    V8 redGreen, blueLower, blueUpper; ///< Shuffles: four pixels of a channel side by side.
    V8 firstDown, secondDown;          ///< Shuffles: the weights of rows 0 and 1, and of 2 and 3
};

HWY_INLINE CubicConstants cubicConstants() {
    // Bytes go to the upper halves of 16-bit values, that is, times 256; kZero gives zero.
    static constexpr Block kRedGreen{kZero, 0, kZero, 3, kZero, 6, kZero, 9,
                                     kZero, 1, kZero, 4, kZero, 7, kZero, 10};
    static constexpr Block kBlueLower{kZero, 2,     kZero, 5,     kZero, 8,     kZero, 11,
                                      kZero, kZero, kZero, kZero, kZero, kZero, kZero, kZero};
    static constexpr Block kBlueUpper{kZero, kZero, kZero, kZero, kZero, kZero, kZero, kZero,
                                      kZero, 2,     kZero, 5,     kZero, 8,     kZero, 11};
    static constexpr Block kFirst{0, 1, 2, 3, 0, 1, 2, 3, 8, 9, 10, 11, 8, 9, 10, 11};
    static constexpr Block kSecond{4, 5, 6, 7, 4, 5, 6, 7, 12, 13, 14, 15, 12, 13, 14, 15};
    return {inBlocks(kRedGreen), inBlocks(kBlueLower), inBlocks(kBlueUpper), inBlocks(kFirst),
            inBlocks(kSecond)};
}

/// What one row of the photo gives to two samples of every four, each channel in two halves, times 256.
struct CubicRow {
    V32 redGreenA;
    V32 redGreenB;
    V32 blues; ///< The blue values of A and B.
};

/// Grey levels from the rows' sums.
HWY_INLINE V8 weighedDown(const CubicConstants& c, V32 row0, V32 row1, V32 row2, V32 row3, V16 weights) {
    constexpr int kShift = kRowShift + 8;
    const D8 d8;
    const D16 d16;
    const D32 d32;
    const auto pair = [&](V32 even, V32 odd) {
        return hn::OddEven(hn::BitCast(d16, hn::ShiftLeft<16 - kShift>(odd)),
                           hn::BitCast(d16, hn::ShiftRight<kShift>(even)));
    };
    const auto down = [&](V8 order) {
        return hn::BitCast(d16, hn::TableLookupBytes(hn::BitCast(d8, weights), order));
    };
    const V32 sum = hn::Add(multiplyHalves(pair(row0, row1), down(c.firstDown)),
                            multiplyHalves(pair(row2, row3), down(c.secondDown)));
    const V32 whole = hn::Add(hn::Add(sum, hn::Shuffle2301(sum)), hn::Set(d32, kRoundResult));
    const V32 level = hn::ShiftRight<kResultShift>(whole);
    return hn::BitCast(d8, hn::Min(hn::Max(level, hn::Zero(d32)), hn::Set(d32, 255)));
}

/// The first two samples of every four, six bytes of each block from byte kTo on; the others zero.
template <int kTo>
HWY_INLINE V8 bicubicPairs(const CubicConstants& c, const std::int8_t* first, std::ptrdiff_t stride,
                           const std::int32_t* places, const std::int32_t* fractions) {
    const D8 d8;
    const D16 d16;
    const D64 d64;
    const auto bothOf = [&](V16 a, V16 b) {
        return hn::BitCast(d16, hn::InterleaveLower(d64, hn::BitCast(d64, a), hn::BitCast(d64, b)));
    };
    const V16 acrossA = weightsAt(d16, fractions, kShiftAcross);
    const V16 acrossB = weightsAt(d16, fractions + 1, kShiftAcross);
    const V16 acrossBoth = bothOf(acrossA, acrossB);
    const auto row = [&](const std::int8_t* at) {
        const V8 a = blocksAt(d8, at, places);
        const V8 b = blocksAt(d8, at, places + 1);
        const V8 blue =
            hn::Or(hn::TableLookupBytesOr0(a, c.blueLower), hn::TableLookupBytesOr0(b, c.blueUpper));
        return CubicRow{multiplyHalves(hn::BitCast(d16, hn::TableLookupBytesOr0(a, c.redGreen)), acrossA),
                        multiplyHalves(hn::BitCast(d16, hn::TableLookupBytesOr0(b, c.redGreen)), acrossB),
                        multiplyHalves(hn::BitCast(d16, blue), acrossBoth)};
    };
    const CubicRow row0 = row(first);
    const CubicRow row1 = row(first + stride);
    const CubicRow row2 = row(first + 2 * stride);
    const CubicRow row3 = row(first + 3 * stride);
    const V16 downA = weightsAt(d16, fractions, kShiftDown);
    const V16 downB = weightsAt(d16, fractions + 1, kShiftDown);
    const V8 a = weighedDown(c, row0.redGreenA, row1.redGreenA, row2.redGreenA, row3.redGreenA, downA);
    const V8 b = weighedDown(c, row0.redGreenB, row1.redGreenB, row2.redGreenB, row3.redGreenB, downB);
    const V8 blues = weighedDown(c, row0.blues, row1.blues, row2.blues, row3.blues, bothOf(downA, downB));
    static constexpr Block kToA = bytesAt(kTo, kTo + 1);
    static constexpr Block kToB = bytesAt(kTo + 3, kTo + 4);
    static constexpr Block kToBlue = bytesAt(kTo + 2, kTo + 5);
    return hn::Or(
        hn::Or(hn::TableLookupBytesOr0(a, inBlocks(kToA)), hn::TableLookupBytesOr0(b, inBlocks(kToB))),
        hn::TableLookupBytesOr0(blues, inBlocks(kToBlue)));
}

void sampleBicubic(const PlaneView& photo, const CellSamples& given) {
    const CellSamples cell = given; // which no store to its pixels can change
    const int lanes = static_cast<int>(hn::Lanes(D32()));
    const CubicConstants c = cubicConstants();
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(photo.stride()) * PlaneLayout::kPixelBytes;
    const std::int8_t* first = photo.data() - stride - PlaneLayout::kPixelBytes;
    for (int y = 0; y < cell.height; ++y) {
        fetchNext<4>(cell, y, first, stride);
        HWY_ALIGN std::uint8_t buffer[3 * kGroup + 16];
        std::uint8_t* out = cell.out + y * cell.pitch;
        std::uint8_t* pixels = cell.spill && cell.width == kGroup ? out : buffer;
        for (int x = 0; x < kGroup; x += lanes) {
            const std::int32_t* places = cell.places + y * kGroup + x;
            const std::int32_t* fractions = cell.fractions + y * kGroup + x;
            storeTwelves(D8(),
                         hn::Or(bicubicPairs<0>(c, first, stride, places, fractions),
                                bicubicPairs<6>(c, first, stride, places + 2, fractions + 2)),
                         pixels + 3 * x);
        }
        if (pixels != out) {
            std::memcpy(out, pixels, static_cast<std::size_t>(3 * cell.width));
        }
    }
}

#endif

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(sampleBicubic);

void sampleBicubic(const PlaneView& photo, const CellSamples& cell) {
    HWY_DYNAMIC_DISPATCH(sampleBicubic)(photo, cell);
}

} // namespace spherewalk::render::simd

#endif
