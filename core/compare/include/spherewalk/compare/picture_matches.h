// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace spherewalk::compare {

/// A feature that two pictures show, with its place in each. Units: pixels.
struct PictureMatch {
    Eigen::Vector2d inA;
    Eigen::Vector2d inB;
};

struct PlaceDisplacements;

/// The SIFT features of a picture, found once for several matchings. Threads: const, any number.
class PictureFeatures {
  public:
    static constexpr double kUsualContrast = 0.04;

    /// leastContrast: threshold of OpenCV's SIFT; a lower one gives more and weaker features. Errors:
    /// Internal if OpenCV refuses.
    explicit PictureFeatures(const RgbImage& picture, double leastContrast = kUsualContrast);

    /// The size of the picture.
    int width() const;
    int height() const;

  private:
    friend std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b,
                                                    double reachPx);
    friend PlaceDisplacements placeDisplacements(const PictureFeatures& truth,
                                                 const PictureFeatures& computed);
    struct Found;
    std::shared_ptr<const Found> m_found;
};

/// Pairs of features that are each other's best by far. Only their looks are compared, so some pairs are
/// wrong. reachPx: largest distance between both places; 0 for any. A reach gives more matches of pictures
/// that are nearly the same, because a feature has fewer rivals.
std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b,
                                         double reachPx = 0);

/// The matches that move like two of their nearest neighbours. Parallax is even on surfaces, and wrong
/// matches are not. Errors: InvalidInput if the sizes differ.
std::vector<PictureMatch> witnessedMatches(const PictureFeatures& a, const PictureFeatures& b);

/// A pixel of the true picture, and how far away the computed picture shows the same thing. Units: pixels.
struct Displacement {
    Eigen::Vector2d pixel;
    double errorPx = 0;
};

/// Displacements of the witnessed matches alone. What does not match has no say, so a picture in which little
/// matches may look better than it is. Errors: InvalidInput if the sizes differ; Internal if OpenCV refuses.
std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth, const PictureFeatures& computed);

/// The places of a true picture: its features with some contrast about them.
struct PlaceDisplacements {
    std::vector<Displacement> found; ///< The places that the computed picture shows.
    std::size_t missed = 0;          ///< Number of places that it does not show.

    /// Of all places; 0 if there are none.
    double missedShare() const;
};

/// Finds each place of the true picture in the computed one. A place is found by a witnessed match, or else
/// by the patch of 21 x 21 pixels about it. The patch is sought within 16 pixels of the place itself, and
/// then of where its nearest neighbour moved to. Its correlation must reach 0.65, and 0.02 more for each
/// pixel of distance, because patterns repeat. All other places are missed. Unmatched places within 16 pixels
/// of the border or with a contrast below 5 grey levels do not count at all. Errors: as above. Cost: 0.1 s
/// for 640 x 480.
PlaceDisplacements placeDisplacements(const PictureFeatures& truth, const PictureFeatures& computed);

/// Displacements by a known depth, for every `every`-th pixel of every `every`-th row. The taken depth leads
/// from the pixel to a direction of the photo. The photo shows there a thing at about the true thing's
/// distance; the error is the distance between the pixel and that thing's place. Pixels without a true depth
/// are left out. trueZ and takenZ: depth along the optical axis in metres; an empty takenZ and +infinity mean
/// infinitely far. Errors: InvalidInput if sizes differ.
std::vector<Displacement> exactDisplacements(const CameraModel& camera, const Rigid3& roomFromCamera,
                                             const Eigen::Vector3d& photoInRoom, const DepthImage& trueZ,
                                             const DepthImage& takenZ, int every = 4);

/// The error that this share of the displacements does not exceed; nothing without displacements. Range:
/// share in [0, 1].
std::optional<double> quantile(const std::vector<Displacement>& displacements, double share);

} // namespace spherewalk::compare
