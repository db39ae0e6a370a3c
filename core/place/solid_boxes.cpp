// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/solid_boxes.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spherewalk::place {

namespace {

constexpr double kMostSolidCells = 1 << 28;
constexpr float kLeastSurface = 0.25F; ///< of a cell's face; less surface in a cell is its neighbour's

// What a cell is.
constexpr std::uint8_t kFree = 0;
constexpr std::uint8_t kSolid = 1;
constexpr std::uint8_t kMirror = 2; ///< It is solid, and photos show something else in it.

class Solids {
  public:
    Solids(const Surface& things, std::span<const SeenDepth> photos, const BoxOptions& options,
           const std::stop_token& stop)
        : m_things(things), m_photos(photos), m_options(options), m_stop(stop) {
        layOut();
    }

    std::vector<Eigen::AlignedBox3d> whole() {
        spreadSurface();
        fillBelow();
        return boxes();
    }

    std::vector<Eigen::AlignedBox3d> inset() {
        spreadSurface();
        fillBelow();
        dropSeenThrough();
        const std::vector<std::uint8_t> whole = m_cells;
        shrink();
        const std::vector<std::uint8_t> inner = m_cells;
        std::vector<Eigen::AlignedBox3d> found =
            boxes(Eigen::Vector3d(m_options.cellM / 2, m_options.cellM / 2, 0));
        m_cells = whole;
        keepThin(inner);
        const std::vector<Eigen::AlignedBox3d> thin = boxes();
        found.insert(found.end(), thin.begin(), thin.end());
        return found;
    }

  private:
    void layOut() {
        Eigen::AlignedBox3d around;
        for (const SurfaceVertex& vertex : m_things.vertices) {
            around.extend(vertex.pInRoom);
        }
        // Whole cells from the floor on, and one more on each side.
        const double cellM = m_options.cellM;
        m_origin = (around.min() / cellM).array().floor() * cellM - cellM;
        m_origin.z() = m_options.floorM;
        const Eigen::Vector3d count = ((around.max() - m_origin) / cellM).array().floor() + 2;
        if (count.prod() > kMostSolidCells) {
            throw Error(ErrorKind::InvalidInput, text("Could not make boxes of furniture: there would be ",
                                                      count.prod(), " cells. Take larger ones."));
        }
        m_count = count.cwiseMax(1).cast<int>();
        m_cells.assign(static_cast<std::size_t>(m_count.x()) * static_cast<std::size_t>(m_count.y()) *
                           static_cast<std::size_t>(m_count.z()),
                       kFree);
    }

    std::size_t indexOf(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_count.y()) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(m_count.x()) +
               static_cast<std::size_t>(x);
    }

    Eigen::Vector3d middle(const Eigen::Vector3i& cell) const {
        return m_origin + m_options.cellM * (cell.cast<double>().array() + 0.5).matrix();
    }

    /// A cell is solid that lies behind the surface by half its length, so that its face is near the surface.
    void spreadSurface() {
        std::vector<float> areaM2(m_cells.size(), 0.0F);
        for (const auto& triangle : m_things.triangles) {
            const Eigen::Vector3d area = m_things.areaVector(triangle);
            const Eigen::Vector3d behind =
                m_things.middle(triangle) - m_options.cellM / 2 * area.stableNormalized();
            const Eigen::Vector3i cell = ((behind - m_origin) / m_options.cellM).array().floor().cast<int>();
            if ((cell.array() >= 0).all() && (cell.array() < m_count.array()).all()) {
                areaM2[indexOf(cell.x(), cell.y(), cell.z())] += static_cast<float>(area.norm());
            }
        }
        const auto leastM2 = kLeastSurface * static_cast<float>(m_options.cellM * m_options.cellM);
        std::transform(areaM2.begin(), areaM2.end(), m_cells.begin(),
                       [&](float area) { return area >= leastM2 ? kSolid : kFree; });
    }

