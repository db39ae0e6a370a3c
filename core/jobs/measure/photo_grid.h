// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// Photos as the points of a square grid. Some points may have no photo. Photos that stand beside all points
/// are left out.
class PhotoGrid {
  public:
    /// Column, row, and height in steps of 10 cm.
    using Point = std::array<int, 3>;

    /// The median distance between neighbours is the step; the axes lie as most neighbours do. Range: finite.
    explicit PhotoGrid(std::span<const Eigen::Vector3d> photosInRoom);

    double stepM() const { return m_stepM; } ///< 0 if all photos stand at one place.

    const std::map<Point, std::size_t>& photos() const { return m_photos; }

  private:
    double m_stepM = 0;
    std::map<Point, std::size_t> m_photos;
};

/// Which points of a grid are kept: every n-th point of every n-th row, or every other one as on a chess
/// board.
struct KeptGrid {
    int every = 2;  ///< The n above; 1 means as on a chess board.
    int column = 0; ///< Column and row of a point that is kept.
    int row = 0;

    double stepM(double gridStepM) const;
    bool isKept(const PhotoGrid::Point& point) const;
    /// The kept points around a point that is not kept. A robot there is as far from kept photos as anywhere
    /// near.
    std::vector<PhotoGrid::Point> corners(const PhotoGrid::Point& point) const;
};

/// Photos that are kept, and photos that views from the kept ones are compared with: all their corners are
/// kept.
struct GridSplit {
    KeptGrid grid;
    std::vector<std::size_t> kept;
    std::vector<std::size_t> heldOut;
};

/// The ways to keep every n-th point that leave most photos to compare with, at most `most` of them. Ways
/// that leave no photo to compare with are left out.
std::vector<GridSplit> bestSplits(const PhotoGrid& photos, int every, int most);

} // namespace spherewalk::jobs
