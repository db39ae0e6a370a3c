// SPDX-License-Identifier: Apache-2.0
#include "pixels/sampler.h"
#include "surface/surface_view.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/blended_view.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, kCell>;
constexpr std::ptrdiff_t kRowBytes = std::ptrdiff_t{3} * kCell;

void keepWithin(const std::uint8_t* colours, std::uint8_t* others) {
    constexpr int kReach = 2;
    constexpr std::ptrdiff_t kBeside = std::ptrdiff_t{3} * kReach;
    const Bytes d;
    const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
    const auto all = hn::Set(d, std::uint8_t{255});
    const auto margin = hn::Set(d, std::uint8_t{8}); // noise
    std::array<std::uint8_t, kRowBytes + 2 * kBeside> low;
    std::array<std::uint8_t, kRowBytes + 2 * kBeside> high;
    const auto goOn = [](auto& row) {
        for (std::size_t i = 0; i < kBeside; ++i) {
            row[i] = row[kBeside + i % 3];
            row[kBeside + kRowBytes + i] = row[kRowBytes + kBeside - 3 + i % 3];
        }
    };
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t i = 0; i < kRowBytes; i += lanes) {
            auto least = hn::LoadU(d, colours + y * kRowBytes + i);
            auto most = least;
            for (int near = std::max(0, y - kReach); near <= std::min(kCell - 1, y + kReach); ++near) {
                const auto beside = hn::LoadU(d, colours + near * kRowBytes + i);
                least = hn::Min(least, beside);
                most = hn::Max(most, beside);
            }
            hn::StoreU(least, d, low.data() + kBeside + i);
            hn::StoreU(most, d, high.data() + kBeside + i);
        }
        goOn(low);
        goOn(high);
        std::uint8_t* row = others + y * kRowBytes;
        for (std::ptrdiff_t i = 0; i < kRowBytes; i += lanes) {
            auto least = hn::LoadU(d, low.data() + i);
            auto most = hn::LoadU(d, high.data() + i);
            for (std::ptrdiff_t beside = 3; beside <= 2 * kBeside; beside += 3) {
                least = hn::Min(least, hn::LoadU(d, low.data() + i + beside));
                most = hn::Max(most, hn::LoadU(d, high.data() + i + beside));
            }
            const auto within = hn::Max(hn::LoadU(d, row + i), hn::Sub(hn::Max(least, margin), margin));
            hn::StoreU(hn::Min(within, hn::Add(hn::Min(most, hn::Sub(all, margin)), margin)), d, row + i);
        }
    }
}

void mixColours(const std::uint8_t* other, const std::uint8_t* shares, std::uint8_t* colours) {
    using Words = hn::CappedTag<std::uint16_t, kCell>;
    const Bytes d8;
    const Words d;
    const hn::Rebind<std::uint8_t, Words> half;
    HWY_ALIGN std::array<std::uint8_t, kRowBytes> triples;
    for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d8))) {
        const auto share = hn::LoadU(d8, shares + x);
        hn::StoreInterleaved3(share, share, share, d8, triples.data() + 3 * x);
    }
    const auto all = hn::Set(d, std::uint16_t{255});
    for (std::ptrdiff_t k = 0; k < kRowBytes; k += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
        const auto share = hn::PromoteTo(d, hn::LoadU(half, triples.data() + k));
        const auto first = hn::Mul(hn::PromoteTo(d, hn::LoadU(half, colours + k)), hn::Sub(all, share));
        const auto second = hn::Mul(hn::PromoteTo(d, hn::LoadU(half, other + k)), share);
        const auto sum = hn::Add(hn::Add(first, second), hn::Set(d, std::uint16_t{128}));
        const auto mean = hn::ShiftRight<8>(hn::Add(sum, hn::ShiftRight<8>(sum)));
        hn::StoreU(hn::DemoteTo(half, hn::BitCast(hn::RebindToSigned<Words>(), mean)), half, colours + k);
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(keepWithin);
HWY_EXPORT(mixColours);

void keepWithin(const std::uint8_t* colours, std::uint8_t* others) {
    HWY_DYNAMIC_DISPATCH(keepWithin)(colours, others);
}

void mixColours(const std::uint8_t* other, const std::uint8_t* shares, std::uint8_t* colours) {
    HWY_DYNAMIC_DISPATCH(mixColours)(other, shares, colours);
}

} // namespace spherewalk::render::simd

