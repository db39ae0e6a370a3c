// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// Photos as the points of a square grid. Some points may lack theirs; photos that stand beside all points
/// are left out.
class GridLattice {
  public:
    /// Column, row, and height in steps of 10 cm.
    using Point = std::array<int, 3>;

    /// The step is that between most neighbours, the axes are as most neighbours lie. Range: finite.
    explicit GridLattice(std::span<const Eigen::Vector3d> photosInRoom);

    double stepM() const { return m_stepM; } ///< 0 if no two photos stand apart

    const std::map<Point, std::size_t>& photos() const { return m_photos; }

  private:
    double m_stepM = 0;
    std::map<Point, std::size_t> m_photos;
};

/// Which points of a grid are kept: every n-th of every n-th row, or, as on a chess board, every other one.
struct KeptGrid {
    int every = 2;  ///< 1: as on a chess board
    int column = 0; ///< of a point that is kept
    int row = 0;

    double stepM(double gridStepM) const;
    bool isKept(const GridLattice::Point& point) const;
    /// The kept points around one that is not: a robot there has the kept photos as far about it as anywhere
    /// near.
    std::vector<GridLattice::Point> corners(const GridLattice::Point& point) const;
};

/// Photos that are kept, and those that can be compared with what is rendered from them: all their corners
/// are kept.
struct GridSplit {
    KeptGrid grid;
    std::vector<std::size_t> kept;
    std::vector<std::size_t> heldOut;
};

/// The ways to keep every n-th point that leave most photos to compare with, at most so many; fewer where
/// there is nothing to compare with.
std::vector<GridSplit> bestSplits(const GridLattice& lattice, int every, int most);

} // namespace spherewalk::jobs
