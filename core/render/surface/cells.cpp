// SPDX-License-Identifier: Apache-2.0
#include "surface/cells.h"

#include "pixels/photo_plane.h"
#include "surface/pieces.h"

#include <algorithm>
#include <limits>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/cells.cpp"
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

std::array<float, 2> range(const float* values, std::ptrdiff_t pitch) {
    const F d;
    V least = hn::LoadU(d, values);
    V greatest = least;
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const V value = hn::LoadU(d, values + y * pitch + x);
            least = hn::Min(least, value);
            greatest = hn::Max(greatest, value);
        }
    }
    return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
}

int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofSubCells) {
    const F d;
    const I di;
    constexpr int kSubCell = 4;
    std::array<std::int32_t, kCell * kCell / kSubCell> ofColumns;
    VI any = hn::Zero(di);
    for (int y = 0; y < kCell; y += kSubCell) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            VI count = hn::Zero(di);
            for (int i = 0; i < kSubCell; ++i) {
                const V value = hn::LoadU(d, values + (y + i) * pitch + x);
                const auto isZero = hn::RebindMask(di, hn::Eq(value, hn::Zero(d)));
                count = hn::Add(count, hn::IfThenElseZero(isZero, hn::Set(di, 1)));
            }
            any = hn::Or(any, count);
            hn::StoreU(count, di, ofColumns.data() + y * (kCell / kSubCell) + x);
        }
    }
    ofSubCells = {};
    if (hn::AllTrue(di, hn::Eq(any, hn::Zero(di)))) {
        return 0;
    }
    int all = 0;
    for (std::size_t i = 0; i < ofColumns.size(); ++i) {
        ofSubCells[i / kSubCell] += ofColumns[i];
        all += ofColumns[i];
    }
    return all;
}

bool takeUnseen(const float* seen, std::ptrdiff_t pitch, std::uint8_t photo, float* values,
                std::uint8_t* sources) {
    const F d;
    const I di;
    const hn::Rebind<std::uint8_t, I> d8;
    bool any = false;
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const std::ptrdiff_t at = y * pitch + x;
            const V mine = hn::LoadU(d, values + at);
            const V other = hn::LoadU(d, seen + at);
            const auto takes = hn::And(hn::Eq(mine, hn::Zero(d)), hn::Gt(other, hn::Zero(d)));
            if (hn::AllFalse(d, takes)) {
                continue;
            }
            any = true;
            hn::StoreU(hn::IfThenElse(takes, other, mine), d, values + at);
            const VI source = hn::PromoteTo(di, hn::LoadU(d8, sources + at));
            const VI taken = hn::IfThenElse(hn::RebindMask(di, takes), hn::Set(di, photo), source);
            hn::StoreU(hn::DemoteTo(d8, taken), d8, sources + at);
        }
    }
    return any;
}

Mixture mixDistances(const float* second, std::ptrdiff_t pitch, float perFirst, float* values,
                     std::uint8_t* sources, std::uint8_t* shares) {
    // Distances that differ by so much, as a share of 1 / s, are not of one thing.
    constexpr float kOther = 0.1F;
    const F d;
    const I di;
    const hn::Rebind<std::uint8_t, I> d8;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1);
    const V weight = hn::Set(d, perFirst);
    Mixture mixture;
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const std::ptrdiff_t at = y * pitch + x;
            const V mine = hn::LoadU(d, values + at);
            const V other = hn::LoadU(d, second + at);
            const auto isOpen = hn::Eq(mine, zero);
            const auto isOther = hn::Gt(other, zero);
            const V scale = hn::Set(d, kOther) * hn::Max(hn::Max(mine, other), hn::Set(d, 1e-30F));
            const V apart = (other - mine) / scale;
            const V alike = hn::Max(zero, one - apart * apart);
            const V both = hn::IfThenElseZero(hn::AndNot(isOpen, isOther), weight * alike);
            const V total = one + both;
            const V mean = (mine + both * other) / total;
            hn::StoreU(hn::IfThenElse(isOpen, other, mean), d, values + at);
            const VI share = hn::ConvertTo(di, hn::Set(d, 255) * both / total + hn::Set(d, 0.5F));
            hn::StoreU(hn::DemoteTo(d8, share), d8, shares + at);
            mixture.isMixed |= !hn::AllTrue(di, hn::Eq(share, hn::Zero(di)));
            if (hn::AllFalse(d, isOpen)) {
                continue;
            }
            mixture.open += static_cast<int>(hn::CountTrue(d, isOpen));
            const auto isOthers = hn::And(isOpen, isOther);
            mixture.hasOthers |= !hn::AllFalse(d, isOthers);
            const VI source = hn::PromoteTo(di, hn::LoadU(d8, sources + at));
            const VI taken = hn::IfThenElse(hn::RebindMask(di, isOthers), hn::Set(di, 1), source);
            hn::StoreU(hn::DemoteTo(d8, taken), d8, sources + at);
        }
    }
    return mixture;
}