namespace spherewalk::render {

namespace {

/// The colours of a cell's pixels, row after row.
using CellColours = std::array<std::uint8_t, std::size_t{3} * SurfaceCoordinates::kCellPixels>;

/// Takes the colours that a view has in a cell. Beyond the view's edges the last ones go on.
void copyCell(RgbImage& picture, int left, int top, int width, int height, CellColours& colours) {
    for (int y = 0; y < kCell; ++y) {
        std::uint8_t* row = colours.data() + std::ptrdiff_t{3} * kCell * y;
        std::copy_n(picture.at(left, top + std::min(y, height - 1)), 3 * width, row);
        for (int x = 3 * width; x < 3 * kCell; ++x) {
            row[x] = row[x - 3];
        }
    }
}

} // namespace

/// Tells holes from what is seen, before holes get distances.
void SurfaceView::markHoles(WorkerPool& pool, int threads) {
    if (m_known.width() != m_coordinates.source.width() ||
        m_known.height() != m_coordinates.source.height()) {
        m_known = MaskImage(m_coordinates.source.width(), m_coordinates.source.height());
    }
    pool.run(m_coordinates.rows(), threads, [&](int row, int) {
        const auto width = static_cast<std::size_t>(m_known.width());
        std::fill_n(m_known.at(0, row * kCell), kCell * width, static_cast<std::uint8_t>(Known::Seen));
        for (int column = 0; column < m_coordinates.columns(); ++column) {
            for (int y = row * kCell; y < (row + 1) * kCell && m_open.isOpen(column, row); ++y) {
                const float* inverse = m_coordinates.inverse.at(column * kCell, y);
                std::uint8_t* known = m_known.at(column * kCell, y);
                for (int x = 0; x < kCell; ++x) {
                    known[x] = static_cast<std::uint8_t>(inverse[x] > 0 ? Known::Seen : Known::Nothing);
                }
            }
        }
    });
}

/// Samples the second photo in all of a cell.
void SurfaceView::sampleMixed(const Cell& at, const PlaneView& plane, Sampling sampling,
                              SampleSpace& space) const {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    const std::size_t first = cell * SurfaceCoordinates::kCellPixels;
    fillPlaces(cell, 1, plane, sampling,
               {m_coordinates.mixedU.data() + first, m_coordinates.mixedV.data() + first, kCell}, space);
    simd::sample(plane, sampling,
                 {space.places.data(), space.fractions.data(), m_samples, space.colours.data(),
                  std::ptrdiff_t{3} * kCell, kCell, kCell, true});
    m_drawn[1].brighten(space.colours.data(), SurfaceCoordinates::kCellPixels);
}

/// Looks up the colour weights of a cell's pixels in a photo. u, v: their coordinates.
void SurfaceView::look(const Drawn& drawn, const std::int32_t* u, const std::int32_t* v, CellBytes& weights) {
    const MaskImage& mask = drawn.mesh->colourWeights();
    const simd::MaskPlacing placing{(PlaneLayout::kGuard - 0.5F) * kFixedOne,
                                    static_cast<float>(mask.width()) / static_cast<float>(drawn.size.width) /
                                        kFixedOne,
                                    mask.width(), mask.height()};
    std::array<std::int32_t, SurfaceCoordinates::kCellPixels> places;
    simd::placeInMask(placing, u, v, places.data());
    const std::uint8_t* values = mask.values().data();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = values[places[i]];
    }
}

/// Lets the rims of things count little in a mixed cell. shares: those of the second photo.
void SurfaceView::weighRims(const Cell& at, CellBytes& shares) {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    const std::size_t first = cell * SurfaceCoordinates::kCellPixels;
    const std::uint32_t sources = m_coordinates.sources[cell];
    CellBytes own{};
    CellBytes looked{};
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        if ((sources >> i & 1U) == 0) {
            continue;
        }
        look(m_drawn[i], m_coordinates.u.data() + first, m_coordinates.v.data() + first,
             i == 0 ? own : looked);
        for (int y = 0; y < kCell && i > 0; ++y) {
            const std::uint8_t* source = m_coordinates.source.at(at.column * kCell, at.row * kCell + y);
            for (std::size_t x = 0; x < kCell; ++x) {
                std::uint8_t& weight = own[static_cast<std::size_t>(y) * kCell + x];
                weight = source[x] == i ? looked[static_cast<std::size_t>(y) * kCell + x] : weight;
            }
        }
    }
    look(m_drawn[1], m_coordinates.mixedU.data() + first, m_coordinates.mixedV.data() + first, looked);
    simd::weighShares(own.data(), looked.data(), shares.data());
}

/// Mixes the second photo into a cell, whose first photo is sampled.
void SurfaceView::mix(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                      SampleSpace& space, RgbImage& picture) {
    const std::uint32_t sources = m_coordinates.sources[m_coordinates.index(at.column, at.row)];
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    if ((sources & SurfaceCoordinates::kMixed) != 0) {
        CellBytes shares;
        for (int y = 0; y < kCell; ++y) {
            std::copy_n(m_coordinates.share.at(left, top + y), kCell, shares.begin() + y * kCell);
        }
        if ((sources & SurfaceCoordinates::kRims) != 0) {
            weighRims(at, shares);
        }
        sampleMixed(at, planes[1], sampling, space);
        CellColours colours;
        copyCell(picture, left, top, at.width, at.height, colours);
        simd::keepWithin(colours.data(), space.colours.data());
        for (std::ptrdiff_t y = 0; y < at.height; ++y) {
            std::uint8_t* row = colours.data() + 3 * kCell * y;
            simd::mixColours(space.colours.data() + 3 * kCell * y, shares.data() + kCell * y, row);
            std::copy_n(row, 3 * at.width, picture.at(left, top + static_cast<int>(y)));
        }
    }
    for (int y = 0; y < at.height && (sources & SurfaceCoordinates::kBlind) != 0; ++y) {
        for (int x = 0; x < at.width; ++x) {
            if (*m_coordinates.source.at(left + x, top + y) == SurfaceCoordinates::kUnseen) {
                std::fill_n(picture.at(left + x, top + y), 3, std::uint8_t{0});
                *m_known.at(left + x, top + y) = static_cast<std::uint8_t>(Known::Outside);
            }
        }
    }
}

} // namespace spherewalk::render

#endif
