// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

#include <array>
#include <bitset>
#include <vector>

namespace spherewalk::photo {

/// AprilTags of the family 36h11: black squares of 8 x 8 cells whose inner 6 x 6 cells tell the number. A
/// rim of white, one cell wide, belongs to a printed tag. Source: Olson 2011, AprilTag; bits and detection
/// are OpenCV's.
inline constexpr int kTagCells = 8;
inline constexpr int kTagNumbers = 587;

/// Whether cell (row * kTagCells + column) is white, of the upright tag, from its upper left corner.
using TagCells = std::bitset<kTagCells * kTagCells>;

/// Errors: InvalidInput for a number outside [0, kTagNumbers).
TagCells tagCells(int number);

/// The corners of a tag's black square: upper left, upper right, lower right, lower left of the upright tag.
template <class Corner>
using TagCorners = std::array<Corner, 4>;

/// A tag in a picture.
struct SeenTag {
    int number = 0;
    TagCorners<Eigen::Vector3d> directions; ///< Unit vectors, in the picture's own frame.
    double sigmaRad = 0;                    ///< Standard deviation of a direction, along any axis across it.
};

/// The tags in an equirectangular photo, by number, then from the left. Directions are of the panorama frame.
/// Tags below -50 degrees (cart and operator) and above 60 degrees are not looked for, nor are tags smaller
/// than 16 pixels. The whole pattern is fitted to the photo's pixels, so that corners are good to some
/// hundredths of a pixel. Errors: InvalidInput for a picture that is not twice as wide as high. Threads: any.
/// Cost: 1 s for 5376 x 2688.
std::vector<SeenTag> seenTags(const RgbImage& photo);

/// The tags in the picture of a robot's camera. Directions are of the optical frame. Errors: InvalidInput if
/// the picture has not the camera's size.
std::vector<SeenTag> seenTags(const RgbImage& picture, const CameraModel& camera);

} // namespace spherewalk::photo
