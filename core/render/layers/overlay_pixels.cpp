// SPDX-License-Identifier: Apache-2.0
#include "layers/layer_rows.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "layers/overlay_pixels.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kHalf = OverlayMap::kOne * OverlayMap::kOne / 2; ///< It rounds.

void copyColours(const std::uint8_t* rgba, int count, std::uint8_t* rgb) {
    int done = 0;
#if HWY_TARGET != HWY_SCALAR
    const hn::CappedTag<std::uint8_t, 16> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    for (; done + lanes <= count; done += lanes) {
        hn::Vec<decltype(d)> red;
        hn::Vec<decltype(d)> green;
        hn::Vec<decltype(d)> blue;
        hn::Vec<decltype(d)> alpha;
        hn::LoadInterleaved4(d, rgba + 4 * done, red, green, blue, alpha);
        hn::StoreInterleaved3(red, green, blue, d, rgb + 3 * done);
    }
#endif
    for (; done < count; ++done) {
        std::copy_n(rgba + 4 * done, 3, rgb + 3 * done);
    }
}

/// The mean of the pixels at `upper` and `lower` and of those to their right. Four bytes are written.
HWY_INLINE void mixFour(const std::uint8_t* upper, const std::uint8_t* lower, int right, int below,
                        std::uint8_t* out) {
#if HWY_TARGET == HWY_SCALAR
    for (int c = 0; c < 4; ++c) {
        const int left = (OverlayMap::kOne - below) * upper[c] + below * lower[c];
        const int next = (OverlayMap::kOne - below) * upper[4 + c] + below * lower[4 + c];
        out[c] = static_cast<std::uint8_t>(((OverlayMap::kOne - right) * left + right * next + kHalf) >> 16);
    }
#else
    const hn::FixedTag<std::uint16_t, 8> d16;
    const hn::FixedTag<std::uint8_t, 8> d8;
    const hn::FixedTag<std::int32_t, 4> d32;
    const hn::FixedTag<std::uint16_t, 4> half;
    const auto weight16 = [&](int weight) { return hn::Set(d16, static_cast<std::uint16_t>(weight)); };
    // Both pixels, each channel at most 255 * 256.
    const auto pair =
        hn::Add(hn::Mul(hn::PromoteTo(d16, hn::LoadU(d8, upper)), weight16(OverlayMap::kOne - below)),
                hn::Mul(hn::PromoteTo(d16, hn::LoadU(d8, lower)), weight16(below)));
    const auto left = hn::PromoteTo(d32, hn::LowerHalf(half, pair));
    const auto next = hn::PromoteTo(d32, hn::UpperHalf(half, pair));
    const auto sum = hn::Add(
        hn::Add(hn::Mul(left, hn::Set(d32, OverlayMap::kOne - right)), hn::Mul(next, hn::Set(d32, right))),
        hn::Set(d32, kHalf));
    hn::StoreU(hn::DemoteTo(hn::FixedTag<std::uint8_t, 4>(), hn::ShiftRight<16>(sum)),
               hn::FixedTag<std::uint8_t, 4>(), out);
#endif
}

void coloursBetween(const RgbaImage& picture, std::span<const OverlayMap::Position> positions,
                    std::uint8_t* rgb) {
    const std::ptrdiff_t pitch = std::ptrdiff_t{4} * picture.width();
    const std::uint8_t* first = picture.values().data();
    const auto mix = [&](const OverlayMap::Position& at, std::uint8_t* out) {
        const std::uint8_t* upper = first + (at.v >> 8) * pitch + std::ptrdiff_t{4} * (at.u >> 8);
        mixFour(upper, upper + pitch, at.u & 0xFF, at.v & 0xFF, out);
    };
    for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
        mix(positions[i], rgb + 3 * i); // the next one writes over the fourth byte
    }
    if (!positions.empty()) {
        std::array<std::uint8_t, 4> last;
        mix(positions.back(), last.data());
        std::copy_n(last.begin(), 3, rgb + 3 * (positions.size() - 1));
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(copyColours);
HWY_EXPORT(coloursBetween);

void copyColours(const std::uint8_t* rgba, int count, std::uint8_t* rgb) {
    HWY_DYNAMIC_DISPATCH(copyColours)(rgba, count, rgb);
}

void coloursBetween(const RgbaImage& picture, std::span<const OverlayMap::Position> positions,
                    std::uint8_t* rgb) {
    HWY_DYNAMIC_DISPATCH(coloursBetween)(picture, positions, rgb);
}

} // namespace spherewalk::render::simd

#endif
