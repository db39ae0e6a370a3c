// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/face_search.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/survey/private_region.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::test {

/// A photo of the practice room, in which a portrait hangs life-size in this direction.
inline RgbImage photoWithPortrait(const SphericalDirection& towards, double distanceM) {
    constexpr EquirectSize kPhoto{photo::kFaceSearchWidth, photo::kFaceSearchWidth / 2};
    constexpr double kMetresPerPixel = 0.22 / 116;
    const Eigen::Vector2d face(164, 130); // of the portrait, pixels
    static const RgbImage room =
        practice::PracticeRoom().spherical({Eigen::Quaterniond::Identity(), {2.5, 2, 1.4}}, kPhoto);
    RgbImage photo = room;
    const RgbImage portrait = photo::readPicture(SPHEREWALK_TEST_DATA "/faces/astronaut.jpg");
    const survey::RegionFrame frame({towards.azimuth, towards.elevation, Degrees(90), Degrees(90)});
    for (int y = 0; y < kPhoto.height; ++y) {
        for (int x = 0; x < kPhoto.width; ++x) {
            const auto at = frame.at(direction(kPhoto, Eigen::Vector2d(x, y)));
            if (!at) {
                continue;
            }
            const Eigen::Vector2d pixel =
                Eigen::Vector2d(at->x(), -at->y()) * distanceM / kMetresPerPixel + face;
            const auto column = static_cast<int>(std::lround(pixel.x()));
            const auto row = static_cast<int>(std::lround(pixel.y()));
            if (column >= 0 && row >= 0 && column < portrait.width() && row < portrait.height()) {
                std::copy_n(portrait.at(column, row), 3, photo.at(x, y));
            }
        }
    }
    return photo;
}

} // namespace spherewalk::test
