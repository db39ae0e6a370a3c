// SPDX-License-Identifier: Apache-2.0
#include "surface/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/pieces.cpp"
// The order matters here.
// clang-format off
#include <hwy/foreach_target.h>
#include "sphere/lattice-inl.h"
// clang-format on

#ifndef SPHEREWALK_SURFACE_PIECES_ONCE
#define SPHEREWALK_SURFACE_PIECES_ONCE

namespace spherewalk::render::simd {

constexpr float kOverlapPx = 0.25F; ///< Pieces reach so far beyond their edges, so that no cracks stay.
constexpr float kLeastTurn = 1e-4F; ///< A quad with a thinner corner is drawn as triangles, if at all.

/// A vertex with the values of ProjectedBlock.
struct Vertex {
    float x, y, value;
};

} // namespace spherewalk::render::simd

#endif

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
using I = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<I>;

/// The least and the greatest of four.
template <class Four>
HWY_INLINE VF leastOf(const Four& of) {
    return hn::Min(hn::Min(of[0], of[1]), hn::Min(of[2], of[3]));
}

template <class Four>
HWY_INLINE VF greatestOf(const Four& of) {
    return hn::Max(hn::Max(of[0], of[1]), hn::Max(of[2], of[3]));
}

/// The first pixel that is not before `begin`, and the last that is not after `end`; none unless it is
/// wanted.
template <class Mask>
HWY_INLINE std::array<VI, 2> pixelsBetween(VF begin, VF end, int last, Mask isWanted) {
    const F d;
    const I di;
    const auto isPlaced = hn::RebindMask(di, isWanted);
    const VF inView = hn::Min(hn::Max(begin, hn::Zero(d)), hn::Set(d, static_cast<float>(last + 1)));
    const VI cut = hn::ConvertTo(di, inView);
    const auto isCut = hn::RebindMask(di, hn::Lt(hn::ConvertTo(d, cut), inView));
    const VI first = hn::Add(cut, hn::IfThenElseZero(isCut, hn::Set(di, 1)));
    const VF until = hn::Min(hn::Max(end, hn::Set(d, -1.0F)), hn::Set(d, static_cast<float>(last)));
    const VI beyond = hn::ConvertTo(di, hn::Add(until, hn::Set(d, 1.0F)));
    return {hn::IfThenElseZero(isPlaced, first),
            hn::Sub(hn::IfThenElseZero(isPlaced, beyond), hn::Set(di, 1))};
}

