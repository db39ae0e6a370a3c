// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/practice/practice_options.h"

#include <optional>
#include <vector>

namespace spherewalk::test {

/// How a practice room is photographed.
struct PeopledOptions {
    practice::RoomStyle room = practice::RoomStyle::Lively;
    double stepM = 0.4;
    bool isReal = false;  ///< Photos have the flaws of a real camera.
    double tiltDeg = 0.5; ///< Standard deviation of pitch and of roll.
    int mostPhotos = 36;  ///< A block of the grid around the room's middle, or with a seed but 1 elsewhere.
    double peopled = 0;   ///< Share of the photos that show somebody.
    int width = 1024;
    std::uint64_t seed = 1;
    double lensSigma = 0; ///< Standard deviation of the logarithm by which one lens is brighter, each photo.
};

/// A person as one photo shows them.
struct SeenPerson {
    double part = 0;        ///< Visible part of the sphere.
    double hiddenShare = 0; ///< Share of the person that furniture hides.
    double distanceM = 0;
    int photos = 1; ///< Neighbouring photos that show the person at the same place.
};

struct PeopledPhoto {
    RgbImage picture;
    Rigid3 truth;                                       ///< roomFromPhoto.
    Eigen::Vector3d nominalM = Eigen::Vector3d::Zero(); ///< Where the photo is tagged.
    std::optional<SeenPerson> person;
};

/// Photos of an empty practice room, each turned by any angle.
std::vector<PeopledPhoto> emptySurvey(const PeopledOptions& options);

/// Takes a share of the photos again, with somebody in the room. Every third person keeps still while two or
/// three neighbouring photos are taken.
void addPersons(const PeopledOptions& options, std::vector<PeopledPhoto>& photos);

} // namespace spherewalk::test
