// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/photo/april_tag.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::practice {

using test::expectError;

namespace {

PracticeRoomOptions tagged(RoomStyle style, int count) {
    PracticeRoomOptions options;
    options.style = style;
    options.sizeM = style == RoomStyle::Flat ? Eigen::Vector3d(8, 6, 2.5) : Eigen::Vector3d(5, 4, 2.6);
    options.originM = {1000, -200, 3};
    options.tags = tagsOnWalls(PracticeRoom(options), count, 0.16);
    return options;
}

double greyAt(const PracticeRoom& room, const Eigen::Vector3d& eye, const Eigen::Vector3d& at) {
    const Sample sample = room.cast(eye, at - eye, 1e-4);
    EXPECT_NEAR(sample.rangeM, (at - eye).norm(), 0.002);
    return (sample.colour[0] + sample.colour[1] + sample.colour[2]) / 3;
}

} // namespace

TEST(PracticeTags, HangWhereTheirCornersSay) {
    for (const RoomStyle style : {RoomStyle::Lively, RoomStyle::Bare, RoomStyle::Flat}) {
        const PracticeRoomOptions options = tagged(style, 6);
        ASSERT_EQ(options.tags.size(), 6U);
        const PracticeRoom room(options);
        for (const PracticeTag& tag : options.tags) {
            const auto corners = tag.cornersM();
            const Eigen::Vector3d eye = tag.centreM + 0.8 * Eigen::Vector3d(std::cos(tag.facing.value()),
                                                                            std::sin(tag.facing.value()), 0);
            const photo::TagCells cells = photo::tagCells(tag.number);
            const auto at = [&](double column, double row) -> Eigen::Vector3d {
                return corners[0] + column / 8 * (corners[1] - corners[0]) +
                       row / 8 * (corners[3] - corners[0]);
            };
            const double black = greyAt(room, eye, at(0.5, 0.5));
            const double white = greyAt(room, eye, at(-0.5, 4));
            EXPECT_GT(white, black + 30) << tag.number;
            for (int cell = 0; cell < 64; ++cell) {
                const double grey = greyAt(room, eye, at(cell % 8 + 0.5, cell / 8 + 0.5));
                EXPECT_EQ(grey > (black + white) / 2, cells[static_cast<std::size_t>(cell)])
                    << "tag " << tag.number << ", cell " << cell;
            }
        }
    }
}

TEST(PracticeTags, ChangeNothingElse) {
    const PracticeRoomOptions options = tagged(RoomStyle::Lively, 1);
    PracticeRoomOptions without = options;
    without.tags.clear();
    const Rigid3 pose{Eigen::Quaterniond::Identity(), options.originM + Eigen::Vector3d(2, 1.8, 1.2)};
    const RgbImage with = PracticeRoom(options).spherical(pose, {256, 128});
    const RgbImage bare = PracticeRoom(without).spherical(pose, {256, 128});
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.values().size(); i += 3) {
        changed += with.values()[i] != bare.values()[i] ? 1 : 0;
    }
    EXPECT_GT(changed, 5U);
    EXPECT_LT(changed, 256U * 128U / 100);
}

TEST(PracticeTags, AreNoMoreThanTheWallsHold) {
    EXPECT_LT(tagsOnWalls(PracticeRoom(), 100, 0.6).size(), 40U);
}

TEST(PracticeTags, ThatCannotHangAreRefused) {
    PracticeRoomOptions options;
    options.tags = {PracticeTag{587, {1, 0, 1}, Degrees(90), 0.16}};
    expectError(ErrorKind::InvalidInput, "each tag needs a number", [&] { options.validate(); });
    options.tags = {PracticeTag{5, {1, 0, 9}, Degrees(90), 0.16}};
    expectError(ErrorKind::InvalidInput, "inside the room", [&] { options.validate(); });
    options.tags = {PracticeTag{5, {1, 0, 1}, Degrees(90), std::nan("")}};
    expectError(ErrorKind::InvalidInput, "2 cm to 1 m", [&] { options.validate(); });
}

} // namespace spherewalk::practice
