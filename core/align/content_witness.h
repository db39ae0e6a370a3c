// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace spherewalk::align {

/// One thing that a photo's neighbour sees, and another of the neighbour's neighbours confirms: the photo
/// ought to show it.
struct Witness {
    Eigen::Vector3d expected = Eigen::Vector3d::UnitX(); ///< in the photo's frame, unit
    bool isSeen = false;                                 ///< the photo shows it there
    double rangeM = 0;                                   ///< from the photo
    std::vector<int> viewers;                            ///< photos that see it, if this one does not
    double chance = 0;                                   ///< that the photo shows it, by how many others do
    double weight = 1; ///< less where other neighbours witness the same thing
    /// Where the photo shows what looks like it, if elsewhere.
    std::optional<Eigen::Vector3d> elsewhere;
    int featureElsewhere = -1;
};

/// What speaks for and against a photo showing the same as its neighbours.
struct PhotoWitnesses {
    std::vector<Witness> witnesses;
    /// Bearings of the photo that fit a neighbour's, of things that no other photo confirms.
    std::vector<Eigen::Vector3d> agreed;
    int neighbours = 0;
};

/// All matches by photo and feature, with the distances that inliers give.
class Sightings {
  public:
    Sightings(std::span<const std::optional<Rigid3>> roomFromPhoto, std::span<const PhotoPair> pairs,
              std::span<const std::vector<bool>> isInlier);

    /// Cost: the matches of the photo's neighbours. Threads: any.
    PhotoWitnesses witnesses(int photo) const;

    /// Where another photo was taken, in the photo's frame. Both are solved.
    Eigen::Vector3d positionInPhoto(int photo, int other) const;

  private:
    /// One match, as seen from one of its photos.
    struct Sighting {
        int feature = 0;
        int other = 0; ///< photo
        int featureOfOther = -1;
        const Eigen::Vector3d* own = nullptr;
        const Eigen::Vector3d* others = nullptr;
        bool isInlier = false;
        double rangeM = 0; ///< along the own bearing; 0: the two photos do not tell
    };

    void add(int photo, int other, const Correspondence& match, bool isFromA, bool isInlier);
    double rangeM(int photo, int other, const Eigen::Vector3d& own, const Eigen::Vector3d& others) const;
    void witness(int photo, int neighbour, PhotoWitnesses& result) const;
    std::optional<Witness> witness(int photo, int neighbour, std::span<const Sighting> ofFeature,
                                   PhotoWitnesses& result) const;

    std::vector<std::optional<Rigid3>> m_roomFromPhoto;
    std::vector<std::vector<Sighting>> m_of;    ///< one list a photo, by feature
    std::vector<std::vector<int>> m_neighbours; ///< of each photo, solved ones alone
};

} // namespace spherewalk::align