void placeRows(const SamplePlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows,
               int apart, std::int32_t* places, std::int32_t* fractions) {
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

void placeInMask(const MaskPlacing& placing, const std::int32_t* u, const std::int32_t* v,
                 std::int32_t* places) {
    const F df;
    const I d;
    const V first = hn::Set(df, placing.first);
    const V scale = hn::Set(df, placing.scale);
    const VI width = hn::Set(d, placing.width);
    const VI lastColumn = hn::Set(d, placing.width - 1);
    const VI lastRow = hn::Set(d, placing.height - 1);
    const VI zero = hn::Zero(d);
    for (std::ptrdiff_t x = 0; x < kCell * kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
        const V right = hn::Mul(hn::Sub(hn::ConvertTo(df, hn::LoadU(d, u + x)), first), scale);
        const V down = hn::Mul(hn::Sub(hn::ConvertTo(df, hn::LoadU(d, v + x)), first), scale);
        VI column = hn::ConvertTo(d, right);
        column = hn::Add(column, hn::IfThenElseZero(hn::Lt(column, zero), width));
        column = hn::Sub(column, hn::IfThenElseZero(hn::Gt(column, lastColumn), width));
        column = hn::Min(hn::Max(column, zero), lastColumn);
        const VI row = hn::Min(hn::Max(hn::ConvertTo(d, down), zero), lastRow);
        hn::StoreU(hn::Add(hn::Mul(row, width), column), d, places + x);
    }
}

void weighShares(const std::uint8_t* own, const std::uint8_t* other, std::uint8_t* shares) {
    const F df;
    const I d;
    const hn::Rebind<std::uint8_t, I> d8;
    const VI all = hn::Set(d, 255);
    for (std::ptrdiff_t at = 0; at < kCell * kCell; at += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
        const VI share = hn::PromoteTo(d, hn::LoadU(d8, shares + at));
        const VI second = hn::Mul(share, hn::PromoteTo(d, hn::LoadU(d8, other + at)));
        const VI first = hn::Mul(hn::Sub(all, share), hn::PromoteTo(d, hn::LoadU(d8, own + at)));
        const VI total = hn::Add(first, second);
        const V part = hn::ConvertTo(df, hn::Mul(all, second)) / hn::ConvertTo(df, total);
        hn::StoreU(hn::DemoteTo(d8, hn::ConvertTo(d, part + hn::Set(df, 0.5F))), d8, shares + at);
    }
}

void takeOwn(const std::int32_t* ownU, const std::int32_t* ownV, const std::uint8_t* sources,
             std::ptrdiff_t pitch, std::uint8_t photo, std::int32_t* u, std::int32_t* v) {
    const I d;
    const hn::Rebind<std::uint8_t, I> d8;
    const VI one = hn::Set(d, photo);
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const VI source = hn::PromoteTo(d, hn::LoadU(d8, sources + y * pitch + x));
            const auto isOwn = hn::Eq(source, one);
            const std::ptrdiff_t at = y * kCell + x;
            hn::StoreU(hn::IfThenElse(isOwn, hn::LoadU(d, ownU + at), hn::LoadU(d, u + at)), d, u + at);
            hn::StoreU(hn::IfThenElse(isOwn, hn::LoadU(d, ownV + at), hn::LoadU(d, v + at)), d, v + at);
        }
    }
}

