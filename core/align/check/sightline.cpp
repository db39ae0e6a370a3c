// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/sight.h"

#include <algorithm>

namespace spherewalk::align {

namespace {

constexpr double kSlackShare = 0.15;   ///< Of 1 / distance.
constexpr double kSlackInverse = 0.06; ///< Per metre.
constexpr int kSeveral = 4;
constexpr int kLeastLooking = 2;   ///< Photos that look through where something foreign may stand.
constexpr int kMostDissenters = 4; ///< Photos that see a surface where a single neighbour shows the same.
constexpr double kFarthestInverse = 0.02; ///< Per metre: for what is endlessly far.
constexpr double kBesideLensM = 0.1;      ///< Nearer things are not looked for.
constexpr int kLeastShowing = 2;          ///< Photos that show the surface of what is beside the lens.
/// The row of 30 degrees above the horizon. Higher up are ceilings and lamps, which glare, and no persons.
constexpr int kFirstSearchedRow = kSightRowsOfSphere / 3 - kSightTop;

/// How a photo stands to a place of the room.
enum class Standing {
    Through,
    Surface,
    PerhapsSurface, ///< It lies between two distances, and one is more than twice the other.
    Hidden,
    Unknown
};

Standing standingOf(const Observer& observer, const Eigen::Vector3f& pInRoom) {
    const Eigen::Vector3f pInPhoto = observer.photoFromRoom * (pInRoom - observer.positionM);
    const int cell = sightCell(pInPhoto);
    if (cell < 0 || observer.nearest[static_cast<std::size_t>(cell)] < 0) {
        return Standing::Unknown;
    }
    const double inverse = 1 / std::max(1e-3F, pInPhoto.norm());
    const auto at = static_cast<std::size_t>(cell);
    if (inverse > observer.nearest[at] * (1 + kSlackShare) + kSlackInverse) {
        return Standing::Through;
    }
    if (inverse < observer.farthest[at] * (1 - kSlackShare) - kSlackInverse) {
        return Standing::Hidden;
    }
    return 2 * observer.farthest[at] < observer.nearest[at] ? Standing::PerhapsSurface : Standing::Surface;
}

} // namespace

Observer observer(const SightPhoto& photo, const PhotoSight& sight) {
    Observer result;
    result.photoFromRoom = photo.roomFromPhoto->rotation.conjugate().matrix().cast<float>();
    result.positionM = photo.roomFromPhoto->translation.cast<float>();
    result.nearest.assign(kSightCells, -1);
    result.farthest.assign(kSightCells, -1);
    for (int row = 0; row < kSightRows; ++row) {
        for (int column = 0; column < kSightColumns; ++column) {
            const auto at = static_cast<std::size_t>(row * kSightColumns + column);
            if (!sight[at].isKnown()) {
                continue;
            }
            float nearest = -1;
            float farthest = 1e9F;
            for (int y = std::max(0, row - 1); y <= std::min(kSightRows - 1, row + 1); ++y) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const int x = (column + dx + kSightColumns) % kSightColumns;
                    const CellSight& cell = sight[static_cast<std::size_t>(y * kSightColumns + x)];
                    if (cell.isKnown()) {
                        nearest = std::max(nearest, cell.nearest);
                        farthest = std::min(farthest, cell.farthest);
                    }
                }
            }
            result.nearest[at] = nearest;
            result.farthest[at] = farthest;
        }
    }
    return result;
}

namespace {

/// How many photos look through a place, see a surface there, and do not know.
struct Votes {
    int through = 0;
    int surface = 0;
    int sureSurface = 0; ///< Of those, at a distance that they know.
    int unknown = 0;
};

/// Follows one direction of a photo through the room.
class Sightline {
  public:
    Sightline(const CellSight& cell, const Eigen::Vector3f& originM, const Eigen::Vector3f& ray,
              std::span<const Observer* const> observers)
        : m_cell(cell), m_originM(originM), m_ray(ray), m_observers(observers) {}

