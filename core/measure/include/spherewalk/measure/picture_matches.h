// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace spherewalk::measure {

/// A thing that two pictures show, where the one and where the other has it. Units: pixels.
struct PictureMatch {
    Eigen::Vector2d inA;
    Eigen::Vector2d inB;
};

/// Features (SIFT) of a picture, found once to be matched several times. Threads: const, any number.
class PictureFeatures {
  public:
    static constexpr double kUsualContrast = 0.04;

    /// leastContrast: of a feature, as OpenCV's SIFT counts it; less gives more and weaker ones. Errors:
    /// Internal, for what OpenCV refuses.
    explicit PictureFeatures(const RgbImage& picture, double leastContrast = kUsualContrast);

    /// Of the picture.
    int width() const;
    int height() const;

  private:
    friend std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b,
                                                    double reachPx);
    struct Found;
    std::shared_ptr<const Found> m_found;
};

/// Features that are each other's best by far, by nothing but their looks: some are wrong. reachPx: how far a
/// thing may be from its place in the other picture; pictures that are nearly the same have more matches
/// within a reach, since a feature need be unlike only those near by. 0: anywhere.
std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b,
                                         double reachPx = 0);

} // namespace spherewalk::measure
