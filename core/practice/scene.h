// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "furniture.h"

#include "spherewalk/practice/practice_room.h"

#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::practice {

/// What a ray meets. id: of the surface, to find edges by; -1 for nothing.
struct Hit {
    double distance = kNothing;
    int id = -1;
};

/// A shape that a ray may meet, and the distance before which it does not.
struct Candidate {
    double nearest = 0;
    std::uint16_t shape = 0;
};

/// The practice room with its corner at the origin, ready to be looked at. Threads: const, any number.
class Scene {
  public:
    Scene(const Eigen::Vector3d& size, const std::vector<PracticeObject>& objects,
          const Eigen::Vector3d& origin);

    /// The shapes that a cone from the eye may meet, nearest first. halfAngle >= pi: all of them.
    void candidates(const Eigen::Vector3d& eye, const Eigen::Vector3d& axis, double halfAngle,
                    Content content, std::vector<Candidate>& found) const;

    Hit hit(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
            std::span<const Candidate> candidates, bool withWalls) const;

    /// The colour there as pictures store it, [0, 255]. footprint: an angle, radians.
    Rgb colour(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
               float footprint) const;

    const Furniture& furniture() const { return m_furniture; }

  private:
    /// The light on a wall, evaluated on a lattice beforehand.
    struct LightMap {
        int columns = 0;
        int rows = 0;
        float perMetre = 0;
        std::vector<Rgb> values;
    };

    Rgb radiance(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                 float footprint, bool mayMirror) const;
    Rgb wallLight(int wall, float u, float v) const;
    Rgb lightAt(const Eigen::Vector3d& point, const Eigen::Vector3f& normal) const;
    Rgb sunAt(const Eigen::Vector3d& point) const;
    float openness(const Eigen::Vector3d& point, std::span<const std::uint16_t> near) const;
    float cornerOpenness(const Eigen::Vector3d& point, int wall) const;
    SurfacePoint wallSurface(int wall, const Eigen::Vector3d& point) const;
    Eigen::Vector3d wallPoint(int wall, float u, float v) const;
    LightMap bakedWall(int wall) const;

    Eigen::Vector3d m_size;
    Furniture m_furniture;
    std::vector<std::uint16_t> m_all;                   ///< furniture without objects
    std::vector<Candidate> m_allUnsorted;               ///< the same, for rays from anywhere
    std::vector<std::vector<std::uint16_t>> m_shadedBy; ///< by shape
    std::array<LightMap, kWalls> m_lightMaps;
};

} // namespace spherewalk::practice
