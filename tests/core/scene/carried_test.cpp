// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/scene/carried.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace spherewalk::scene {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr EquirectSize kCartSize{512, 256};
constexpr EquirectSize kLookSize{256, 128}; ///< As exports look at photos.

/// The brightness of what is carried along in a direction of the photo; nothing beside it. Units: radians;
/// the angle is that from straight down.
using Cart = std::function<std::optional<double>(double azimuth, double angle)>;

std::optional<double> noCart(double /*azimuth*/, double /*angle*/) {
    return std::nullopt;
}

/// A round robot with four wheels: bare between them.
std::optional<double> roundRobot(double azimuth, double angle) {
    if (angle > 25 * kDegree) {
        return std::nullopt;
    }
    return std::cos(4 * azimuth) > 0.75 && angle > 10 * kDegree ? 22 : 130 - 140 * angle;
}

/// Three thin legs, and a person who always stands behind the camera.
std::optional<double> tripodAndOperator(double azimuth, double angle) {
    const bool isLeg = angle < 20 * kDegree && std::cos(3 * azimuth) > 0.8;
    const double aside = std::abs(std::remainder(azimuth - std::numbers::pi, 2 * std::numbers::pi));
    const bool isPerson = aside < 12 * kDegree && angle < 80 * kDegree;
    if (isPerson) {
        return std::fmod(angle / kDegree, 14) < 7 ? 60 : 150; // a striped coat
    }
    return isLeg || angle < 4 * kDegree ? std::optional(25.0) : std::nullopt;
}

/// A bare hand that holds the camera from below, in each photo a little elsewhere and lit in its own way.
Cart handOf(int photo) {
    const double aside = 3 * kDegree * std::sin(2.3 * photo);
    const double light = 1 + 0.25 * std::sin(1.7 * photo);
    return [=](double azimuth, double angle) -> std::optional<double> {
        const double border = (38 + 12 * std::cos(azimuth + aside)) * kDegree + aside;
        return angle < border ? std::optional(light * (95 + 12 * std::sin(2 * azimuth) * std::sin(angle)))
                              : std::nullopt;
    };
}

struct CartPhotos {
    std::vector<Rigid3> poses;
    std::vector<RgbImage> clear; ///< Without what is carried along.
    std::vector<RgbImage> taken;

    std::vector<PosedPicture> posed() const {
        std::vector<PosedPicture> result;
        for (std::size_t i = 0; i < taken.size(); ++i) {
            result.push_back({&taken[i], poses[i]});
        }
        return result;
    }
};

/// A photo with the cart, and as bright as the camera chose.
RgbImage withCart(const RgbImage& clear, const Cart& cart, double gain) {
    RgbImage picture = clear;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector3d way = direction(kCartSize, Eigen::Vector2d(x, y));
            const auto shade = cart(std::atan2(way.y(), way.x()), std::acos(std::clamp(-way.z(), -1.0, 1.0)));
            for (int c = 0; c < RgbImage::kChannels; ++c) {
                std::uint8_t& value = picture.at(x, y)[c];
                value = static_cast<std::uint8_t>(std::min(255.0, gain * shade.value_or(value)));
            }
        }
    }
    return picture;
}

/// CartPhotos on a grid of half a metre, each turned and exposed in its own way.
CartPhotos photographed(const Cart& cart, int columns, int rows, double firstXM = 1.2) {
    static const practice::PracticeRoom room;
    static std::map<std::tuple<int, int, double>, RgbImage> drawn;
    CartPhotos photos;
    for (int i = 0; i < columns * rows; ++i) {
        const Eigen::Vector3d position(firstXM + 0.5 * (i % columns), 1.2 + 0.5 * (i / columns), 1.2);
        photos.poses.push_back({Eigen::Quaterniond(Eigen::AngleAxisd(0.9 * (i % columns) + 2 * (i / columns),
                                                                     Eigen::Vector3d::UnitZ())),
                                position});
        const double gain = 1 - 0.1 * (i % 4);
        RgbImage& clear = drawn[{i % columns, i / columns, firstXM}];
        clear = clear.empty() ? room.spherical(photos.poses.back(), kCartSize) : clear;
        photos.clear.push_back(withCart(clear, noCart, gain));
        photos.taken.push_back(withCart(clear, cart, gain));
    }
    return photos;
}

Eigen::Vector3d fromBelow(double azimuthDeg, double angleDeg) {
    const double azimuth = azimuthDeg * kDegree;
    const double angle = angleDeg * kDegree;
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), -std::cos(angle)};
}

double psnr(const RgbImage& a, const RgbImage& b, const MaskImage& where) {
    double sum = 0;
    double count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            for (int c = 0; c < RgbImage::kChannels && *where.at(x, y) != 0; ++c) {
                const double difference = a.at(x, y)[c] - b.at(x, y)[c];
                sum += difference * difference;
                ++count;
            }
        }
    }
    return 10 * std::log10(255 * 255 * count / std::max(1.0, sum));
}

