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
    struct Found;
    std::shared_ptr<const Found> m_found;
};

/// Pairs of features that are each other's best by far. Only their looks are compared, so some pairs are
/// wrong. reachPx: largest distance between both places; 0 for any. A reach gives more matches of pictures
/// that are nearly the same, because a feature has fewer rivals.
std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b,
                                         double reachPx = 0);

/// A pixel of the true picture, and how far away the computed picture shows the same thing. Units: pixels.
struct Displacement {
    Eigen::Vector2d pixel;
    double errorPx = 0;
};

/// Displacements of features that match in both pictures and move like two of their nearest neighbours.
/// Parallax is even on surfaces, and wrong matches are not. Errors: InvalidInput if the sizes differ;
/// Internal if OpenCV refuses.
std::vector<Displacement> matchedDisplacements(const RgbImage& truth, const RgbImage& computed);
std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth, const PictureFeatures& computed);

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