    /// Whether the photo shows something that stands where others look through.
    Foreign foreign() const {
        if (isExplained() || isBesideLens()) {
            return Foreign::No;
        }
        int looking = 0; // photos that look through one of the places before a surface, at most
        bool metSurface = false;
        for (int level = 0; level < kSightLevels; ++level) {
            const Votes votes = votesAt(inverseOf(level));
            if (votes.through == 0 && votes.surface == 0) {
                break; // Something may stand there that hides the rest.
            }
            looking = std::max(looking, votes.through);
            // Something may stand where all see a surface that hides what lies behind it.
            if (votes.through == 0 && looking >= (metSurface ? kSeveral : kLeastLooking)) {
                return Foreign::Yes;
            }
            metSurface = metSurface || votes.through == 0;
        }
        return metSurface ? Foreign::Unwitnessed : Foreign::No;
    }

  private:
    Votes votesAt(double inverseM) const {
        const Eigen::Vector3f at =
            m_originM + m_ray / static_cast<float>(std::max(inverseM, kFarthestInverse));
        Votes votes;
        for (const Observer* other : m_observers) {
            const Standing standing = standingOf(*other, at);
            votes.through += standing == Standing::Through ? 1 : 0;
            votes.sureSurface += standing == Standing::Surface ? 1 : 0;
            votes.surface += standing == Standing::Surface || standing == Standing::PerhapsSurface ? 1 : 0;
            votes.unknown += standing == Standing::Unknown ? 1 : 0;
        }
        return votes;
    }

    /// Whether neighbours show the same at a distance at which others do not look through.
    bool isExplained() const {
        for (int level = 0; level < kSightLevels; ++level) {
            const std::uint64_t bit = std::uint64_t{1} << level;
            if ((m_cell.shown & bit) == 0) {
                continue;
            }
            const Votes votes = votesAt(inverseOf(level));
            const bool isTwice = (m_cell.shownTwice & bit) != 0;
            if (votes.through <= (isTwice ? 2 : 1) && votes.surface + votes.unknown > 0 &&
                (isTwice || votes.surface <= kMostDissenters || !isShownInTheOpen(level))) {
                return true;
            }
        }
        return false;
    }

    /// Whether other photos show a surface nearer than all distances that pictures are compared at. So near
    /// to the lens a thing shows it another side than the others, and nothing of it looks the same.
    bool isBesideLens() const {
        for (double inverse = inverseOf(0) * (1 + kSlackShare); inverse < 1 / kBesideLensM;
             inverse *= 1 + kSlackShare) {
            const Votes votes = votesAt(inverse);
            if (votes.sureSurface >= kLeastShowing && votes.through == 0) {
                return true;
            }
        }
        return false;
    }

    /// Whether the neighbour shows the same at all distances from this one to where several photos look
    /// through. Along the line between two photos nothing moves, and such a match says nothing.
    bool isShownInTheOpen(int level) const {
        for (; level >= 0 && (m_cell.shown & (std::uint64_t{1} << level)) != 0; --level) {
            if (votesAt(inverseOf(level)).through >= kSeveral) {
                return true;
            }
        }
        return false;
    }

    const CellSight& m_cell;
    Eigen::Vector3f m_originM;
    Eigen::Vector3f m_ray;
    std::span<const Observer* const> m_observers;
};

} // namespace

std::vector<Foreign> foreignCells(const SightPhoto& photo, const PhotoSight& sight,
                                  std::span<const Observer* const> observers) {
    std::vector<Foreign> foreign(kSightCells, Foreign::No);
    const Eigen::Matrix3f roomFromPhoto = photo.roomFromPhoto->rotation.matrix().cast<float>();
    const Eigen::Vector3f originM = photo.roomFromPhoto->translation.cast<float>();
    for (int row = kFirstSearchedRow; row < kSightRows; ++row) {
        for (int column = 0; column < kSightColumns; ++column) {
            const Sightline line(sight[static_cast<std::size_t>(row * kSightColumns + column)], originM,
                                 roomFromPhoto * sightDirection(row, column), observers);
            foreign[static_cast<std::size_t>(row * kSightColumns + column)] = line.foreign();
        }
    }
    return foreign;
}

} // namespace spherewalk::align
