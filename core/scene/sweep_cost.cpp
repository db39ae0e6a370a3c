// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <utility>

namespace spherewalk::scene {

namespace {

/// Directions of a row's pixels.
struct RowRays {
    const float* cosAzimuth;
    const float* sinAzimuth;
    float cosElevation;
    float sinElevation;
};

/// The places of the values that a row is interpolated from.
struct RowPlaces {
    std::int32_t* first; ///< Index of the upper left pixel's values.
    float* right;
    float* down;
};

template <bool kAreOne>
inline __attribute__((always_inline)) void locateFrom(const RowRays& rays, const float* inverseM,
                                                      const LensNumbers& lenses, int count, int width,
                                                      float* __restrict u, float* __restrict v) {
    const LensNumbers numbers = lenses; // No store can change the copies.
    const RowRays r = rays;
    for (int i = 0; i < count; ++i) {
        const LensNumbers::Sight to = numbers.sight<kAreOne>(
            r.cosElevation * r.cosAzimuth[i], r.cosElevation * r.sinAzimuth[i], r.sinElevation, inverseM[i]);
        const FastPixel at = fastPixel(to.x, to.y, to.z, static_cast<float>(width));
        u[i] = at.u;
        v[i] = at.v;
    }
}

/// Where a neighbour of this width shows a row's pixels.
SPHEREWALK_VECTOR_CLONES
void locate(const RowRays& rays, const float* inverseM, const NeighbourLenses& lenses, int count, int width,
            float* u, float* v) {
    const LensNumbers numbers(lenses);
    if (numbers.areOne()) {
        locateFrom<true>(rays, inverseM, numbers, count, width, u, v);
    } else {
        locateFrom<false>(rays, inverseM, numbers, count, width, u, v);
    }
}

/// Where a neighbour shows things between two distances, if it shows those at (u, v) and (endU, endV). False
/// if one moves by more than a few pixels across: it passes a pole, and its place is wrong.
SPHEREWALK_VECTOR_CLONES
bool locateBetween(const float* u, const float* v, const float* endU, const float* endV, float share,
                   int count, int width, float* __restrict betweenU, float* __restrict betweenV) {
    constexpr float kMostPx = 4;
    const auto turn = static_cast<float>(width);
    std::int32_t isFar = 0;
    for (int i = 0; i < count; ++i) {
        const float across = endU[i] - u[i];
        const float back = across > 0.5F * turn ? turn : across < -0.5F * turn ? -turn : 0.0F;
        const float shorter = across - back;
        const float at = u[i] + share * shorter;
        betweenU[i] = at < 0 ? at + turn : at >= turn ? at - turn : at;
        betweenV[i] = v[i] + share * (endV[i] - v[i]);
        isFar |= static_cast<std::int32_t>(shorter > kMostPx) | static_cast<std::int32_t>(shorter < -kMostPx);
    }
    return isFar == 0;
}

SPHEREWALK_VECTOR_CLONES
void findPlaces(const float* u, const float* v, int count, int width, int stride, const RowPlaces& places) {
    std::int32_t* __restrict first = places.first;
    float* __restrict right = places.right;
    float* __restrict down = places.down;
    for (int i = 0; i < count; ++i) {
        const int column = std::min(static_cast<int>(u[i]), width - 1);
        const int line = std::min(static_cast<int>(v[i]), width / 2 - 1);
        first[i] = line * stride + 4 * column;
        right[i] = u[i] - static_cast<float>(column);
        down[i] = v[i] - static_cast<float>(line);
    }
}

using Eight = float __attribute__((vector_size(32)));
using EightInts = std::int32_t __attribute__((vector_size(32)));

/// Lanes of two vectors one after the other. Vectors go by reference: how they go by value depends on the
/// processor.
template <int... kLanes>
inline void choose(const Eight& a, const Eight& b, Eight& chosen) {
#ifdef __clang__
    chosen = __builtin_shufflevector(a, b, kLanes...);
#else
    chosen = __builtin_shuffle(a, b, EightInts{kLanes...});
#endif
}

/// Two pixels' weighted differences between their own values and a neighbour's interpolated ones. They count
/// up to a limit, since beyond it the neighbour shows something else.
inline void differences(const RowPlaces& places, int x, const float* here, const float* picture, int stride,
                        Eight& result) {
    constexpr Eight kWeights = {1, 1.5F, 1.5F, 0.8F, 1, 1.5F, 1.5F, 0.8F};
    constexpr Eight kLimits = Eight{20, 12, 12, 16, 20, 12, 12, 16} * kWeights;
    constexpr std::int32_t kAllButSign = 0x7FFFFFFF;
    Eight columns[2]; // of each pixel, the values on its left and those on its right
    for (int i = 0; i < 2; ++i) {
        Eight upper;
        Eight lower;
        std::memcpy(&upper, picture + places.first[x + i], sizeof upper);
        std::memcpy(&lower, picture + places.first[x + i] + stride, sizeof lower);
        columns[i] = upper + (lower - upper) * places.down[x + i];
    }
    Eight left;
    Eight beside;
    Eight own;
    choose<0, 1, 2, 3, 8, 9, 10, 11>(columns[0], columns[1], left);
    choose<4, 5, 6, 7, 12, 13, 14, 15>(columns[0], columns[1], beside);
    std::memcpy(&own, here + 4 * x, sizeof own);
    const float a = places.right[x];
    const float b = places.right[x + 1];
    const Eight difference = own - (left + (beside - left) * Eight{a, a, a, a, b, b, b, b});
    const auto size = reinterpret_cast<Eight>(reinterpret_cast<EightInts>(difference) & kAllButSign);
    const Eight weighted = size * kWeights;
    result = weighted < kLimits ? weighted : kLimits;
}

template <int... kLanes>
inline void addPairs(const Eight& a, const Eight& b, Eight& sums) {
    Eight other;
    choose<kLanes...>(a, b, sums);
    choose<(kLanes + 1)...>(a, b, other);
    sums += other;
}

/// Range: width a multiple of 8.
SPHEREWALK_VECTOR_CLONES
void costsAt(const RowPlaces& places, const float* here, const float* picture, int stride, int width,
             float* costs) {
    const RowPlaces p = places;
    for (int x = 0; x < width; x += 8) {
        Eight two[4];
        for (int i = 0; i < 4; ++i) {
            differences(p, x + 2 * i, here, picture, stride, two[i]);
        }
        Eight early;
        Eight late;
        Eight mixed;
        addPairs<0, 2, 8, 10, 4, 6, 12, 14>(two[0], two[1], early); // of the pixels 0, 2, 1, 3, two sums each
        addPairs<0, 2, 8, 10, 4, 6, 12, 14>(two[2], two[3], late);
        addPairs<0, 2, 8, 10, 4, 6, 12, 14>(early, late, mixed); // 0, 2, 4, 6, 1, 3, 5, 7
        Eight eight;
        choose<0, 4, 1, 5, 2, 6, 3, 7>(mixed, mixed, eight);
        std::memcpy(costs + x, &eight, sizeof eight);
    }
}

/// Sorts each column so far that its smallest `kept` values come first.
SPHEREWALK_VECTOR_CLONES
void sortSmallest(std::vector<std::vector<float>>& rows, std::size_t kept, int width) {
    for (std::size_t i = 0; i < kept; ++i) {
        for (std::size_t j = rows.size() - 1; j > i; --j) {
            float* __restrict a = rows[j - 1].data();
            float* __restrict b = rows[j].data();
            for (int x = 0; x < width; ++x) {
                const float low = a[x] < b[x] ? a[x] : b[x];
                const float high = a[x] < b[x] ? b[x] : a[x];
                a[x] = low;
                b[x] = high;
            }
        }
    }
}

std::size_t keptOf(std::size_t count, double share) {
    return std::max(1UL, static_cast<std::size_t>(std::lround(static_cast<double>(count) * share)));
}

constexpr float kSamePx = 2;        ///< Parallax by which two photos' depths of one thing may differ,
constexpr float kSameShare = 0.03F; ///< and the same as a share of 1 / distance.
constexpr float kSeenThrough = 6;   ///< What a neighbour that sees through a place adds to its cost.
constexpr float kHidden = 10;       ///< What neighbours add from which a place is hidden, if all are.
constexpr float kUnseen = 30;       ///< The cost of a place that no neighbour sees.

/// The neighbour's 1 / distance at the pixels nearest to the places.
void seenAt(const RowPlaces& places, const float* inverseM, int count, int width, float* seen) {
    for (int i = 0; i < count; ++i) {
        const int nearest =
            places.first[i] / 4 + (places.right[i] < 0.5F ? 0 : 1) + (places.down[i] < 0.5F ? 0 : width + 1);
        seen[i] = inverseM[nearest];
    }
}

/// 1 / the distance of each pixel's thing from the neighbour.
SPHEREWALK_VECTOR_CLONES
void expectedAt(const RowRays& rays, const float* inverseM, const NeighbourLenses& lenses, int width,
                float* __restrict expected) {
    const LensNumbers numbers(lenses);
    for (int i = 0; i < width; ++i) {
        const LensNumbers::Sight to =
            numbers.sight<false>(rays.cosElevation * rays.cosAzimuth[i],
                                 rays.cosElevation * rays.sinAzimuth[i], rays.sinElevation, inverseM[i]);
        const float squared = to.x * to.x + to.y * to.y + to.z * to.z;
        expected[i] = inverseM[i] / std::sqrt(squared < 1e-6F ? 1e-6F : squared);
    }
}

/// Makes a place that the neighbour cannot see endlessly dear, and one through which it sees dearer.
SPHEREWALK_VECTOR_CLONES
void judge(const float* seen, const float* expected, float pixelM, int width, float* __restrict hidden,
           float* __restrict costs) {
    for (int i = 0; i < width; ++i) {
        const float same = kSamePx * pixelM + kSameShare * expected[i];
        const bool isHidden = seen[i] > expected[i] + same;
        const float through = seen[i] < expected[i] - same ? kSeenThrough : 0.0F;
        costs[i] = isHidden ? HUGE_VALF : costs[i] + through;
        hidden[i] += isHidden ? 1.0F : 0.0F;
    }
}

} // namespace

SweepCost::SweepCost(const PosedPicture& photo, std::span<const PosedPicture> neighbours, double keptShare,
                     int width, int threads, std::span<const Gains> gains,
                     std::span<const Image<float, 1>* const> depths)
    : m_photo(photo.atLeast(2 * width), Eigen::Matrix3d::Identity(), width, threads),
      m_keptShare(keptShare),
      m_kept(keptOf(neighbours.size(), keptShare)),
      m_knowsDepth(!depths.empty()),
      m_angles(width) {
    const Eigen::Quaterniond photoFromRoom = photo.roomFromPhoto.rotation.conjugate();
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        const PosedPicture& other = neighbours[i];
        const Eigen::Quaterniond otherFromPhoto =
            other.roomFromPhoto.rotation.conjugate() * photo.roomFromPhoto.rotation;
        const Eigen::Vector3d offset =
            photoFromRoom * (other.roomFromPhoto.translation - photo.roomFromPhoto.translation);
        const Eigen::Vector3d front = photo.lenses.place(Eigen::Vector3d::UnitX());
        const Eigen::Matrix3d turn = otherFromPhoto.toRotationMatrix();
        const NeighbourLenses lenses{(offset - front).cast<float>(), (offset + front).cast<float>(),
                                     turn.row(0).transpose().cast<float>(),
                                     static_cast<float>(other.lenses.aheadM),
                                     static_cast<float>(offset.norm())};
        m_neighbours.push_back(
            {SweepPicture(other.atLeast(2 * width), turn, width, threads,
                          gains.empty() ? Gains{1, 1, 1} : gains[i]),
             lenses, m_knowsDepth ? turnedValues(*depths[i], turn, threads) : std::vector<float>()});
    }
}

