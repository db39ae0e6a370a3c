// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::align {

/// One thing that a photo ought to show: a neighbour sees it, and another of the neighbour's neighbours
/// confirms it.
struct Witness {
    Eigen::Vector3d expected = Eigen::Vector3d::UnitX(); ///< Unit vector in the photo's frame.
    bool isSeen = false;                                 ///< The photo shows it there.
    double rangeM = 0;                                   ///< Distance from the photo.
    Radians aside;            ///< Between the directions in which the photo and the neighbour look at it.
    std::vector<int> viewers; ///< Photos that see it, if this one does not.
    double chance = 0;        ///< Chance that the photo shows it, by how many others do.
    double weight = 1;        ///< Less where other neighbours witness the same thing.
    /// Where the photo shows a thing that looks alike, if elsewhere.
    std::optional<Eigen::Vector3d> elsewhere;
    int featureElsewhere = -1;
};

/// What speaks for a photo showing the same as its neighbours, and what speaks against it.
struct PhotoWitnesses {
    std::vector<Witness> witnesses;
    /// Bearings of the photo that fit a neighbour's, for things that no other photo confirms.
    std::vector<Eigen::Vector3d> agreed;
    int neighbours = 0;
};

/// What a neighbour lets expect in a photo, in numbers of things.
struct ExpectedThings {
    double expected = 0; ///< As many as the neighbour's usual neighbours show.
    double seen = 0;     ///< The photo shows them where they belong.
};

/// All matches by photo and feature, with the distances that inliers give. Owner: the pairs must outlive it.
/// Errors: InvalidInput if the lists' lengths differ or a pair names a photo that does not exist.
class Sightings {
  public:
    Sightings(std::span<const std::optional<Rigid3>> roomFromPhoto, std::span<const PhotoPair> pairs,
              std::span<const std::vector<bool>> isInlier,
              std::function<bool(const Eigen::Vector3d&)> isSearched = {});

    /// The witnesses of all neighbours of a photo. Cost: grows with their matches. Threads: any.
    PhotoWitnesses witnesses(int photo) const;

    /// What the neighbour shares with third photos in any look, and how much of it this photo shows. Threads:
    /// any.
    ExpectedThings expected(int photo, int neighbour) const;

    /// What the neighbour shares with third photos and this photo has in sight: it shares it, or shows things
    /// of its own beside it that are as far away. Only things count that both see from about the same side.
    /// So walls between the photos hide nothing of it, and what is not seen looks another way. Threads: any.
    ExpectedThings inSight(int photo, int neighbour) const;

    bool isPlaced(int photo) const { return m_roomFromPhoto[static_cast<std::size_t>(photo)].has_value(); }

    /// Median distance of what the photo shares with others; 0 if they tell none.
    double usualRangeM(int photo) const;

    /// Where another photo was taken, in the photo's frame. Range: both photos are solved.
    Eigen::Vector3d positionInPhoto(int photo, int other) const;

  private:
    /// Another photo of a pair, and the look that found the pair's matches.
    struct Neighbour {
        static constexpr int kAnyLook = -1;

        int photo = 0;
        int look = kAnyLook;

        bool isOf(int asked) const { return asked == kAnyLook || look == asked; }
    };

    /// One match from the view of one of its photos.
    struct Sighting {
        int feature = 0;
        Neighbour other;
        int featureOfOther = -1;
        const Eigen::Vector3d* own = nullptr;
        const Eigen::Vector3d* others = nullptr;
        bool isInlier = false;
        double rangeM = 0; ///< Along the own bearing; 0 if the two photos do not tell.
    };

    /// Something that a photo shares with two others or more beside the one asked for.
    struct Thing {
        Eigen::Vector3d pInRoom;
        bool isShared; ///< With the one asked for.
    };

    std::vector<Thing> things(int photo, int other) const;
    /// Calls use() with the sightings of each of a photo's features.
    template <class Use>
    void forEachFeature(int photo, const Use& use) const;
    void add(int photo, Neighbour other, const Correspondence& match, bool isFromA, bool isInlier);
    double rangeM(int photo, int other, const Eigen::Vector3d& own, const Eigen::Vector3d& others) const;
    /// Adds the neighbour's witnesses, with the share of its photos that show the thing as their chance. The
    /// photos of the neighbour's look are asked.
    void witness(int photo, Neighbour neighbour, PhotoWitnesses& result) const;
    std::optional<Witness> witness(int photo, Neighbour neighbour, std::span<const Sighting> ofFeature,
                                   PhotoWitnesses& result) const;

    /// Whether neighbours see the photo's feature where the photo shows it: then it did not come from
    /// elsewhere.
    bool standsThere(int photo, int feature) const;

    std::vector<std::optional<Rigid3>> m_roomFromPhoto;
    std::vector<std::vector<Sighting>> m_of;                  ///< One list a photo, sorted by feature.
    std::vector<std::vector<Neighbour>> m_neighbours;         ///< One list a photo, solved photos alone.
    std::function<bool(const Eigen::Vector3d&)> m_isSearched; ///< In a photo's frame. Empty: all is searched.
};

/// A disc of directions in a photo's frame.
struct PhotoRegion {
    Eigen::Vector3d middle = Eigen::Vector3d::UnitX();
    Radians radius;
};

/// Whether the witness expects its thing in the region, or in a region so many times as wide.
bool isWithin(const Witness& witness, const PhotoRegion& region, double times = 1);

/// Whether the photos that see what this photo misses in the region all stand to one side. Then something may
/// hide the things from this photo. What is seen from both sides is hardly hidden in the middle.
bool isSeenFromOneSide(const PhotoWitnesses& witnesses, const PhotoRegion& region, int photo,
                       const Sightings& sightings);

/// Whether the photo shows things nearer than what it misses, in the region or beside it, on which it agrees
/// with its neighbours. Such things may hide the others.
bool hasNearerThings(const PhotoWitnesses& witnesses, const PhotoRegion& region);

} // namespace spherewalk::align