    /// Things stand on something: below a solid cell, down to the first cell that is free, all is solid. What
    /// mirrors does so down to the floor that it mirrors.
    void fillBelow() {
        const auto marginM = static_cast<float>(m_options.cellM);
        parallelFor(m_count.y(), 1, m_options.threads, [&](int y, int) {
            throwIfStopped(m_stop);
            for (int x = 0; x < m_count.x(); ++x) {
                bool isCovered = false;
                std::optional<double> mirroredFloorM;
                for (int z = m_count.z() - 1; z >= 0; --z) {
                    std::uint8_t& cell = m_cells[indexOf(x, y, z)];
                    if (cell != kFree) {
                        isCovered = true;
                    } else if (isCovered) {
                        const Space space = spaceAt(m_photos, middle({x, y, z}), marginM, mirroredFloorM);
                        isCovered = space != Space::Free;
                        if (space == Space::Mirror) {
                            mirroredFloorM = m_options.floorM;
                        } else if (!isCovered) {
                            mirroredFloorM.reset(); // what stands farther below is another thing
                        }
                        cell = !isCovered ? kFree : mirroredFloorM.has_value() ? kMirror : kSolid;
                    }
                }
            }
        });
    }

    /// Photos look through no cell, neither at its middle nor beside it.
    void dropSeenThrough() {
        constexpr double kAside = 0.3; // of a cell's edge, from the middle
        parallelFor(m_count.z(), 1, m_options.threads, [&](int z, int) {
            throwIfStopped(m_stop);
            for (int y = 0; y < m_count.y(); ++y) {
                for (int x = 0; x < m_count.x(); ++x) {
                    std::uint8_t& cell = m_cells[indexOf(x, y, z)];
                    for (int i = 0; i < 4 && cell == kSolid; ++i) {
                        const Eigen::Vector3d aside(i % 2 == 0 ? -kAside : kAside, i < 2 ? -kAside : kAside,
                                                    0);
                        cell = isSeenThrough(m_photos, middle({x, y, z}) + m_options.cellM * aside) ? kFree
                                                                                                    : kSolid;
                    }
                }
            }
        });
    }

    /// Along x and y, cells from middle to middle take the place of cells. They are solid where all four
    /// about them are.
    void shrink() {
        for (int z = 0; z < m_count.z(); ++z) {
            for (int y = 0; y < m_count.y(); ++y) {
                for (int x = 0; x < m_count.x(); ++x) {
                    // Cells that come later are as they were.
                    m_cells[indexOf(x, y, z)] = x + 1 < m_count.x() && y + 1 < m_count.y() &&
                                                        m_cells[indexOf(x, y, z)] != kFree &&
                                                        m_cells[indexOf(x + 1, y, z)] != kFree &&
                                                        m_cells[indexOf(x, y + 1, z)] != kFree &&
                                                        m_cells[indexOf(x + 1, y + 1, z)] != kFree
                                                    ? kSolid
                                                    : kFree;
                }
            }
        }
    }

    /// Cells that lie in the shrunk ones, by a quarter or more, are taken away.
    void keepThin(const std::vector<std::uint8_t>& shrunk) {
        for (int z = 0; z < m_count.z(); ++z) {
            for (int y = 0; y < m_count.y(); ++y) {
                for (int x = 0; x < m_count.x(); ++x) {
                    const int left = std::max(x - 1, 0);
                    const int front = std::max(y - 1, 0);
                    if (shrunk[indexOf(x, y, z)] != kFree || shrunk[indexOf(left, y, z)] != kFree ||
                        shrunk[indexOf(x, front, z)] != kFree || shrunk[indexOf(left, front, z)] != kFree) {
                        m_cells[indexOf(x, y, z)] = kFree;
                    }
                }
            }
        }
    }