/// Cuts as many quads as a vector has lanes.
HWY_INLINE void cutSome(const Quads& quads, std::size_t from, int width, int height, CutQuads& out) {
    const F d;
    const auto four = [&](const auto& of) {
        return std::array<VF, 4>{hn::LoadU(d, of[0].data() + from), hn::LoadU(d, of[1].data() + from),
                                 hn::LoadU(d, of[2].data() + from), hn::LoadU(d, of[3].data() + from)};
    };
    const std::array<VF, 4> x = four(quads.x);
    const std::array<VF, 4> y = four(quads.y);
    const std::array<VF, 4> value = four(quads.value);
    const VF overlap = hn::Set(d, kOverlapPx);
    const auto isPlaced = hn::Gt(leastOf(value), hn::Zero(d));
    const std::array<VI, 2> columns =
        pixelsBetween(hn::Sub(leastOf(x), overlap), hn::Add(greatestOf(x), overlap), width - 1, isPlaced);
    const std::array<VI, 2> rows =
        pixelsBetween(hn::Sub(leastOf(y), overlap), hn::Add(greatestOf(y), overlap), height - 1, isPlaced);
    const std::size_t to = 4 * from;
    hn::StoreInterleaved4(columns[0], rows[0], columns[1], rows[1], I(), out.box.data() + to);
    // Twice the areas of its corners' triangles: all of one sign if it is convex.
    std::array<VF, 4> turns;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        const std::size_t k = (i + 2) % 4;
        turns[i] = hn::Sub(hn::Mul(hn::Sub(x[j], x[i]), hn::Sub(y[k], y[i])),
                           hn::Mul(hn::Sub(x[k], x[i]), hn::Sub(y[j], y[i])));
    }
    const VF left = hn::IfThenElseZero(hn::Gt(leastOf(turns), hn::Set(d, kLeastTurn)), hn::Set(d, 1.0F));
    const VF sign =
        hn::IfThenElse(hn::Lt(greatestOf(turns), hn::Set(d, -kLeastTurn)), hn::Set(d, -1.0F), left);
    hn::StoreU(sign, d, out.sign.data() + from);
    std::array<VF, 4> a;
    std::array<VF, 4> b;
    std::array<VF, 4> c;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        a[i] = hn::Mul(sign, hn::Sub(y[i], y[j]));
        b[i] = hn::Mul(sign, hn::Sub(x[j], x[i]));
        c[i] = hn::Sub(hn::Mul(overlap, hn::Add(hn::Abs(a[i]), hn::Abs(b[i]))),
                       mulAdd(a[i], x[i], hn::Mul(b[i], y[i])));
    }
    hn::StoreInterleaved4(a[0], a[1], a[2], a[3], d, out.a.data() + to);
    hn::StoreInterleaved4(b[0], b[1], b[2], b[3], d, out.b.data() + to);
    hn::StoreInterleaved4(c[0], c[1], c[2], c[3], d, out.c.data() + to);
    const VF x1 = hn::Sub(x[2], x[0]);
    const VF y1 = hn::Sub(y[2], y[0]);
    const VF rise1 = hn::Sub(value[2], value[0]);
    const VF x2 = hn::Sub(x[3], x[1]);
    const VF y2 = hn::Sub(y[3], y[1]);
    const VF rise2 = hn::Sub(value[3], value[1]);
    const VF scale = hn::Div(hn::Set(d, 1.0F), hn::Sub(hn::Mul(x1, y2), hn::Mul(x2, y1)));
    const VF slopeX = hn::Mul(hn::Sub(hn::Mul(rise1, y2), hn::Mul(rise2, y1)), scale);
    const VF slopeY = hn::Mul(hn::Sub(hn::Mul(x1, rise2), hn::Mul(x2, rise1)), scale);
    const auto sum = [](const auto& of) { return hn::Add(hn::Add(of[0], of[1]), hn::Add(of[2], of[3])); };
    const VF base =
        hn::Mul(hn::Set(d, 0.25F), hn::Sub(sum(value), mulAdd(slopeX, sum(x), hn::Mul(slopeY, sum(y)))));
    hn::StoreInterleaved4(slopeX, slopeY, base, leastOf(value), d, out.plane.data() + to);
    hn::StoreU(greatestOf(value), d, out.most.data() + from);
}

void cut(const Quads& quads, int width, int height, CutQuads& out) {
    for (std::size_t from = 0; from < static_cast<std::size_t>(quads.count); from += hn::Lanes(F())) {
        cutSome(quads, from, width, height, out);
    }
}

