// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/place/seen_depth.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::place {

struct FusionOptions {
    double voxelM = 0.02; ///< Edge of a voxel.
    int threads = 0;      ///< 0: all that the machine has. The result is the same for any number.

    /// Farther from a surface nothing is told but that space is free.
    double truncationM() const { return 3 * voxelM; }

    /// Errors: InvalidInput for a voxel that is not 2 mm to 1 m.
    void validate() const;
};

/// What all photos say about a voxel's centre.
struct Voxel {
    float distanceM = 0; ///< To the nearest surface, positive before it and negative behind.
    float weight = 0;    ///< Sum of the photos' weights; 0 where nothing is known.
};

/// Signed distances to surfaces, kept in cubes of 8 x 8 x 8 voxels where a photo shows a surface. Frames:
/// the room's axes; voxel (0, 0, 0) has its centre at originM(). Threads: const, any number.
class Volume {
  public:
    static constexpr int kSide = 8;
    using Block = std::array<Voxel, kSide * kSide * kSide>; ///< x fastest, then y.

    double voxelM() const { return m_voxelM; }

    const Eigen::Vector3d& originM() const { return m_originM; }

    std::size_t blockCount() const { return m_blocks.size(); }

    const Block& block(std::size_t i) const { return m_blocks[i]; }

    /// The voxel (0, 0, 0) of a block, as whole voxels from the volume's origin.
    Eigen::Vector3i corner(std::size_t block) const;

    /// The block that holds a voxel; nothing known of it gives blockCount().
    std::size_t blockOf(const Eigen::Vector3i& voxel) const;

    /// The voxel whose centre is nearest to a point of the room.
    Eigen::Vector3i nearest(const Eigen::Vector3d& pInRoom) const;

  private:
    friend class Fusion;

    double m_voxelM = 0;
    Eigen::Vector3d m_originM = Eigen::Vector3d::Zero();
    std::vector<std::uint64_t> m_keys; ///< Of the blocks, ascending.
    std::vector<Block> m_blocks;
};

/// Fuses the depths of photos into one truncated signed distance. At each voxel each photo votes with the
/// distance along its ray from the voxel to what it shows. Photos that look through the voxel vote for free
/// space, so they outvote a single photo that is wrong. Votes count by 1 / variance, and less the farther the
/// voxel lies behind the surface. The result is the votes' weighted median, and the mean of what lies about
/// it. Errors: InvalidInput for options, no photos, photos that stand more than four million voxels away from
/// the first, and a volume that would take more than 4 GB. Stop: Stopped. Cost: about 60 ns a voxel and
/// photo. Source: Curless and Levoy 1996.
Volume fused(std::span<const SeenDepth> photos, const FusionOptions& options, ProgressSink& progress,
             const std::stop_token& stop);

} // namespace spherewalk::place
