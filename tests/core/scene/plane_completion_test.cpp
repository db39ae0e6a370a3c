// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/depth_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::scene {

namespace {

constexpr int kPartWidth = 256;
constexpr CompletionRange kRange{0.5F, 0.01F, 5};

/// A room of 4 x 4 x 2.6 m as a photo sees it. A part of a wall or of the ceiling is not known.
struct PartlyKnown {
    Plane truth;
    Plane weight{kPartWidth, kPartWidth / 2};
    RgbImage picture{kPartWidth, kPartWidth / 2};

    /// The part lies within so many degrees of the direction.
    PartlyKnown(const Eigen::Vector3d& towards, double degrees) {
        const render::RoomShape room{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -1.2, 1.4};
        truth =
            render::roomDepth(room, {Eigen::Quaterniond::Identity(), {0.3, 0.2, 0}}, kPartWidth).inverseM();
        for (int y = 0; y < kPartWidth / 2; ++y) {
            for (int x = 0; x < kPartWidth; ++x) {
                const Eigen::Vector3d ray = direction({kPartWidth, kPartWidth / 2}, Eigen::Vector2d(x, y));
                const double cosine = ray.dot(towards.normalized());
                *weight.at(x, y) = cosine > std::cos(degrees * std::numbers::pi / 180) ? 0.0F : 1.0F;
                std::fill_n(picture.at(x, y), 3, shade(ray / static_cast<double>(*truth.at(x, y))));
            }
        }
    }

    /// Walls, floor and ceiling are lit differently.
    static std::uint8_t shade(const Eigen::Vector3d& atM) {
        if (atM.z() < -1.19 || atM.z() > 1.39) {
            return atM.z() < 0 ? 60 : 220;
        }
        return std::abs(atM.x() + 0.3) > std::abs(atM.y() + 0.2) ? 120 : 170;
    }

    /// The worst error of what was not known, as a share of 1 / distance.
    float worst(const Plane& found) const {
        float most = 0;
        for (std::size_t i = 0; i < truth.values().size(); ++i) {
            const float right = truth.values()[i];
            most =
                weight.values()[i] > 0 ? most : std::max(most, std::fabs(found.values()[i] - right) / right);
        }
        return most;
    }

    /// What is not known is garbage, which nobody may read.
    Plane known() const {
        Plane result = truth;
        for (std::size_t i = 0; i < truth.values().size(); ++i) {
            result.values()[i] = weight.values()[i] > 0 ? truth.values()[i] : 77;
        }
        return result;
    }

    Plane completed(int threads = 0) const {
        return completedByPlanes(known(), weight, picture, {}, kRange, threads);
    }
};

} // namespace

TEST(PlaneCompletion, ContinuesAWallOverWhatIsNotKnown) {
    const PartlyKnown room({1, 0, 0.1}, 25);
    EXPECT_LT(room.worst(room.completed()), 0.03F);
}

TEST(PlaneCompletion, ContinuesACeilingAtThePole) {
    const PartlyKnown room({0, 0, 1}, 25);
    EXPECT_LT(room.worst(room.completed()), 0.04F);
}

TEST(PlaneCompletion, CrossesTheSeam) {
    const PartlyKnown room({-1, 0, 0}, 25);
    EXPECT_LT(room.worst(room.completed()), 0.02F);
}

TEST(PlaneCompletion, EndsAtAnEdgeOfThePicture) {
    // Left of the middle column all is at 1 m and known; so is the right edge of a strip at 2 m.
    PartlyKnown room({0, 0, 1}, 0);
    Plane known(kPartWidth, kPartWidth / 2);
    for (int y = 0; y < kPartWidth / 2; ++y) {
        for (int x = 0; x < kPartWidth; ++x) {
            const bool isNear = x < kPartWidth / 2;
            *known.at(x, y) = isNear ? 1.0F : 0.5F;
            *room.weight.at(x, y) = x >= kPartWidth / 2 && x < kPartWidth / 2 + 6 ? 0.0F : 1.0F;
            std::fill_n(room.picture.at(x, y), 3, isNear ? std::uint8_t{40} : std::uint8_t{200});
        }
    }
    const Plane found = completedByPlanes(known, room.weight, room.picture, {}, kRange, 0);
    for (int x = kPartWidth / 2; x < kPartWidth / 2 + 6; ++x) {
        EXPECT_NEAR(*found.at(x, kPartWidth / 4), 0.5F, 0.02F) << x;
    }
}