SweepCost::Scratch::Scratch(const SweepCost& cost, int values)
    : m_u(static_cast<std::size_t>(values)),
      m_v(m_u.size()),
      m_first(m_u.size()),
      m_right(m_first.size()),
      m_down(m_first.size()),
      m_costs(cost.m_neighbours.size(), std::vector<float>(m_first.size())),
      m_hidden(m_first.size()),
      m_seen(m_first.size()),
      m_expected(m_first.size()) {
}

void SweepCost::locateLayers(const Neighbour& neighbour, const RowPart& part, int layers,
                             const float* inverseM, int exactEvery, Scratch& scratch) const {
    const auto row = static_cast<std::size_t>(part.y);
    const RowRays rays{m_angles.cosAzimuth.data() + part.begin, m_angles.sinAzimuth.data() + part.begin,
                       m_angles.cosElevation[row], m_angles.sinElevation[row]};
    const int count = part.count();
    float* u = scratch.m_u.data();
    float* v = scratch.m_v.data();
    const auto exactly = [&](int layer) {
        const int at = layer * count;
        locate(rays, inverseM + at, neighbour.lenses, count, width(), u + at, v + at);
    };
    exactly(0);
    for (int begin = 0, end = 0; begin + 1 < layers; begin = end) {
        end = std::min(begin + exactEvery, layers - 1);
        exactly(end);
        for (int layer = begin + 1; layer < end; ++layer) {
            const float share = static_cast<float>(layer - begin) / static_cast<float>(end - begin);
            const int at = layer * count;
            if (!locateBetween(u + begin * count, v + begin * count, u + end * count, v + end * count, share,
                               count, width(), u + at, v + at)) {
                exactly(layer);
            }
        }
    }
}

