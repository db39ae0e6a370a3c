// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/find_features.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/tag_check.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/photo/april_tag.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A printed AprilTag in one photo of the survey.
struct TagSighting {
    int photo = 0; ///< Index among the photos.
    photo::SeenTag tag;
};

struct FindTagsOptions {
    std::filesystem::path cacheFolder; ///< If empty, what is found is not kept.
    int threads = 0;                   ///< 0 means all that the machine has. Each holds one photo in memory.
};

/// The AprilTags in the photos, photo after photo. Photos that cannot be read show none; findFeatures() names
/// them. Errors: Stopped; Io. Stop: heard at each photo. Cost: 1 s a photo of 5376 x 2688.
std::vector<TagSighting> findTags(std::span<const PhotoFile> photos, const FindTagsOptions& options,
                                  ProgressSink& progress, const std::stop_token& stop);

/// Adds the corners of tags to the matches of pairs whose photos both see them. A number that one photo shows
/// twice is left out.
void joinTags(std::span<const TagSighting> sightings, std::span<PhotoPair> pairs);

/// Where a tag hangs.
struct RoomTag {
    int number = 0;
    photo::TagCorners<Eigen::Vector3d> corners; ///< In the frame and the unit of the photos' places.
    double size = 0;                            ///< Side of the black square, in the same unit.
    double sizeSigma = 0;
    double sigma = 0; ///< Standard deviation of a corner along the worst axis, against the photos.
    int photos = 0;   ///< Number of photos that see it there.
};

struct RoomTags {
    std::vector<RoomTag> tags; ///< By number; one each.
    /// Length of the photos' places over their true length, by the printed size. Empty without any tag.
    std::optional<Scale> scale;
    std::vector<std::string> warnings; ///< Sentences for people.
};

/// A photo with a pose.
struct PlacedPhoto {
    Rigid3 roomFromPhoto;
    LensPair lenses;
    std::string name; ///< The name that sentences for people use.
};

/// Where the tags hang, by the photos that see them: each tag is a square of unknown size, and rays begin at
/// the lens that saw it. Photos that see a number elsewhere are named. sizeM: printed side of all tags, in
/// metres. Shape: photos has one entry a photo, empty where the photo has no pose. Cost: some milliseconds.
RoomTags roomTags(std::span<const std::optional<PlacedPhoto>> photos, std::span<const TagSighting> sightings,
                  double sizeM);

/// What takes one solution's frame to another's: pInOther = scale * (rotation * pInOwn) + translation.
struct TagJoin {
    Rigid3 otherFromOwn;
    double scale = 1;
    double scaleSigma = 0;    ///< As a share of the scale.
    double misfitM = 0;       ///< Root mean square over the corners that fit.
    std::vector<int> numbers; ///< The tags that fit.
    std::vector<int> moved;   ///< Tags that hang elsewhere than they did.
};

/// The motion that takes own tags to where the same tags hang in the other frame, whose unit is the metre.
/// Both frames are level within a fraction of a degree, which helps where one tag alone says little of it.
/// Empty if no number is in both.
std::optional<TagJoin> joinByTags(std::span<const RoomTag> own, std::span<const RoomTag> other);

} // namespace spherewalk::align