void draw(std::span<const Piece> pieces, int begin, int end, float* values, std::ptrdiff_t pitch) {
    const F d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const VF zero = hn::Zero(d);
    for (const Piece& piece : pieces) {
        const int first = std::max(begin, piece.box.top);
        const int last = std::min(end - 1, piece.box.bottom);
        const VF least = hn::Set(d, piece.plane.least);
        const VF most = hn::Set(d, piece.most);
        const VF left = hn::Set(d, static_cast<float>(piece.box.left));
        const VF right = hn::Set(d, static_cast<float>(piece.box.right));
        const VF b0 = hn::Set(d, piece.b[0]);
        const VF b1 = hn::Set(d, piece.b[1]);
        const VF b2 = hn::Set(d, piece.b[2]);
        const VF b3 = hn::Set(d, piece.b[3]);
        const VF slope = hn::Set(d, piece.plane.slopeY);
        for (int next = piece.box.left; next <= piece.box.right; next += lanes) {
            const int x = std::min(next, static_cast<int>(pitch) - lanes); // not beyond the row
            const VF column = hn::Iota(d, static_cast<float>(x));
            // Sharp corners, once their edges were moved, reach beyond the columns that are asked for.
            const auto isAsked = hn::And(hn::Ge(column, left), hn::Le(column, right));
            const VF asked = hn::IfThenElse(isAsked, hn::Set(d, piece.c[0]), hn::Set(d, -HUGE_VALF));
            const VF a0 = mulAdd(hn::Set(d, piece.a[0]), column, asked);
            const VF a1 = mulAdd(hn::Set(d, piece.a[1]), column, hn::Set(d, piece.c[1]));
            const VF a2 = mulAdd(hn::Set(d, piece.a[2]), column, hn::Set(d, piece.c[2]));
            const VF a3 = mulAdd(hn::Set(d, piece.a[3]), column, hn::Set(d, piece.c[3]));
            const VF base = mulAdd(hn::Set(d, piece.plane.slopeX), column, hn::Set(d, piece.plane.base));
            VF at = hn::Set(d, static_cast<float>(first));
            for (int y = first; y <= last; ++y, at = hn::Add(at, hn::Set(d, 1.0F))) {
                const VF inside = hn::Min(hn::Min(mulAdd(b0, at, a0), mulAdd(b1, at, a1)),
                                          hn::Min(mulAdd(b2, at, a2), mulAdd(b3, at, a3)));
                const VF value = hn::Min(hn::Max(mulAdd(slope, at, base), least), most);
                const VF drawn = hn::IfThenElseZero(hn::Ge(inside, zero), value);
                float* to = values + y * pitch + x;
                hn::StoreU(hn::Max(hn::LoadU(d, to), drawn), d, to);
            }
        }
    }
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace spherewalk::render::simd {

HWY_EXPORT(cut);
HWY_EXPORT(draw);

namespace {

/// Four values that SIMD stored together.
template <class Four, class Fours>
void copy(const Fours& from, std::size_t quad, Four& to) {
    static_assert(sizeof(to) == 4 * sizeof(from[0]) && std::is_trivially_copyable_v<Four>);
    std::memcpy(&to, from.data() + 4 * quad, sizeof(to));
}

Piece piece(const CutQuads& from, std::size_t quad) {
    Piece piece;
    copy(from.a, quad, piece.a);
    copy(from.b, quad, piece.b);
    copy(from.c, quad, piece.c);
    copy(from.plane, quad, piece.plane);
    copy(from.box, quad, piece.box);
    piece.most = from.most[quad];
    return piece;
}

/// A triangle within the piece's pixels, if it is not too thin.
void addTriangle(const std::array<Vertex, 3>& v, Piece piece, std::vector<Piece>& pieces) {
    const float x1 = v[1].x - v[0].x;
    const float y1 = v[1].y - v[0].y;
    const float x2 = v[2].x - v[0].x;
    const float y2 = v[2].y - v[0].y;
    const float area = x1 * y2 - x2 * y1;
    if (!(std::abs(area) > kLeastTurn)) {
        return;
    }
    const float sign = area > 0 ? 1.0F : -1.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex& to = v[(i + 1) % 3];
        const float a = sign * (v[i].y - to.y);
        const float b = sign * (to.x - v[i].x);
        piece.a[i] = a;
        piece.b[i] = b;
        piece.c[i] = kOverlapPx * (std::abs(a) + std::abs(b)) - (a * v[i].x + b * v[i].y);
    }
    piece.a[3] = 0;
    piece.b[3] = 0;
    piece.c[3] = 1;
    const float rise1 = v[1].value - v[0].value;
    const float rise2 = v[2].value - v[0].value;
    Piece::Plane& plane = piece.plane;
    plane.slopeX = (rise1 * y2 - rise2 * y1) / area;
    plane.slopeY = (x1 * rise2 - x2 * rise1) / area;
    plane.base = v[0].value - plane.slopeX * v[0].x - plane.slopeY * v[0].y;
    plane.least = std::min(v[0].value, std::min(v[1].value, v[2].value));
    piece.most = std::max(v[0].value, std::max(v[1].value, v[2].value));
    pieces.push_back(piece);
}

} // namespace

void cut(const Quads& quads, int width, int height, CutQuads& cut) {
    HWY_DYNAMIC_DISPATCH(cut)(quads, width, height, cut);
}

void add(const Quads& quads, const CutQuads& cut, std::size_t quad, std::vector<Piece>& pieces) {
    if (cut.sign[quad] != 0) {
        pieces.push_back(piece(cut, quad));
        return;
    }
    const auto vertex = [&](std::size_t i) {
        return Vertex{quads.x[i][quad], quads.y[i][quad], quads.value[i][quad]};
    };
    addTriangle({vertex(0), vertex(1), vertex(3)}, piece(cut, quad), pieces);
    addTriangle({vertex(1), vertex(2), vertex(3)}, piece(cut, quad), pieces);
}

void draw(std::span<const Piece> pieces, int begin, int end, float* values, std::ptrdiff_t pitch) {
    HWY_DYNAMIC_DISPATCH(draw)(pieces, begin, end, values, pitch);
}

} // namespace spherewalk::render::simd

#endif