std::array<std::int32_t, 4> boxOfAll(const std::int32_t* u, const std::int32_t* v) {
    const I d;
    VI left = hn::LoadU(d, u);
    VI right = left;
    VI top = hn::LoadU(d, v);
    VI bottom = top;
    for (std::ptrdiff_t i = 0; i < kCell * kCell; i += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
        const VI atU = hn::LoadU(d, u + i);
        const VI atV = hn::LoadU(d, v + i);
        left = hn::Min(left, atU);
        right = hn::Max(right, atU);
        top = hn::Min(top, atV);
        bottom = hn::Max(bottom, atV);
    }
    return {hn::GetLane(hn::MinOfLanes(d, left)), hn::GetLane(hn::MaxOfLanes(d, right)),
            hn::GetLane(hn::MinOfLanes(d, top)), hn::GetLane(hn::MaxOfLanes(d, bottom))};
}

std::array<std::int32_t, 4> boxOfPhoto(const std::int32_t* u, const std::int32_t* v,
                                       const std::uint8_t* sources, std::ptrdiff_t pitch,
                                       std::uint8_t photo) {
    const I d;
    const hn::Rebind<std::uint8_t, I> d8;
    const VI most = hn::Set(d, std::numeric_limits<std::int32_t>::max());
    const VI one = hn::Set(d, photo);
    VI left = most;
    VI right = hn::Zero(d);
    VI top = most;
    VI bottom = hn::Zero(d);
    for (int y = 0; y < kCell; ++y) {
        for (std::ptrdiff_t x = 0; x < kCell; x += static_cast<std::ptrdiff_t>(hn::Lanes(d))) {
            const VI source = hn::PromoteTo(d, hn::LoadU(d8, sources + y * pitch + x));
            const auto isOwn = hn::Eq(source, one);
            const VI atU = hn::LoadU(d, u + y * kCell + x);
            const VI atV = hn::LoadU(d, v + y * kCell + x);
            left = hn::Min(left, hn::IfThenElse(isOwn, atU, most));
            right = hn::Max(right, hn::IfThenElseZero(isOwn, atU));
            top = hn::Min(top, hn::IfThenElse(isOwn, atV, most));
            bottom = hn::Max(bottom, hn::IfThenElseZero(isOwn, atV));
        }
    }
    return {hn::GetLane(hn::MinOfLanes(d, left)), hn::GetLane(hn::MaxOfLanes(d, right)),
            hn::GetLane(hn::MinOfLanes(d, top)), hn::GetLane(hn::MaxOfLanes(d, bottom))};
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(range);
HWY_EXPORT(zeros);
HWY_EXPORT(takeUnseen);
HWY_EXPORT(mixDistances);
HWY_EXPORT(placeRows);
HWY_EXPORT(placeInMask);
HWY_EXPORT(weighShares);
HWY_EXPORT(takeOwn);
HWY_EXPORT(boxOfAll);
HWY_EXPORT(boxOfPhoto);

std::array<float, 2> range(const float* values, std::ptrdiff_t pitch) {
    return HWY_DYNAMIC_DISPATCH(range)(values, pitch);
}

int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofSubCells) {
    return HWY_DYNAMIC_DISPATCH(zeros)(values, pitch, ofSubCells);
}

bool takeUnseen(const float* seen, std::ptrdiff_t pitch, std::uint8_t photo, float* values,
                std::uint8_t* sources) {
    return HWY_DYNAMIC_DISPATCH(takeUnseen)(seen, pitch, photo, values, sources);
}

Mixture mixDistances(const float* second, std::ptrdiff_t pitch, float perFirst, float* values,
                     std::uint8_t* sources, std::uint8_t* shares) {
    return HWY_DYNAMIC_DISPATCH(mixDistances)(second, pitch, perFirst, values, sources, shares);
}

void placeRows(const SamplePlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows,
               int apart, std::int32_t* places, std::int32_t* fractions) {
    HWY_DYNAMIC_DISPATCH(placeRows)(placing, u, v, rows, apart, places, fractions);
}

void placeInMask(const MaskPlacing& placing, const std::int32_t* u, const std::int32_t* v,
                 std::int32_t* places) {
    HWY_DYNAMIC_DISPATCH(placeInMask)(placing, u, v, places);
}

void weighShares(const std::uint8_t* own, const std::uint8_t* other, std::uint8_t* shares) {
    HWY_DYNAMIC_DISPATCH(weighShares)(own, other, shares);
}