TEST(PlaneCompletion, IsPulledLittleByAStripOfFewPixels) {
    const PartlyKnown room({1, 0, 0.1}, 25);
    PhotoDepth depth{room.known(), MaskImage(kPartWidth, kPartWidth / 2)};
    for (std::size_t i = 0; i < depth.sure.values().size(); ++i) {
        depth.sure.values()[i] = room.weight.values()[i] > 0 ? 255 : 0;
    }
    constexpr int kMiddleX = kPartWidth / 2; // of what is not known
    constexpr int kMiddleY = kPartWidth / 4 - 4;
    for (int x = kMiddleX - 1; x < kMiddleX + 1; ++x) {
        *depth.inverseM.at(x, kMiddleY) = 2 * *room.truth.at(x, kMiddleY);
        *depth.sure.at(x, kMiddleY) = 255;
    }
    const Plane found = continuedFromSure(depth, room.picture, {}, 0);
    EXPECT_EQ(*found.at(kMiddleX, kMiddleY), *depth.inverseM.at(kMiddleX, kMiddleY)); // it stays itself
    for (const int y : {kMiddleY - 6, kMiddleY + 6}) {
        EXPECT_NEAR(*found.at(kMiddleX, y) / *room.truth.at(kMiddleX, y), 1, 0.1) << y;
    }
}

// A small piece of a wall that is seen aslant, as a plane, would soon be at the camera or behind it.
TEST(PlaneCompletion, BecomesEvenFarFromWhatIsKnown) {
    Plane known(kPartWidth, kPartWidth / 2);
    Plane weight = known;
    for (int y = 50; y < 78; ++y) {
        for (int x = 100; x < 128; ++x) {
            *known.at(x, y) = 0.5F + 0.02F * static_cast<float>(x - 100);
            *weight.at(x, y) = 1;
        }
    }
    const Plane found = completedByPlanes(known, weight, RgbImage(kPartWidth, kPartWidth / 2), {}, kRange, 0);
    const auto [least, most] = std::minmax_element(found.values().begin(), found.values().end());
    EXPECT_GT(*least, 0.35F);
    EXPECT_LT(*most, 1.2F);
}

// A piece is known, 0.2 nearer than the base, which differs from pixel to pixel.
TEST(PlaneCompletion, LeavesTheBaseAsMuchAsIsKnownAndReturnsToIt) {
    Plane base(kPartWidth, kPartWidth / 2);
    for (std::size_t i = 0; i < base.values().size(); ++i) {
        base.values()[i] = 0.5F + 0.1F * std::sin(0.01F * static_cast<float>(i));
    }
    Plane known = base;
    Plane weight(kPartWidth, kPartWidth / 2);
    for (int y = 56; y < 72; ++y) {
        for (int x = 100; x < 116; ++x) {
            *known.at(x, y) += 0.2F;
            *weight.at(x, y) = 1;
        }
    }
    const RgbImage even(kPartWidth, kPartWidth / 2);
    const Plane found = completedByPlanes(known, weight, even, base, {0, 0.01F, 5}, 0);
    EXPECT_NEAR(*found.at(108, 64) - *base.at(108, 64), 0.2, 0.01);
    EXPECT_NEAR(*found.at(118, 64) - *base.at(118, 64), 0.2, 0.05);
    EXPECT_NEAR(*found.at(236, 64), *base.at(236, 64), 0.02);
}

TEST(PlaneCompletion, IsTheUsualValueWhereNothingIsKnown) {
    const Plane nothing(kPartWidth, kPartWidth / 2);
    const Plane found =
        completedByPlanes(nothing, nothing, RgbImage(kPartWidth, kPartWidth / 2), {}, {0.4F, 0.01F, 5}, 0);
    const auto [least, most] = std::minmax_element(found.values().begin(), found.values().end());
    EXPECT_NEAR(*least, 0.4F, 0.02F);
    EXPECT_NEAR(*most, 0.4F, 0.02F);
}

TEST(PlaneCompletion, IsTheSameForAnyNumberOfThreads) {
    const PartlyKnown room({1, 0, 0.1}, 25);
    EXPECT_EQ(room.completed(1), room.completed(4));
}

} // namespace spherewalk::scene
