// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/moved_photo.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::scene {

namespace {

constexpr EquirectSize kSize{512, 256};
const render::RoomShape kRoom{{{0, 0}, {5, 0}, {5, 4}, {0, 4}}, 0, 2.6};

/// A colour of the room that changes slowly with the place.
Eigen::Vector3d paint(const Eigen::Vector3d& pInRoom) {
    return 127.0 + 100.0 * Eigen::Vector3d(std::sin(2 * pInRoom.x()), std::sin(2 * pInRoom.y() + 1),
                                           std::sin(3 * pInRoom.z()))
                               .array();
}

/// What a photo of the painted room shows.
RgbImage photographed(const Rigid3& roomFromPhoto) {
    RgbImage photo(kSize.width, kSize.height);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const Eigen::Vector3d way = roomFromPhoto.rotation * direction(kSize, Eigen::Vector2d(x, y));
            const double inverse = render::inverseDistance(kRoom, roomFromPhoto.translation, way);
            const Eigen::Vector3d colour = paint(roomFromPhoto.translation + way / inverse);
            for (int c = 0; c < 3; ++c) {
                photo.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(colour[c]));
            }
        }
    }
    return photo;
}

double meanDifference(const RgbImage& a, const RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        sum += std::abs(int{a.values()[i]} - int{b.values()[i]});
    }
    return sum / static_cast<double>(a.values().size());
}

} // namespace

TEST(MovedPhoto, OfAnUnchangedRoomLooksLikeThePhotoThatWasTakenThere) {
    test::Random random(20);
    for (int i = 0; i < 6; ++i) {
        const auto pose = [&] {
            return Rigid3{rotation({Radians(random.uniform(-3, 3)), Radians(random.uniform(-0.1, 0.1)),
                                    Radians(random.uniform(-0.1, 0.1))}),
                          {random.uniform(1, 4), random.uniform(1, 3), random.uniform(0.8, 1.6)}};
        };
        const Rigid3 here = pose();
        const Rigid3 there = pose();
        const render::DepthMap depth = render::roomDepth(kRoom, here, kSize.width);
        const RgbImage moved = photoSeenFrom({here, &depth}, photographed(there), {there, nullptr});
        EXPECT_LT(meanDifference(moved, photographed(here)), 2) << "seed " << random.seed();
        const RgbImage turned = photoSeenFrom({here, nullptr}, photographed(there), {there, nullptr});
        EXPECT_GT(meanDifference(turned, photographed(here)), 8) << "seed " << random.seed();
    }
}

TEST(MovedPhoto, OfTheSamePlaceIsOnlyTurned) {
    const Rigid3 here{yawRotation(Degrees(40)), {2, 2, 1.2}};
    const Rigid3 there{yawRotation(Degrees(-100)), {2, 2, 1.2}};
    const RgbImage moved = photoSeenFrom({here, nullptr}, photographed(there), {there, nullptr});
    EXPECT_LT(meanDifference(moved, photographed(here)), 1.5);
}

TEST(MovedPhoto, DimsWhatTheOtherPhotoCannotSee) {
    const Rigid3 here{Eigen::Quaterniond::Identity(), {1, 2, 1.2}};
    const Rigid3 there{Eigen::Quaterniond::Identity(), {4, 2, 1.2}};
    const render::DepthMap hereDepth = render::roomDepth(kRoom, here, kSize.width);
    Image<float, 1> near(kSize.width, kSize.height); // a cupboard all around it
    std::fill(near.values().begin(), near.values().end(), 1 / 0.4F);
    const render::DepthMap thereDepth(near);
    RgbImage white(kSize.width, kSize.height);
    std::fill(white.values().begin(), white.values().end(), std::uint8_t{200});
    const RgbImage open = photoSeenFrom({here, &hereDepth}, white, {there, nullptr});
    const RgbImage hidden = photoSeenFrom({here, &hereDepth}, white, {there, &thereDepth});
    EXPECT_EQ(open.at(256, 128)[0], 200);
    EXPECT_EQ(hidden.at(256, 128)[0], 100);
}

} // namespace spherewalk::scene