    /// Each box grows along x, then y, then z, as long as all its cells are solid, and takes them away.
    /// asideM: of the cells from where they are.
    std::vector<Eigen::AlignedBox3d> boxes(const Eigen::Vector3d& asideM = Eigen::Vector3d::Zero()) {
        const Eigen::Vector3d origin = m_origin + asideM;
        std::vector<Eigen::AlignedBox3d> found;
        for (int z = 0; z < m_count.z(); ++z) {
            throwIfStopped(m_stop);
            for (int y = 0; y < m_count.y(); ++y) {
                for (int x = 0; x < m_count.x(); ++x) {
                    if (m_cells[indexOf(x, y, z)] != kFree) {
                        const Eigen::Vector3i first(x, y, z);
                        const Eigen::Vector3i end = endOf(first);
                        found.emplace_back(origin + m_options.cellM * first.cast<double>(),
                                           origin + m_options.cellM * end.cast<double>());
                    }
                }
            }
        }
        return found;
    }

    Eigen::Vector3i endOf(const Eigen::Vector3i& first) {
        Eigen::Vector3i end = first.array() + 1;
        for (int axis = 0; axis < 3; ++axis) {
            while (end[axis] < m_count[axis] && isSolidNext(first, end, axis)) {
                ++end[axis];
            }
        }
        for (int z = first.z(); z < end.z(); ++z) {
            for (int y = first.y(); y < end.y(); ++y) {
                const auto begin = m_cells.begin() + static_cast<std::ptrdiff_t>(indexOf(first.x(), y, z));
                std::fill(begin, begin + (end.x() - first.x()), kFree);
            }
        }
        return end;
    }

    /// Whether all cells beside a box are solid, in the direction of an axis.
    bool isSolidNext(Eigen::Vector3i first, Eigen::Vector3i end, int axis) const {
        first[axis] = end[axis];
        ++end[axis];
        for (int z = first.z(); z < end.z(); ++z) {
            for (int y = first.y(); y < end.y(); ++y) {
                for (int x = first.x(); x < end.x(); ++x) {
                    if (m_cells[indexOf(x, y, z)] == kFree) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    const Surface& m_things;
    std::span<const SeenDepth> m_photos;
    const BoxOptions& m_options;
    std::stop_token m_stop;
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero(); ///< Of the first cell, its least corner.
    Eigen::Vector3i m_count = Eigen::Vector3i::Zero();
    std::vector<std::uint8_t> m_cells;
};

} // namespace

void BoxOptions::validate() const {
    if (!(cellM >= 0.005 && cellM <= 1)) {
        throw Error(ErrorKind::InvalidInput, text("Could not make boxes of furniture: a cell must be 5 mm to "
                                                  "1 m large, not ",
                                                  cellM, " m."));
    }
}

std::vector<Eigen::AlignedBox3d> solidBoxes(const Surface& things, std::span<const SeenDepth> photos,
                                            const BoxOptions& options, const std::stop_token& stop) {
    options.validate();
    return things.triangles.empty() ? std::vector<Eigen::AlignedBox3d>()
                                    : Solids(things, photos, options, stop).whole();
}

std::vector<Eigen::AlignedBox3d> closingBoxes(const Surface& things, std::span<const SeenDepth> photos,
                                              const BoxOptions& options, const std::stop_token& stop) {
    options.validate();
    return things.triangles.empty() ? std::vector<Eigen::AlignedBox3d>()
                                    : Solids(things, photos, options, stop).inset();
}

void addBoxes(Surface& surface, std::span<const Eigen::AlignedBox3d> boxes) {
    constexpr std::uint8_t kGrey = 128;
    // The corners of each side, as one goes about it seen from outside: -x, +x, -y, +y, -z, +z.
    constexpr std::array<std::array<int, 4>, 6> kSides = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const Eigen::AlignedBox3d& box : boxes) {
        for (std::size_t side = 0; side < kSides.size(); ++side) {
            const auto first = static_cast<std::uint32_t>(surface.vertices.size());
            SurfaceVertex vertex;
            vertex.colour = {kGrey, kGrey, kGrey};
            vertex.normal[static_cast<Eigen::Index>(side / 2)] = side % 2 == 0 ? -1.0F : 1.0F;
            for (const int corner : kSides[side]) {
                vertex.pInRoom = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
                surface.vertices.push_back(vertex);
            }
            surface.triangles.push_back({first, first + 1, first + 2});
            surface.triangles.push_back({first, first + 2, first + 3});
        }
    }
}

} // namespace spherewalk::place
