// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "fast_angle.h"
#include "vector_clones.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

namespace spherewalk::scene {

namespace {

/// Directions of a row's pixels.
struct RowRays {
    const float* cosAzimuth;
    const float* sinAzimuth;
    float cosElevation;
    float sinElevation;
};

/// Where a picture's values are from which a row's are interpolated.
struct RowPlaces {
    std::int32_t* first; ///< of the upper left pixel
    float* right;
    float* down;
};

/// Where a neighbour shows a row's pixels. Directions are never normalised.
SPHEREWALK_VECTOR_CLONES
void findPlaces(const RowRays& rays, const float* inverseM, const Eigen::Vector3f& offset, int width,
                int stride, const RowPlaces& places) {
    const float ox = offset.x();
    const float oy = offset.y();
    const float oz = offset.z();
    const RowRays r = rays; // which no store can change
    std::int32_t* __restrict first = places.first;
    float* __restrict right = places.right;
    float* __restrict down = places.down;
    for (int i = 0; i < width; ++i) {
        const FastPixel at = fastPixel(r.cosElevation * r.cosAzimuth[i] - inverseM[i] * ox,
                                       r.cosElevation * r.sinAzimuth[i] - inverseM[i] * oy,
                                       r.sinElevation - inverseM[i] * oz, static_cast<float>(width));
        const int column = std::min(static_cast<int>(at.u), width - 1);
        const int line = std::min(static_cast<int>(at.v), width / 2 - 1);
        first[i] = line * stride + 4 * column;
        right[i] = at.u - static_cast<float>(column);
        down[i] = at.v - static_cast<float>(line);
    }
}

using Four = float __attribute__((vector_size(16)));
using Eight = float __attribute__((vector_size(32)));

/// Weighted differences between a pixel's values and those interpolated. They count up to a limit, since
/// beyond it the neighbour shows something else.
inline Four differences(const float* here, const float* first, int stride, float right, float down) {
    constexpr Four kLimits = {20, 12, 12, 16};
    constexpr Four kWeights = {1, 1.5F, 1.5F, 0.8F};
    Eight upper;
    Eight lower;
    Four own;
    std::memcpy(&upper, first, sizeof upper);
    std::memcpy(&lower, first + stride, sizeof lower);
    std::memcpy(&own, here, sizeof own);
    const Eight values = upper + (lower - upper) * down;
    const Four left = __builtin_shufflevector(values, values, 0, 1, 2, 3);
    const Four beside = __builtin_shufflevector(values, values, 4, 5, 6, 7);
    const Four difference = own - (left + (beside - left) * right);
    const Four size = difference < 0 ? -difference : difference;
    return (size < kLimits ? size : kLimits) * kWeights;
}

/// The sums of four pixels' differences.
inline Four sums(const Four& a, const Four& b, const Four& c, const Four& d) {
    const Four ab = __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
    const Four cd = __builtin_shufflevector(c, d, 0, 1, 4, 5) + __builtin_shufflevector(c, d, 2, 3, 6, 7);
    return __builtin_shufflevector(ab, cd, 0, 2, 4, 6) + __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
}

/// Range: width a multiple of 4.
SPHEREWALK_VECTOR_CLONES
void costsAt(const RowPlaces& places, const float* here, const float* picture, int stride, int width,
             float* costs) {
    const RowPlaces p = places;
    for (int x = 0; x < width; x += 4) {
        const auto at = [&](int i) {
            return differences(here + 4 * i, picture + p.first[i], stride, p.right[i], p.down[i]);
        };
        const Four four = sums(at(x), at(x + 1), at(x + 2), at(x + 3));
        std::memcpy(costs + x, &four, sizeof four);
    }
}

/// The smallest `kept` values of each column come first.
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

} // namespace

SweepCost::SweepCost(const PosedPicture& photo, std::span<const PosedPicture> neighbours, double keptShare,
                     int width, int threads)
    : m_photo(*photo.picture, Eigen::Matrix3d::Identity(), width, threads),
      m_kept(std::max<std::size_t>(
          1, static_cast<std::size_t>(std::lround(static_cast<double>(neighbours.size()) * keptShare)))) {
    const Eigen::Quaterniond photoFromRoom = photo.roomFromPhoto.rotation.conjugate();
    for (const PosedPicture& other : neighbours) {
        const Eigen::Quaterniond otherFromPhoto =
            other.roomFromPhoto.rotation.conjugate() * photo.roomFromPhoto.rotation;
        const Eigen::Vector3d offset =
            photoFromRoom * (other.roomFromPhoto.translation - photo.roomFromPhoto.translation);
        m_neighbours.push_back(
            {SweepPicture(*other.picture, otherFromPhoto.toRotationMatrix(), width, threads),
             offset.cast<float>()});
    }
    const double step = 2 * std::numbers::pi / width;
    for (int x = 0; x < width; ++x) {
        m_cosAzimuth.push_back(static_cast<float>(std::cos(std::numbers::pi - step * (x + 0.5))));
        m_sinAzimuth.push_back(static_cast<float>(std::sin(std::numbers::pi - step * (x + 0.5))));
    }
    for (int y = 0; y < height(); ++y) {
        m_cosElevation.push_back(static_cast<float>(std::cos(std::numbers::pi / 2 - step * (y + 0.5))));
        m_sinElevation.push_back(static_cast<float>(std::sin(std::numbers::pi / 2 - step * (y + 0.5))));
    }
}

SweepCost::Scratch::Scratch(const SweepCost& cost)
    : m_first(static_cast<std::size_t>(cost.width())),
      m_right(m_first.size()),
      m_down(m_first.size()),
      m_costs(cost.m_neighbours.size(), std::vector<float>(m_first.size())) {
}

void SweepCost::neighbourRow(const Neighbour& neighbour, int y, const float* inverseM, Scratch& scratch,
                             float* costs) const {
    const auto row = static_cast<std::size_t>(y);
    const int stride = neighbour.picture.stride();
    const RowPlaces places{scratch.m_first.data(), scratch.m_right.data(), scratch.m_down.data()};
    findPlaces({m_cosAzimuth.data(), m_sinAzimuth.data(), m_cosElevation[row], m_sinElevation[row]}, inverseM,
               neighbour.fromPhotoM, width(), stride, places);
    costsAt(places, m_photo.at(0, y), neighbour.picture.at(0, 0), stride, width(), costs);
}

void SweepCost::row(int y, const float* inverseM, Scratch& scratch, float* costs) const {
    for (std::size_t i = 0; i < m_neighbours.size(); ++i) {
        neighbourRow(m_neighbours[i], y, inverseM, scratch, scratch.m_costs[i].data());
    }
    sortSmallest(scratch.m_costs, m_kept, width());
    const float share = 1 / static_cast<float>(m_kept);
    std::fill_n(costs, width(), 0.0F);
    for (std::size_t i = 0; i < m_kept; ++i) {
        for (int x = 0; x < width(); ++x) {
            costs[x] += share * scratch.m_costs[i][static_cast<std::size_t>(x)];
        }
    }
}

void SweepCost::all(const Image<float, 1>& inverseM, int threads, const std::stop_token& stop,
                    Image<float, 1>& costs) const {
    parallelFor(height(), 16, threads, [&](int begin, int end) {
        throwIfStopped(stop);
        Scratch scratch(*this);
        for (int y = begin; y < end; ++y) {
            row(y, inverseM.at(0, y), scratch, costs.at(0, y));
        }
    });
}

} // namespace spherewalk::scene
