// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/align/features.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace spherewalk::align {

namespace {

using Grey = Image<std::uint8_t, 1>;

/// A photo of what has this brightness in each direction of the room. Each pixel is the mean of 3 x 3 places.
Grey photoOf(const std::function<double(const Eigen::Vector3d&)>& brightness,
             const Eigen::Quaterniond& roomFromPhoto, int width = 1024) {
    const EquirectSize size{width, width / 2};
    Grey photo(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            double sum = 0;
            for (int i = 0; i < 9; ++i) {
                const Eigen::Vector2d at(x + (i % 3 - 1) / 3.0, y + (i / 3 - 1) / 3.0);
                sum += brightness(roomFromPhoto * direction(size, at));
            }
            *photo.at(x, y) = static_cast<std::uint8_t>(std::lround(sum / 9));
        }
    }
    return photo;
}

/// Walls in strips of chance brightness, each some degrees wide, from the floor up to 40 degrees.
class Strips {
  public:
    explicit Strips(unsigned seed) {
        test::Random random(seed);
        for (double end = -std::numbers::pi; end < std::numbers::pi; end += random.uniform(0.1, 0.3)) {
            m_ends.push_back(end);
            m_brightness.push_back(random.uniform(30, 220));
        }
    }

    double operator()(const Eigen::Vector3d& to) const {
        if (std::abs(to.z()) > 0.64) {
            return 128;
        }
        const auto after = std::ranges::upper_bound(m_ends, std::atan2(to.y(), to.x()));
        return m_brightness[static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - m_ends.begin())) -
                            1];
    }

  private:
    std::vector<double> m_ends;
    std::vector<double> m_brightness;
};

double missDeg(const Vertical& vertical, const Eigen::Quaterniond& roomFromPhoto) {
    return Degrees(angleBetween(roomFromPhoto * vertical.upInPhoto, Eigen::Vector3d::UnitZ())).value();
}

Eigen::Quaterniond attitude(double yawDeg, double pitchDeg, double rollDeg) {
    return rotation({Degrees(yawDeg), Degrees(pitchDeg), Degrees(rollDeg)});
}

} // namespace

TEST(UprightEdges, TellHoweverAPhotoLeans) {
    for (const auto& [yaw, pitch, roll] :
         {std::tuple(0., 0., 0.), {77., 0.3, -0.2}, {-140., 4., -6.}, {12., -10., 3.}, {178., 0., 15.}}) {
        const Eigen::Quaterniond roomFromPhoto = attitude(yaw, pitch, roll);
        const auto vertical = findVertical(photoOf(Strips(5), roomFromPhoto), {});
        ASSERT_TRUE(vertical) << yaw << " " << pitch << " " << roll;
        EXPECT_LT(missDeg(*vertical, roomFromPhoto), 0.06) << yaw << " " << pitch << " " << roll;
        EXPECT_LT(Radians(Degrees(missDeg(*vertical, roomFromPhoto))).value(), 3 * vertical->sigmaRad);
        EXPECT_LT(Degrees(Radians(vertical->sigmaRad)).value(), 0.15);
    }
}

TEST(UprightEdges, TellThatOfALargePhotoToo) {
    const Eigen::Quaterniond roomFromPhoto = attitude(50, 3, -2);
    const auto vertical = findVertical(photoOf(Strips(6), roomFromPhoto, 2688), {});
    ASSERT_TRUE(vertical);
    EXPECT_LT(missDeg(*vertical, roomFromPhoto), 0.05);
}

TEST(UprightEdges, SayNothingWhereThereAreNone) {
    const Eigen::Quaterniond upright = Eigen::Quaterniond::Identity();
    EXPECT_FALSE(findVertical(photoOf([](const auto&) { return 100; }, upright), {}));
    const auto shelves = [](const Eigen::Vector3d& to) { return std::sin(20 * to.z()) > 0 ? 60. : 190.; };
    EXPECT_FALSE(findVertical(photoOf(shelves, upright), {}));
    EXPECT_FALSE(findVertical(photoOf(shelves, attitude(0, 5, 5)), {}));
    test::Random random(9);
    EXPECT_FALSE(findVertical(photoOf([&](const auto&) { return random.uniform(0, 255); }, upright), {}));
    EXPECT_FALSE(findVertical(Grey(64, 32), {}));
}

TEST(UprightEdges, SayNothingIfTheyLieInOneDirection) {
    const auto oneDoor = [strips = Strips(5)](const Eigen::Vector3d& to) {
        return to.x() > 0 && std::abs(to.y()) < 0.3 ? strips(to) : 128;
    };
    EXPECT_FALSE(findVertical(photoOf(oneDoor, Eigen::Quaterniond::Identity()), {}));
}

/// As in a picture whose halves were joined wrongly, or on stairs between slanted walls.
TEST(UprightEdges, SayNothingIfTheySpeakForTwoDirections) {
    const Eigen::Quaterniond slanted = attitude(0, 0, 8);
    const auto halves = [&, strips = Strips(5)](const Eigen::Vector3d& to) {
        return to.x() > 0 ? strips(to) : strips(slanted * to);
    };
    EXPECT_FALSE(findVertical(photoOf(halves, Eigen::Quaterniond::Identity()), {}));
}

TEST(UprightEdges, OutweighThoseOfAFewSlantedThings) {
    const Eigen::Quaterniond slanted = attitude(0, 0, 9);
    const auto ladder = [&, strips = Strips(5), other = Strips(8)](const Eigen::Vector3d& to) {
        return to.x() > 0.8 ? other(slanted * to) : strips(to);
    };
    const auto vertical = findVertical(photoOf(ladder, Eigen::Quaterniond::Identity()), {});
    ASSERT_TRUE(vertical);
    EXPECT_LT(missDeg(*vertical, Eigen::Quaterniond::Identity()), 0.06);
}

TEST(UprightEdges, AreNotLookedForBehindTheMask) {
    const Grey photo = photoOf(Strips(5), Eigen::Quaterniond::Identity());
    MaskImage mask(64, 32);
    std::ranges::fill(mask.values(), std::uint8_t{0});
    EXPECT_FALSE(findVertical(photo, {}, mask));
    std::ranges::fill(mask.values(), std::uint8_t{255});
    EXPECT_TRUE(findVertical(photo, {}, mask));
}

TEST(UprightEdges, ComeWithTheFeatures) {
    RgbImage photo(1024, 512);
    const Grey strips = photoOf(Strips(5), attitude(0, 2, 0));
    for (std::size_t i = 0; i < photo.values().size(); ++i) {
        photo.values()[i] = strips.values()[i / 3];
    }
    const Features features = detectFeatures(photo, {});
    ASSERT_TRUE(features.vertical);
    EXPECT_LT(missDeg(*features.vertical, attitude(0, 2, 0)), 0.06);
}

} // namespace spherewalk::align