void SweepCost::neighbourCosts(const Neighbour& neighbour, const RowPart& part, int layer,
                               const float* inverseM, Scratch& scratch, float* hidden, float* costs) const {
    const auto row = static_cast<std::size_t>(part.y);
    const RowPlaces places{scratch.m_first.data(), scratch.m_right.data(), scratch.m_down.data()};
    const int stride = neighbour.picture.stride();
    const int first = layer * part.count();
    findPlaces(scratch.m_u.data() + first, scratch.m_v.data() + first, part.count(), width(), stride, places);
    costsAt(places, m_photo.at(part.begin, part.y), neighbour.picture.at(0, 0), stride, part.count(),
            costs + first);
    if (m_knowsDepth) {
        const RowRays rays{m_angles.cosAzimuth.data() + part.begin, m_angles.sinAzimuth.data() + part.begin,
                           m_angles.cosElevation[row], m_angles.sinElevation[row]};
        const float pixelRad = 2 * std::numbers::pi_v<float> / static_cast<float>(width());
        seenAt(places, neighbour.inverseM.data(), part.count(), width(), scratch.m_seen.data());
        expectedAt(rays, inverseM + first, neighbour.lenses, part.count(), scratch.m_expected.data());
        judge(scratch.m_seen.data(), scratch.m_expected.data(),
              pixelRad / std::max(1e-3F, neighbour.lenses.apartM), part.count(), hidden + first,
              costs + first);
    }
}