TEST(Carried, NothingIsFoundWhereNothingIsCarriedAlong) {
    const CartPhotos photos = photographed(noCart, 4, 3);
    EXPECT_TRUE(carriedThings(photos.posed()).empty());
    EXPECT_EQ(carriedThings(photos.posed()).share(), 0);
}

TEST(Carried, ARobotIsFoundToItsBorderAlsoWhereItIsBare) {
    const CartPhotos photos = photographed(roundRobot, 4, 3);
    const CarriedThings things = carriedThings(photos.posed());
    for (double azimuth = -180; azimuth < 180; azimuth += 3) {
        EXPECT_GT(things.depthInside(fromBelow(azimuth, 24)), 0) << azimuth;
        EXPECT_LT(things.depthInside(fromBelow(azimuth, 34)), 0) << azimuth;
    }
    EXPECT_NEAR(things.share(), (1 - std::cos(25 * kDegree)) / 2, 0.02);
}

TEST(Carried, AnOperatorIsFoundFromFeetToHead) {
    const CartPhotos photos = photographed(tripodAndOperator, 4, 3);
    const CarriedThings things = carriedThings(photos.posed());
    for (const double angle : {5.0, 30.0, 50.0, 70.0, 78.0}) {
        EXPECT_GT(things.depthInside(fromBelow(180, angle)), 0) << angle;
        EXPECT_GT(things.depthInside(fromBelow(171, angle)), 0) << angle;
    }
    EXPECT_GT(things.depthInside(fromBelow(0, 18)), 0) << "a leg";
    EXPECT_LT(things.depthInside(fromBelow(0, 40)), 0);
    EXPECT_LT(things.depthInside(fromBelow(90, 40)), 0);
    EXPECT_LT(things.share(), 0.1);
}

TEST(Carried, AHandIsFoundThoughItIsElsewhereInEachPhoto) {
    CartPhotos photos = photographed(noCart, 4, 3);
    for (std::size_t i = 0; i < photos.taken.size(); ++i) {
        photos.taken[i] = withCart(photos.clear[i], handOf(static_cast<int>(i)), 1);
    }
    const CarriedThings things = carriedThings(photos.posed());
    double truth = 0;
    for (double azimuth = -180; azimuth < 180; azimuth += 3) {
        const double borderDeg = 38 + 12 * std::cos(azimuth * kDegree);
        EXPECT_GT(things.depthInside(fromBelow(azimuth, borderDeg - 1)), 0) << azimuth;
        truth += (1 - std::cos(borderDeg * kDegree)) / 2 / 120;
    }
    EXPECT_LT(things.share(), 1.6 * truth); // The floor beside it is plain.
}

TEST(Carried, PhotosInOneLineTellByEdgesThatWouldMove) {
    const CarriedThings things = carriedThings(photographed(roundRobot, 8, 1).posed());
    for (double azimuth = -180; azimuth < 180; azimuth += 3) {
        EXPECT_GT(things.depthInside(fromBelow(azimuth, 23)), 0) << azimuth;
        EXPECT_LT(things.depthInside(fromBelow(azimuth, 34)), 0) << azimuth;
    }
    EXPECT_TRUE(carriedThings(photographed(noCart, 8, 1).posed()).empty());
}

/// The mean brightness of a pixel of a floor with stripes of 20 cm along x, below walls that differ from
/// photo to photo.
std::uint8_t stripesAt(const Rigid3& roomFromPhoto, const Eigen::Vector2d& pixel) {
    constexpr int kSamples = 6;
    double sum = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const Eigen::Vector2d within((i % kSamples + 0.5) / kSamples - 0.5,
                                     (i / kSamples + 0.5) / kSamples - 0.5);
        const Eigen::Vector3d way = roomFromPhoto.rotation * direction(kLookSize, pixel + within);
        const Eigen::Vector3d& from = roomFromPhoto.translation;
        const double across = from.y() - way.y() / way.z() * from.z();
        const double along = std::atan2(way.y(), way.x()) + way.z() + 0.7 * from.x(); // of the walls
        sum += way.z() < 0                ? std::fmod(across + 1000, 0.4) < 0.2 ? 60 : 150
               : std::sin(20 * along) > 0 ? 90
                                          : 200;
    }
    return static_cast<std::uint8_t>(sum / (kSamples * kSamples));
}

TEST(Carried, LinesOnTheFloorAlongALineOfPhotosAreNotCarriedAlong) {
    const std::vector<PosedPicture> none = photographed(noCart, 8, 1).posed();
    std::vector<RgbImage> pictures;
    std::vector<PosedPicture> photos;
    pictures.reserve(none.size());
    for (std::size_t i = 0; i < none.size(); ++i) {
        // All photos are turned alike, so that the stripes stay in their place.
        const Rigid3 pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())),
                          none[i].roomFromPhoto.translation};
        RgbImage picture(kLookSize.width, kLookSize.height);
        for (int y = 0; y < kLookSize.height; ++y) {
            for (int x = 0; x < kLookSize.width; ++x) {
                std::fill_n(picture.at(x, y), 3, stripesAt(pose, {x + 0.0, y + 0.0}));
            }
        }
        pictures.push_back(std::move(picture));
        photos.push_back({&pictures.back(), pose});
    }
    EXPECT_TRUE(carriedThings(photos).empty());
}