void takeOwn(const std::int32_t* ownU, const std::int32_t* ownV, const std::uint8_t* sources,
             std::ptrdiff_t pitch, std::uint8_t photo, std::int32_t* u, std::int32_t* v) {
    HWY_DYNAMIC_DISPATCH(takeOwn)(ownU, ownV, sources, pitch, photo, u, v);
}

std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v) {
    return HWY_DYNAMIC_DISPATCH(boxOfAll)(u, v);
}

std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v,
                                      const std::uint8_t* sources, std::ptrdiff_t pitch, std::uint8_t photo) {
    return HWY_DYNAMIC_DISPATCH(boxOfPhoto)(u, v, sources, pitch, photo);
}

} // namespace spherewalk::render::simd

namespace spherewalk::render {

namespace {

int padded(int pixels) {
    return (pixels + simd::kColumns - 1) / simd::kColumns * simd::kColumns;
}

} // namespace

void fit(InverseBuffer& buffer, int width, int height) {
    if (buffer.width() != padded(width) || buffer.height() != padded(height)) {
        buffer = InverseBuffer(padded(width), padded(height));
    }
}

OpenCells::OpenCells(int width, int height)
    : m_width((width + kCell - 1) / kCell * kSubCells),
      m_height((height + kCell - 1) / kCell * kSubCells),
      m_sums(static_cast<std::size_t>((m_width + 1) * (m_height + 1))),
      m_cells(static_cast<std::size_t>(m_width * m_height / (kSubCells * kSubCells)), kCell * kCell) {
    for (int y = 0; y <= m_height; ++y) {
        for (int x = 0; x <= m_width; ++x) {
            m_sums[static_cast<std::size_t>(y * (m_width + 1) + x)] = x * y * kSubCell * kSubCell;
        }
    }
}

int OpenCells::update(const InverseBuffer& covered, WorkerPool& pool, int threads) {
    const int columns = m_width / kSubCells;
    std::vector<int> parts(static_cast<std::size_t>(m_width * m_height));
    pool.run(m_height / kSubCells, threads, [&](int row, int) {
        std::array<std::int32_t, kSubCells * kSubCells> ofSubCells;
        for (int column = 0; column < columns; ++column) {
            if (!isOpen(column, row)) {
                continue;
            }
            m_cells[static_cast<std::size_t>(row * columns + column)] =
                simd::zeros(covered.at(column * kCell, row * kCell), covered.width(), ofSubCells);
            for (int i = 0; i < kSubCells; ++i) {
                std::copy_n(ofSubCells.begin() + i * kSubCells, kSubCells,
                            parts.begin() + (row * kSubCells + i) * m_width + column * kSubCells);
            }
        }
    });
    const std::size_t pitch = static_cast<std::size_t>(m_width) + 1;
    for (std::size_t y = 1; y <= static_cast<std::size_t>(m_height); ++y) {
        int inRow = 0;
        for (std::size_t x = 1; x < pitch; ++x) {
            inRow += parts[(y - 1) * (pitch - 1) + x - 1];
            m_sums[y * pitch + x] = inRow + m_sums[(y - 1) * pitch + x];
        }
    }
    return std::accumulate(m_cells.begin(), m_cells.end(), 0);
}

void OpenCells::clear(int row, InverseBuffer& buffer) const {
    if (isAllOpen()) {
        std::fill_n(buffer.at(0, row * kCell), static_cast<std::ptrdiff_t>(buffer.width()) * kCell, 0.0F);
        return;
    }
    for (int column = 0; column < buffer.width() / kCell; ++column) {
        for (int y = 0; y < kCell && isOpen(column, row); ++y) {
            std::fill_n(buffer.at(column * kCell, row * kCell + y), kCell, 0.0F);
        }
    }
}

bool OpenCells::anyIn(float left, float top, float right, float bottom) const {
    const auto part = [](float pixel, int count, int more) {
        const float inView = std::min(std::max(pixel * (1.0F / kSubCell), -1.0F), static_cast<float>(count));
        return std::min(std::max(static_cast<int>(inView + 1) - 1 + more, 0), count);
    };
    const int column = part(left, m_width, 0);
    const int endColumn = part(right, m_width, 1);
    const int row = part(top, m_height, 0);
    const int endRow = part(bottom, m_height, 1);
    return endColumn > column && endRow > row && sum(column, row, endColumn, endRow) > 0;
}

} // namespace spherewalk::render

#endif
