// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/dataset.h"

#include <Eigen/Core>

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::campaign {

/// Walls and things where a level laser meets them, seen from above.
class Slice {
  public:
    explicit Slice(double heightM) : m_heightM(heightM) {}

    /// Adds where a triangle meets the laser's plane.
    void cut(const std::array<Eigen::Vector3d, 3>& corners);

    /// To the first thing along a direction of unit length; infinite if there is none.
    double rangeM(const Eigen::Vector2d& from, const Eigen::Vector2d& along) const;

    /// To the nearest thing.
    double clearanceM(const Eigen::Vector2d& from) const;

    double heightM() const { return m_heightM; }

  private:
    double m_heightM;
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> m_segments;
};

/// A place that was exported, and whose truth is known. Frames: room. Units: metres.
class KnownPlace {
  public:
    /// A point of the place as a photo sees it, and the share of all directions that it stands for.
    struct SeenPoint {
        Eigen::Vector3d place;
        double weight;
    };

    virtual ~KnownPlace() = default;

    /// The distance from a point to the nearest surface; negative where the truth does not know.
    virtual double distanceM(const Eigen::Vector3d& point) const = 0;
    /// How many photos have a place of a surface in sight.
    virtual int sights(const Eigen::Vector3d& place) const = 0;
    /// What lies in directions that are spread evenly about photos.
    virtual std::vector<SeenPoint> seenPoints() const = 0;
    /// Whether something stands in a cell of a map, from 5 cm to 1.8 m above the floor.
    virtual bool isOccupied(const Eigen::Vector2d& middle, double cellM) const = 0;
    /// Whether some photo sees this point of free space.
    virtual bool isSeenThrough(const Eigen::Vector3d& point) const = 0;
    /// To the nearest thing at the height of the laser, at least.
    virtual double clearanceM(const Eigen::Vector3d& point) const = 0;

    /// How far a photo's depth should say that something is; infinite where the truth does not know.
    virtual double depthM(const Eigen::Vector3d& /*from*/, const Eigen::Vector3d& /*along*/) const {
        return std::numeric_limits<double>::infinity();
    }

    /// What a level laser measures; infinite where the truth does not know.
    virtual double laserM(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const = 0;
};

/// Height of the laser above the floor.
inline constexpr double kLaserHeightM = 0.25;

/// The practice room "lively", "bare" or "flat" (8 x 6 x 2.5 m), photographed as a dataset says.
std::unique_ptr<KnownPlace> practicePlace(const std::string& style, const render::DatasetInfo& info);

/// A folder with truth.json: poses of photos, and range maps of some of them, in millimetres. Only what those
/// show is known.
std::unique_ptr<KnownPlace> scannedPlace(const std::filesystem::path& folder);

} // namespace spherewalk::campaign