TEST(Carried, FewPhotosAndPhotosAtOnePlaceTellNothing) {
    EXPECT_TRUE(carriedThings(photographed(roundRobot, 2, 2).posed()).empty());
    const CartPhotos grid = photographed(roundRobot, 4, 3);
    std::vector<PosedPicture> atOnePlace = grid.posed();
    for (PosedPicture& photo : atOnePlace) {
        photo.roomFromPhoto.translation = atOnePlace[0].roomFromPhoto.translation;
    }
    EXPECT_TRUE(carriedThings(atOnePlace).empty());
}

TEST(Carried, AnEmptyPictureIsRefused) {
    const RgbImage none;
    const std::vector<PosedPicture> photos{{&none, {}}};
    test::expectError(ErrorKind::InvalidInput, "a picture is empty", [&] { carriedThings(photos); });
}

TEST(Carried, TheFloorStandsInItsPlaceAsOtherPhotosShowIt) {
    const CartPhotos photos = photographed(roundRobot, 4, 3);
    const std::vector<PosedPicture> posed = photos.posed();
    const CarriedThings things = carriedThings(posed);
    survey::Room room;
    room.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    room.ceilingM = 2.5;
    const std::size_t middle = 5;
    std::vector<PosedPicture> others = posed;
    others.erase(others.begin() + middle);
    const FilledPicture clear = withoutCarried(posed[middle], others, things, room);
    EXPECT_GT(psnr(clear.picture, photos.clear[middle], clear.filled), 20);
    EXPECT_LT(psnr(photos.taken[middle], photos.clear[middle], clear.filled), 13);
    for (int y = 0; y < kCartSize.height; ++y) {
        for (int x = 0; x < kCartSize.width; ++x) {
            const Eigen::Vector3d way = direction(kCartSize, Eigen::Vector2d(x, y));
            ASSERT_EQ(*clear.filled.at(x, y) != 0, things.depthInside(way) > 0) << x << " " << y;
            if (*clear.filled.at(x, y) == 0) {
                ASSERT_TRUE(std::equal(clear.picture.at(x, y), clear.picture.at(x, y) + 3,
                                       photos.taken[middle].at(x, y)));
            }
        }
    }
}

TEST(Carried, TheFloorIsAsBrightAsThePhotoBesideAWall) {
    const CartPhotos photos = photographed(roundRobot, 4, 3, 0.35);
    const std::vector<PosedPicture> posed = photos.posed();
    survey::Room room;
    room.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    room.ceilingM = 2.5;
    const FilledPicture clear =
        withoutCarried(posed[0], std::span(posed).subspan(1), carriedThings(posed), room);
    double filled = 0;
    double truth = 0;
    for (std::size_t i = 0; i < clear.filled.values().size(); ++i) {
        for (std::size_t c = 0; c < 3 && clear.filled.values()[i] != 0; ++c) {
            filled += clear.picture.values()[3 * i + c];
            truth += photos.clear[0].values()[3 * i + c];
        }
    }
    EXPECT_NEAR(filled / truth, 1, 0.05); // By equal directions it is off by 6 %.
}

TEST(Carried, NothingIsTakenFromPhotosBehindAWall) {
    const CartPhotos photos = photographed(roundRobot, 4, 3);
    const std::vector<PosedPicture> posed = photos.posed();
    survey::Room closet; // about the first photo
    closet.outline = {{0.75, 0.75}, {1.65, 0.75}, {1.65, 1.65}, {0.75, 1.65}};
    closet.ceilingM = 2.5;
    const FilledPicture clear =
        withoutCarried(posed[0], std::span(posed).subspan(1), carriedThings(posed), closet);
    // Of the floor; a wall of no thickness is seen from behind, too.
    for (int y = 0; y < kCartSize.height; ++y) {
        for (int x = 0; x < kCartSize.width; ++x) {
            const bool isFloor = direction(kCartSize, Eigen::Vector2d(x, y)).z() < -std::cos(15 * kDegree);
            ASSERT_TRUE(!isFloor || *clear.filled.at(x, y) == 0) << x << " " << y;
        }
    }
}

TEST(Carried, WhatNoOtherPhotoSeesStaysAsItIs) {
    const CartPhotos photos = photographed(roundRobot, 4, 3);
    const CarriedThings things = carriedThings(photos.posed());
    const FilledPicture clear = withoutCarried(photos.posed()[0], {}, things, {});
    EXPECT_EQ(clear.picture.values()[0], photos.taken[0].values()[0]);
    EXPECT_TRUE(std::all_of(clear.filled.values().begin(), clear.filled.values().end(),
                            [](std::uint8_t value) { return value == 0; }));
}

} // namespace

} // namespace spherewalk::scene
