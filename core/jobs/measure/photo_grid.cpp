// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/photo_grid.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <set>

namespace spherewalk::jobs {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kLevelM = 0.1;      ///< photos that differ in height by less belong together
constexpr double kApartM = 0.02;     ///< photos nearer to each other stand at one place
constexpr double kBesideShare = 0.3; ///< of the step; a photo farther from its point belongs to none
constexpr double kLongerShare = 1.5; ///< of the step; neighbours farther apart do not say how the grid lies

int modulo(int value, int divisor) {
    return ((value % divisor) + divisor) % divisor;
}

/// From each photo to its nearest neighbour on its level.
std::vector<Vector2d> toNeighbours(std::span<const Vector3d> photos) {
    std::vector<Vector2d> result;
    for (const Vector3d& photo : photos) {
        Vector2d nearest(std::numeric_limits<double>::infinity(), 0);
        for (const Vector3d& other : photos) {
            const Vector2d way = (other - photo).head<2>();
            if (std::abs(other.z() - photo.z()) < kLevelM && way.norm() > kApartM &&
                way.norm() < nearest.norm()) {
                nearest = way;
            }
        }
        if (nearest.allFinite()) {
            result.push_back(nearest);
        }
    }
    return result;
}

GridSplit split(const PhotoGrid& photos, const KeptGrid& grid) {
    GridSplit result{grid, {}, {}};
    for (const auto& [point, photo] : photos.photos()) {
        if (grid.isKept(point)) {
            result.kept.push_back(photo);
            continue;
        }
        const std::vector<PhotoGrid::Point> corners = grid.corners(point);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const auto& corner) { return photos.photos().contains(corner); })) {
            result.heldOut.push_back(photo);
        }
    }
    return result;
}

} // namespace

PhotoGrid::PhotoGrid(std::span<const Vector3d> photosInRoom) {
    const std::vector<Vector2d> ways = toNeighbours(photosInRoom);
    if (ways.empty()) {
        return;
    }
    std::vector<double> lengths;
    for (const Vector2d& way : ways) {
        lengths.push_back(way.norm());
    }
    m_stepM = median(lengths);
    std::complex<double> turns = 0; // four times the angle: all four ways along the axes are the same
    for (const Vector2d& way : ways) {
        if (way.norm() < kLongerShare * m_stepM) {
            turns += std::polar(1.0, 4 * std::atan2(way.y(), way.x()));
        }
    }
    const double turn = std::arg(turns) / 4;
    const Vector2d along(std::cos(turn), std::sin(turn));
    const Vector2d across(-along.y(), along.x());
    const Vector3d& origin = photosInRoom.front();
    for (std::size_t i = 0; i < photosInRoom.size(); ++i) {
        const Vector3d way = photosInRoom[i] - origin;
        const Vector2d place = Vector2d(along.dot(way.head<2>()), across.dot(way.head<2>())) / m_stepM;
        const Vector2d point(std::round(place.x()), std::round(place.y()));
        if ((place - point).norm() < kBesideShare) {
            m_photos.try_emplace({static_cast<int>(point.x()), static_cast<int>(point.y()),
                                  static_cast<int>(std::lround(way.z() / kLevelM))},
                                 i);
        }
    }
}

double KeptGrid::stepM(double gridStepM) const {
    return gridStepM * (every == 1 ? std::sqrt(2.0) : every);
}

bool KeptGrid::isKept(const PhotoGrid::Point& point) const {
    return every == 1 ? modulo(point[0] - column + point[1] - row, 2) == 0
                      : modulo(point[0] - column, every) == 0 && modulo(point[1] - row, every) == 0;
}

std::vector<PhotoGrid::Point> KeptGrid::corners(const PhotoGrid::Point& point) const {
    const auto [x, y, z] = point;
    if (every == 1) {
        return {{x - 1, y, z}, {x + 1, y, z}, {x, y - 1, z}, {x, y + 1, z}};
    }
    const int left = x - modulo(x - column, every);
    const int below = y - modulo(y - row, every);
    std::set<PhotoGrid::Point> result;
    for (const int cornerX : {left, left == x ? x : left + every}) {
        for (const int cornerY : {below, below == y ? y : below + every}) {
            result.insert({cornerX, cornerY, z});
        }
    }
    return {result.begin(), result.end()};
}

std::vector<GridSplit> bestSplits(const PhotoGrid& photos, int every, int most) {
    std::vector<GridSplit> splits;
    const int rows = every == 1 ? 1 : every;
    const int columns = every == 1 ? 2 : every;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            GridSplit one = split(photos, {every, column, row});
            if (!one.heldOut.empty() && one.kept.size() > 1) {
                splits.push_back(std::move(one));
            }
        }
    }
    std::stable_sort(splits.begin(), splits.end(), [](const GridSplit& a, const GridSplit& b) {
        return a.heldOut.size() > b.heldOut.size();
    });
    splits.resize(std::min(splits.size(), static_cast<std::size_t>(most)));
    return splits;
}

} // namespace spherewalk::jobs
