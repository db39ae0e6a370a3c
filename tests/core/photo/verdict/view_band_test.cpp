// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelled_photos.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/view_band.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace spherewalk::photo {

namespace {

constexpr EquirectSize kPhotoSize{768, 384};

class SameView : public testing::TestWithParam<practice::RoomStyle> {
  protected:
    SameView() {
        practice::PracticeRoomOptions options;
        options.style = GetParam();
        options.sizeM = {8, 6, 2.6};
        room.emplace(options);
    }

    RgbImage at(const Eigen::Vector3d& positionM, Radians yaw = Radians(0.3)) const {
        return room->spherical({yawRotation(yaw), positionM}, kPhotoSize);
    }

    /// As a camera takes it: with noise and a little other light, and as JPEG.
    ViewBand taken(const RgbImage& picture) {
        RgbImage noisy = picture;
        for (std::uint8_t& value : noisy.values()) {
            value = static_cast<std::uint8_t>(std::clamp(value + random.integer(-6, 6), 0, 255));
        }
        return viewBand(jpeg::encode(noisy, 85), "a photo");
    }

    test::Random random{19};
    std::optional<practice::PracticeRoom> room;
};

} // namespace

TEST_P(SameView, IsSeenOfACameraThatStoodStill) {
    for (const Eigen::Vector3d& place : {Eigen::Vector3d(2, 2, 1.2), {4.1, 3.3, 1.2}, {6.4, 1.5, 1.2}}) {
        const RgbImage picture = at(place);
        const ViewBand before = taken(picture);
        EXPECT_TRUE(isSameView(taken(test::exposed(picture, 0.3)), before).value());
        EXPECT_TRUE(isSameView(taken(test::withPerson(picture, 1.8, random)), before).value());
    }
}

TEST_P(SameView, IsNotSeenOfACameraThatMovedByAStep) {
    for (const double stepM : {0.1, 0.2, 0.4, 0.8}) {
        for (int i = 0; i < 4; ++i) {
            const Eigen::Vector3d place(random.uniform(1.5, 5.5), random.uniform(1.5, 4), 1.2);
            const Eigen::Vector3d step = stepM * (yawRotation(Radians(i)) * Eigen::Vector3d::UnitX());
            EXPECT_FALSE(isSameView(taken(at(place + step)), taken(at(place))).value_or(false)) << stepM;
        }
    }
    const Eigen::Vector3d place(3, 2, 1.2);
    EXPECT_FALSE(isSameView(taken(at(place, Radians(0.5))), taken(at(place))).value_or(false)); // turned
}

INSTANTIATE_TEST_SUITE_P(Rooms, SameView,
                         testing::Values(practice::RoomStyle::Lively, practice::RoomStyle::Bare,
                                         practice::RoomStyle::Flat));

TEST(SameViews, AreNotToldWithoutTexture) {
    const ViewBand flat(640, 213);
    EXPECT_FALSE(isSameView(flat, flat).has_value());
    EXPECT_FALSE(isSameView(flat, ViewBand(320, 106)).has_value());
}

} // namespace spherewalk::photo
