// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace spherewalk::test {

/// A clean photo, from where it was taken.
struct PlacedPicture {
    RgbImage picture;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
};

/// Photos of the practice room on a lattice of this step, each turned by any angle, or all the same way.
std::vector<PlacedPicture> practicePhotos(int columns, int rows, double stepM, int width, bool anyYaw,
                                          Random& random);

/// The picture as a camera that shook would give it: a Gaussian of this many pixels, or along rows only.
RgbImage blurred(const RgbImage& picture, double sigmaPx, bool alongRowsOnly);
/// With so many stops more light.
RgbImage exposed(const RgbImage& picture, double stops);
/// With red and blue multiplied.
RgbImage tinted(const RgbImage& picture, double red, double blue);
RgbImage upsideDown(const RgbImage& picture);
/// A person in clothes of any colour who stands this far from a camera at 1.2 m.
RgbImage withPerson(const RgbImage& picture, double distanceM, Random& random);
/// One of the camera's two lenses covered.
RgbImage halfBlack(const RgbImage& picture);
/// A lamp that shines into the lens.
RgbImage halfBurnt(const RgbImage& picture);
/// Turned about the upright axis by so many pixels, with noise and the least of changes in the light.
RgbImage ordinary(const RgbImage& picture, Random& random);

} // namespace spherewalk::test
