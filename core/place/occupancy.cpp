// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/occupancy.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace spherewalk::place {

namespace {

constexpr double kMostCells = 1 << 28;
constexpr double kOccupiedM2 = 0.001; ///< less surface is a mistake of a few voxels
constexpr double kFloorShare = 0.25;  ///< of a cell's floor that makes it seen
constexpr double kThroughShare = 0.9; ///< of a column's lower half; else something low may be hidden there
constexpr double kSampleM = 0.05;     ///< along a cell's column
constexpr double kWallM = 0.15;       ///< how far beyond the outline something may be seen of a wall
constexpr int kRowsAGrain = 4;

class Mapping {
  public:
    Mapping(const Surface& surface, std::span<const SeenDepth> photos, const OccupancyOptions& options,
            const std::stop_token& stop)
        : m_surface(surface), m_photos(photos), m_options(options), m_stop(stop) {}

    OccupancyGrid run() {
        layOut();
        spreadSurface();
        parallelFor(m_grid.cells.height(), kRowsAGrain, m_options.threads, [&](int begin, int end) {
            throwIfStopped(m_stop);
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < m_grid.cells.width(); ++x) {
                    *m_grid.cells.at(x, y) = valueOf(x, y);
                }
            }
        });
        return std::move(m_grid);
    }

  private:
    bool isInBand(double z) const {
        const double heightM = z - m_options.floorM;
        return heightM >= m_options.leastHeightM && heightM <= m_options.mostHeightM;
    }

    void layOut() {
        Eigen::Vector2d least = Eigen::Vector2d::Constant(HUGE_VAL);
        Eigen::Vector2d greatest = -least;
        for (const auto& triangle : m_surface.triangles) {
            const Eigen::Vector3d middle = m_surface.middle(triangle);
            if (middle.z() - m_options.floorM <= m_options.mostHeightM) {
                least = least.cwiseMin(middle.head<2>());
                greatest = greatest.cwiseMax(middle.head<2>());
            }
        }
        if (!least.allFinite()) {
            throw Error(ErrorKind::InvalidInput, text("Could not make a map: no surface was seen below ",
                                                      m_options.mostHeightM, " m above the floor."));
        }
        const Eigen::Vector2d first = (least / m_options.cellM).array().floor() - 1;
        const Eigen::Vector2d count = (greatest / m_options.cellM).array().floor() + 2 - first.array();
        if (count.x() * count.y() > kMostCells) {
            throw Error(ErrorKind::InvalidInput, text("Could not make a map: it would have ", count.x(),
                                                      " x ", count.y(), " cells. Take larger cells."));
        }
        m_grid.originM = first * m_options.cellM;
        m_grid.cellM = m_options.cellM;
        m_grid.cells = MaskImage(static_cast<int>(count.x()), static_cast<int>(count.y()));
        m_obstacleM2 = Image<float, 1>(m_grid.cells.width(), m_grid.cells.height());
        m_floorM2 = m_obstacleM2;
    }

    /// The columns and rows of a cell are counted as in the picture.
    Eigen::Vector2i cellOf(const Eigen::Vector3d& pInRoom) const {
        const Eigen::Vector2d cell = (pInRoom.head<2>() - m_grid.originM) / m_grid.cellM;
        return {static_cast<int>(cell.x()), m_grid.cells.height() - 1 - static_cast<int>(cell.y())};
    }

    /// Adds the triangles' areas to the cells of their middles, since they are smaller than cells.
    void spreadSurface() {
        for (const auto& triangle : m_surface.triangles) {
            const Eigen::Vector3d middle = m_surface.middle(triangle);
            if (middle.z() - m_options.floorM <= m_options.mostHeightM) {
                const Eigen::Vector2i cell = cellOf(middle);
                *(isInBand(middle.z()) ? m_obstacleM2 : m_floorM2).at(cell.x(), cell.y()) +=
                    static_cast<float>(m_surface.areaVector(triangle).norm());
            }
        }
    }

    std::uint8_t valueOf(int x, int y) const {
        const Eigen::Vector2d middle =
            m_grid.originM + m_grid.cellM * Eigen::Vector2d(x + 0.5, m_grid.cells.height() - y - 0.5);
        if (!m_options.outline.empty() && !contains(m_options.outline, middle) &&
            distanceToEdge(m_options.outline, middle) > kWallM) {
            return kUnknown;
        }
        if (*m_obstacleM2.at(x, y) >= kOccupiedM2) {
            return kOccupied;
        }
        return columnAt(middle, *m_floorM2.at(x, y) >= kFloorShare * m_grid.cellM * m_grid.cellM);
    }

    /// Of a column without a sure surface.
    std::uint8_t columnAt(const Eigen::Vector2d& middle, bool isFloorSeen) const {
        const double bandM = m_options.mostHeightM - m_options.leastHeightM;
        const int samples = std::max(1, static_cast<int>(std::lround(bandM / kSampleM)));
        const int lower = (samples + 1) / 2;
        int free = 0;
        for (int i = 0; i < samples; ++i) {
            const double heightM = m_options.leastHeightM + (i + 0.5) / samples * bandM;
            const Space space = spaceAt(m_photos, {middle.x(), middle.y(), m_options.floorM + heightM});
            if (space == Space::Occupied) {
                return kOccupied;
            }
            free += space == Space::Free && i < lower ? 1 : 0;
        }
        return isFloorSeen || free >= kThroughShare * lower ? kFree : kUnknown;
    }

    const Surface& m_surface;
    std::span<const SeenDepth> m_photos;
    const OccupancyOptions& m_options;
    std::stop_token m_stop;
    OccupancyGrid m_grid;
    Image<float, 1> m_obstacleM2; ///< Of each cell, surface between the two heights.
    Image<float, 1> m_floorM2;    ///< The same below.
};

} // namespace

void OccupancyOptions::validate() const {
    if (!(cellM >= 0.01 && cellM <= 1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not make a map: a cell must be 0.01 to 1 m large, not ", cellM, " m."));
    }
    if (!std::isfinite(floorM) || !std::isfinite(leastHeightM) || !(mostHeightM > leastHeightM) ||
        !std::isfinite(mostHeightM)) {
        throw Error(ErrorKind::InvalidInput, text("Could not make a map of heights from ", leastHeightM,
                                                  " to ", mostHeightM, " m; the second must be greater."));
    }
}

OccupancyGrid occupancyOf(const Surface& surface, std::span<const SeenDepth> photos,
                          const OccupancyOptions& options, const std::stop_token& stop) {
    options.validate();
    return Mapping(surface, photos, options, stop).run();
}

Bytes pgmFile(const OccupancyGrid& grid) {
    const std::string header = text("P5\n", grid.cells.width(), " ", grid.cells.height(), "\n255\n");
    Bytes file(header.begin(), header.end());
    file.insert(file.end(), grid.cells.values().begin(), grid.cells.values().end());
    return file;
}

std::string mapYaml(const OccupancyGrid& grid, const std::string& image) {
    // 205 is (255 - 205) / 255 = 0.19608 occupied: more than free_thresh, so unknown for all readers.
    return text("image: ", image, "\nmode: trinary\nresolution: ", grid.cellM, "\norigin: [",
                grid.originM.x(), ", ", grid.originM.y(), ", 0]\nnegate: 0\noccupied_thresh: 0.65\n",
                "free_thresh: 0.196\n");
}

} // namespace spherewalk::place