/// The mean over the better neighbours of those that see a place. Range: costs are sorted.
void SweepCost::meanOfSeen(const Scratch& scratch, std::size_t values, float* costs) const {
    const std::size_t count = m_neighbours.size();
    for (std::size_t i = 0; i < values; ++i) {
        const auto seen = count - static_cast<std::size_t>(scratch.m_hidden[i]);
        const std::size_t kept = keptOf(seen, m_keptShare);
        float sum = 0;
        for (std::size_t k = 0; k < kept; ++k) {
            sum += scratch.m_costs[k][i];
        }
        costs[i] = seen == 0 ? kUnseen
                             : sum / static_cast<float>(kept) +
                                   kHidden * scratch.m_hidden[i] / static_cast<float>(count);
    }
}

void SweepCost::meanOfKept(const Scratch& scratch, std::size_t values, float* costs) const {
    const float share = 1 / static_cast<float>(m_kept);
    std::fill_n(costs, values, 0.0F);
    for (std::size_t k = 0; k < m_kept; ++k) {
        for (std::size_t i = 0; i < values; ++i) {
            costs[i] += share * scratch.m_costs[k][i];
        }
    }
}

void SweepCost::at(const RowPart& part, int layers, const float* inverseM, Order order, Scratch& scratch,
                   float* costs) const {
    constexpr int kExactEvery = 2; ///< With 4, more edges of views are false.
    std::fill(scratch.m_hidden.begin(), scratch.m_hidden.end(), 0.0F);
    for (std::size_t k = 0; k < m_neighbours.size(); ++k) {
        locateLayers(m_neighbours[k], part, layers, inverseM, order == Order::BySteps ? kExactEvery : 1,
                     scratch);
        for (int layer = 0; layer < layers; ++layer) {
            neighbourCosts(m_neighbours[k], part, layer, inverseM, scratch, scratch.m_hidden.data(),
                           scratch.m_costs[k].data());
        }
    }
    const int values = layers * part.count();
    sortSmallest(scratch.m_costs, m_kept, values);
    if (m_knowsDepth) {
        meanOfSeen(scratch, static_cast<std::size_t>(values), costs);
    } else {
        meanOfKept(scratch, static_cast<std::size_t>(values), costs);
    }
}

