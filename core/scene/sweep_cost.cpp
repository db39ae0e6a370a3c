// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "fast_angle.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::scene {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Where the neighbour shows a row's pixels. Directions are never normalised.
struct RowRays {
    const float* cosAzimuth;
    const float* sinAzimuth;
    float cosElevation;
    float sinElevation;
};

void places(const RowRays& rays, const float* inverseM, const Eigen::Vector3f& offset, int width,
            float* __restrict u, float* __restrict v) {
    const float perTurn = static_cast<float>(width) / (2 * kPi);
    const auto turn = static_cast<float>(width);
    const float ox = offset.x();
    const float oy = offset.y();
    const float oz = offset.z();
    for (int i = 0; i < width; ++i) {
        const float x = rays.cosElevation * rays.cosAzimuth[i] - inverseM[i] * ox;
        const float y = rays.cosElevation * rays.sinAzimuth[i] - inverseM[i] * oy;
        const float z = rays.sinElevation - inverseM[i] * oz;
        const float column = (kPi - fastAngle(y, x)) * perTurn - 0.5F;
        u[i] = column < 0 ? column + turn : column;
        const float line = (0.5F * kPi - fastAngle(z, std::sqrt(x * x + y * y))) * perTurn - 0.5F;
        v[i] = line < 0 ? 0 : line;
    }
}

/// Differences count up to a limit, since beyond it the neighbour shows something else.
inline float difference(const Eigen::Array4f& a, const Eigen::Array4f& b) {
    const Eigen::Array4f limits(20, 12, 12, 16);
    const Eigen::Array4f weights(1, 1.5F, 1.5F, 0.8F);
    return ((a - b).abs().min(limits) * weights).sum();
}

/// The smallest `kept` values of each column come first.
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
    : m_u(static_cast<std::size_t>(cost.width())),
      m_v(static_cast<std::size_t>(cost.width())),
      m_costs(cost.m_neighbours.size(), std::vector<float>(static_cast<std::size_t>(cost.width()))) {
}

void SweepCost::neighbourRow(const Neighbour& neighbour, int y, const float* inverseM, Scratch& scratch,
                             float* costs) const {
    const auto row = static_cast<std::size_t>(y);
    places({m_cosAzimuth.data(), m_sinAzimuth.data(), m_cosElevation[row], m_sinElevation[row]}, inverseM,
           neighbour.fromPhotoM, width(), scratch.m_u.data(), scratch.m_v.data());
    using Values = Eigen::Map<const Eigen::Array4f>;
    const int below = neighbour.picture.stride();
    const float* here = m_photo.at(0, y);
    for (int x = 0; x < width(); ++x, here += 4) {
        const float u = scratch.m_u[static_cast<std::size_t>(x)];
        const float v = scratch.m_v[static_cast<std::size_t>(x)];
        const int column = std::min(static_cast<int>(u), width() - 1);
        const int line = std::min(static_cast<int>(v), height() - 1);
        const float* p = neighbour.picture.at(column, line);
        const float right = u - static_cast<float>(column);
        const Eigen::Array4f upper = Values(p) + (Values(p + 4) - Values(p)) * right;
        const Eigen::Array4f lower = Values(p + below) + (Values(p + below + 4) - Values(p + below)) * right;
        costs[x] = difference(Values(here), upper + (lower - upper) * (v - static_cast<float>(line)));
    }
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
