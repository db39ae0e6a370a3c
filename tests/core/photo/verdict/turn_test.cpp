// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/sketch.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::photo {

namespace {

constexpr EquirectSize kSize{384, 192};
constexpr double kMostDeg = 20; ///< Near things lie elsewhere in the two photos.

Sketch taken(const practice::PracticeRoom& room, const Eigen::Vector2d& at, Radians yaw) {
    const Rigid3 pose{yawRotation(yaw), {at.x(), at.y(), 1.2}};
    return sketch(jpeg::encode(room.spherical(pose, kSize), 90), {}, "a photo");
}

class TurnBetween : public testing::TestWithParam<practice::RoomStyle> {};

} // namespace

TEST_P(TurnBetween, IsRightOrNotTold) {
    practice::PracticeRoomOptions options;
    options.style = GetParam();
    options.sizeM = {8, 6, 2.6};
    const practice::PracticeRoom room(options);
    test::Random random(77);
    int told = 0;
    constexpr int kPairs = 40;
    for (int i = 0; i < kPairs; ++i) {
        const Eigen::Vector2d at(random.uniform(1.5, 6.5), random.uniform(1.5, 4.5));
        const Eigen::Vector2d other = at + random.uniform(0.1, 0.8) * Eigen::Vector2d(0.6, 0.8);
        const double ownYaw = random.uniform(-3, 3);
        const double otherYaw = random.uniform(-3, 3);
        const auto turn =
            turnBetween(taken(room, at, Radians(ownYaw)), taken(room, other, Radians(otherYaw)));
        if (turn) {
            ++told;
            // The other one's azimuth of a thing is the photo's own plus the turn.
            const Radians error = wrapped(*turn - Radians(ownYaw - otherYaw));
            EXPECT_LT(std::abs(Degrees(error).value()), kMostDeg) << i << ", seed " << random.seed();
        }
    }
    RecordProperty("told", told);
    EXPECT_GE(told, kPairs / 2);
}

INSTANTIATE_TEST_SUITE_P(Rooms, TurnBetween,
                         testing::Values(practice::RoomStyle::Lively, practice::RoomStyle::Bare,
                                         practice::RoomStyle::Flat));

TEST(TurnBetween, OfAPhotoThatShowsNothingIsNotTold) {
    test::Random random(5);
    RgbImage noise(kSize.width, kSize.height);
    for (std::uint8_t& value : noise.values()) {
        value = static_cast<std::uint8_t>(random.integer(100, 110));
    }
    const Sketch own = taken(practice::PracticeRoom(practice::PracticeRoomOptions()), {2, 2}, Radians(0));
    EXPECT_FALSE(turnBetween(own, sketch(jpeg::encode(noise, 90), {}, "noise")));
}

} // namespace spherewalk::photo
