// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/match_pairs.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/room_tags.h"
#include "spherewalk/align/tag_check.h"
#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::align {

struct RetrievalOptions {
    int partners = 10;   ///< Each photo is compared with so many that look most alike, [1, 1000].
    int exhaustive = 16; ///< Up to so many photos, all are compared with all.
    int threads = 0;     ///< 0 means all that the machine has.
    int bridges = 3;     ///< Pairs that are tried again between each photo and another part.
    /// A photo that fewer others look like, [0, 1000], is looked at again with so many features, [50, 50000]:
    /// white walls and long steps leave the strongest features little in common.
    int fewAlike = 4;
    int secondLook = 1600;
    MatchOptions match;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// How much every two photos look alike, at a first look: one number a pair of photos.
class Likeness {
  public:
    explicit Likeness(int photos) : m_photos(photos), m_votes(static_cast<std::size_t>(photos) * photos) {}

    int photos() const { return m_photos; }

    /// Number of features that agree on one rotation of the two photos; 0 if none is clear.
    int votes(int a, int b) const { return m_votes[static_cast<std::size_t>(a) * m_photos + b]; }

    void set(int a, int b, int votes) {
        m_votes[static_cast<std::size_t>(a) * m_photos + b] = votes;
        m_votes[static_cast<std::size_t>(b) * m_photos + a] = votes;
    }

  private:
    int m_photos;
    std::vector<int> m_votes;
};

/// Compares the strongest features of every two photos, and more features of those that few others look like.
/// Threads: the result is the same for any number. Cost: 1 ms a pair of photos, 8 ms for those looked at
/// again. Stop: heard at each photo.
Likeness likeness(std::span<const Features> photos, const RetrievalOptions& options, ProgressSink& progress,
                  const std::stop_token& stop);

/// The pairs worth comparing, a < b, sorted: of each photo those that look most alike, and those that join
/// all photos that look alike at all.
std::vector<std::pair<int, int>> likelyPairs(const Likeness& alike, const RetrievalOptions& options);

/// Pairs that may join what the estimates leave apart: for each photo the likeliest of other parts, but none
/// that was compared already.
std::vector<std::pair<int, int>> likelyBridges(const Likeness& alike, std::span<const PairEstimate> estimates,
                                               const RetrievalOptions& options);

/// A distance that somebody measured between the lenses of two photos.
struct KnownDistance {
    int a = 0;
    int b = 0;
    double metres = 0;
};

struct FreeOptions {
    double lensHeightM = 1.2;              ///< Usual height of the lens above the floor.
    double lensHeightSigmaM = 0.01;        ///< Standard deviation of the mean of all photos' heights.
    bool isLensHeightGuessed = false;      ///< Nobody said it, and lengths are known to a quarter.
    std::optional<KnownDistance> distance; ///< Fixes the scale in place of the floor.
    /// AprilTags that the photos see. Their printed size fixes the scale in place of the floor.
    std::vector<TagSighting> tags;
    double tagSizeM = 0; ///< Printed side of the tags, [0.01, 10]; 0 without tags.
    /// Where tags hang in the frame of another solution, in metres. They fix frame and scale.
    std::vector<RoomTag> knownTags;
    int threads = 0; ///< 0 means all that the machine has.
    /// A photo's pixels, at least so wide if it has as many. With it, what photos see of a thing is compared
    /// in their pictures, and rooms that little joins bend less. Empty: features alone are used.
    std::function<RgbImage(int photo, int width)> picture = {};

    /// Errors: InvalidInput, naming the option and its range.
    void validate(int photos) const;
};

/// Where one photo was taken.
struct FreePlace {
    std::optional<Rigid3> roomFromPhoto; ///< Empty if it could not be placed.
    LensPair lenses;                     ///< As far as the pictures tell; the same for all photos.
    std::string why;                     ///< A sentence if it was not placed.
    std::string doubt;                   ///< A sentence if it was placed, but little confirms it.
    int part = 0;                        ///< Index of the part of the survey; 0 for the largest; -1 for none.
    double sigmaM = 0;                   ///< Along the worst axis, against the others, the scale excepted.
    double sigmaRad = 0;                 ///< About the worst axis, against the others.
    int points = 0;                      ///< Number of solved points that it sees.
};

enum class ScaleBy {
    Nothing,
    Guess, ///< A height of the lens over the floor that nobody said.
    Floor, ///< The height of the lens over it.
    Distance,
    Tags
};

struct FreePlaces {
    std::vector<FreePlace> photos;
    int parts = 0;
    ScaleBy scaleBy = ScaleBy::Nothing;
    double scaleSigma = 0;                ///< Standard deviation of all lengths, as a share of them.
    double lensHeightM = 0;               ///< What was taken for the usual height of the lens.
    bool isLensHeightGuessed = false;     ///< Nobody said it.
    bool isLevelByFloor = false;          ///< Whether the floor, and not the photos, said what is level.
    std::vector<Eigen::Vector3d> pointsM; ///< What the photos of the largest part see, in the room frame.
    std::optional<TagJoin> join;          ///< How the frame was found by known tags.
    Polygon outline;                      ///< Of the walls, as far as points and photos show them.
    double ceilingM = 0;                  ///< The highest that is seen.
    std::vector<std::string> warnings;    ///< Sentences for people.
};

/// Solves where photos were taken from nothing but the pictures. The largest part that the pairs connect is
/// placed: rotations are averaged, then lengths and positions, then all of them are adjusted with the points
/// that the photos see, and once more with what their pictures show of these points. The frame: the floor is
/// z = 0, the first placed photo stands at x = y = 0, and the walls that are seen most lie along x and y.
/// Known tags give their own frame in place of that. Positions of the priors are not used.
///
/// estimates: one a pair. Errors: InvalidInput; Stopped; those of reading a picture. Stop: heard at each
/// solver iteration. Threads: the same result for any number. Source: `resources/docs/alignment.md`.
FreePlaces freePlaces(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                      std::span<const PairEstimate> estimates, const FreeOptions& options,
                      ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