void SweepCost::all(std::span<const Image<float, 1>> inverseM, int threads, const std::stop_token& stop,
                    std::span<Image<float, 1>> costs) const {
    parallelFor(height(), 16, threads, [&](int begin, int end) {
        throwIfStopped(stop);
        const int layers = static_cast<int>(inverseM.size());
        Scratch scratch(*this, layers * width());
        std::vector<float> tried(inverseM.size() * static_cast<std::size_t>(width()));
        std::vector<float> found(tried.size());
        const auto row = [&](std::vector<float>& values, std::size_t layer) {
            return values.begin() + static_cast<std::ptrdiff_t>(layer) * width();
        };
        for (int y = begin; y < end; ++y) {
            for (std::size_t k = 0; k < inverseM.size(); ++k) {
                std::copy_n(inverseM[k].at(0, y), width(), row(tried, k));
            }
            at({y, 0, width()}, layers, tried.data(), Order::Any, scratch, found.data());
            for (std::size_t k = 0; k < costs.size(); ++k) {
                std::copy_n(row(found, k), width(), costs[k].at(0, y));
            }
        }
    });
}

namespace {

/// What tells the filter where edges are.
Plane brightnessOf(const SweepPicture& photo) {
    Plane plane(photo.width(), photo.height());
    for (int y = 0; y < plane.height(); ++y) {
        for (int x = 0; x < plane.width(); ++x) {
            *plane.at(x, y) = photo.brightness(x, y) / 255;
        }
    }
    return plane;
}

constexpr int kFilterRadius = 1;
constexpr float kFilterSmoothness = 3e-4F;

} // namespace

SmoothCost::SmoothCost(SweepCost cost, int threads)
    : m_cost(std::move(cost)),
      m_filter(brightnessOf(m_cost.photo()), kFilterRadius, kFilterSmoothness, threads),
      m_threads(threads) {
}

std::vector<Plane> SmoothCost::all(std::span<const Plane> inverseM, const std::stop_token& stop) const {
    std::vector<Plane> costs(inverseM.size(), Plane(width(), height()));
    m_cost.all(inverseM, m_threads, stop, costs);
    for (Plane& plane : costs) {
        m_filter.apply(plane);
    }
    return costs;
}

} // namespace spherewalk::scene
