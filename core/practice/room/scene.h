// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room/furniture.h"
#include "room/shape.h"

#include "spherewalk/practice/practice_room.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::practice {

/// What a ray meets first. id: number of the surface, which differs across edges; -1 for nothing.
struct Hit {
    double distance = kNothing;
    int id = -1;
};

/// A shape that a ray may meet. nearest: a lower bound of its distance.
struct Candidate {
    double nearest = 0;
    std::uint16_t shape = 0;
};

/// The practice room with its corner at the origin. Threads: any.
class Scene {
  public:
    explicit Scene(const PracticeRoomOptions& options);

    /// Finds the shapes that a cone from the eye may meet, nearest first. halfAngle: radians; from pi on, all
    /// shapes.
    void candidates(const Eigen::Vector3d& eye, const Eigen::Vector3d& axis, double halfAngle,
                    Content content, std::vector<Candidate>& found) const;

    Hit hit(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
            std::span<const Candidate> candidates, bool withWalls) const;

    /// Distance from a point inside of the room to the nearest wall, floor, ceiling or piece of furniture.
    double surfaceDistance(const Eigen::Vector3d& point) const;

    /// The colour at the hit as pictures store it, [0, 255]. footprint: angle of the sample, radians.
    Rgb colour(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
               float footprint) const;

    const Furniture& furniture() const { return m_furniture; }

  private:
    /// The light on a wall at the nodes of a grid, computed once.
    struct LightMap {
        int columns = 0;
        int rows = 0;
        float perMetre = 0;
        std::vector<Rgb> values;
    };

    Rgb radiance(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                 float footprint, bool mayMirror) const;
    /// The light from behind, with what panes before it reflect.
    Rgb throughPanes(const Rgb& behind, double distance, const Eigen::Vector3d& eye,
                     const Eigen::Vector3d& direction, float footprint) const;
    Rgb wallLight(int wall, float u, float v) const;
    /// The light on a surface from all that it sees of the room without objects, in the unit of lightAt().
    Rgb gathered(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
    /// The share of that light that objects leave to the surface.
    Rgb leftByObjects(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
    Rgb lightAt(const Eigen::Vector3d& point, const Eigen::Vector3f& normal) const;
    Rgb sunAt(const Eigen::Vector3d& point) const;
    float openness(const Eigen::Vector3d& point, std::span<const std::uint16_t> near) const;
    float cornerOpenness(const Eigen::Vector3d& point, int wall) const;
    SurfacePoint wallSurface(int wall, const Eigen::Vector3d& point) const;
    Eigen::Vector3d wallPoint(int wall, float u, float v) const;
    LightMap bakedWall(int wall) const;

    Eigen::Vector3d m_size;
    Furniture m_furniture;
    std::vector<std::uint16_t> m_all;                   ///< Furniture without objects.
    std::vector<std::uint16_t> m_casters;               ///< Objects that cast shadows.
    std::vector<Candidate> m_allUnsorted;               ///< The same, for rays from anywhere.
    std::vector<std::vector<std::uint16_t>> m_shadedBy; ///< By shape.
    std::array<LightMap, kWalls> m_lightMaps;
};

} // namespace spherewalk::practice
