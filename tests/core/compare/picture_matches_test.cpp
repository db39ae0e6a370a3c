// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/compare/picture_matches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::compare {

namespace {

/// Squares of all sizes and shades, moved.
RgbImage squares(unsigned seed, int right, int down) {
    test::Random random(seed);
    RgbImage picture(320, 240);
    for (int i = 0; i < 400; ++i) {
        const int x = random.integer(10, 290) + right;
        const int y = random.integer(10, 210) + down;
        const int size = random.integer(3, 12);
        const auto grey = static_cast<std::uint8_t>(random.integer(60, 255));
        for (int v = y; v < std::min(240, y + size); ++v) {
            for (int u = x; u < std::min(320, x + size); ++u) {
                std::fill_n(picture.at(u, v), 3, grey);
            }
        }
    }
    return picture;
}

const CameraModel kPlaneCamera(CameraIntrinsics::pinhole(320, 240, 1.0));

DepthImage plane(float z) {
    DepthImage depth(320, 240);
    std::fill(depth.values().begin(), depth.values().end(), z);
    return depth;
}

/// Blobs at random places, moved.
RgbImage blobs(int right, int down) {
    test::Random random(3);
    RgbImage picture(320, 240);
    for (int i = 0; i < 400; ++i) {
        const int x = random.integer(10, 300) + right;
        const int y = random.integer(10, 220) + down;
        const int size = random.integer(2, 6);
        const int grey = random.integer(60, 255);
        for (int v = y; v < y + size; ++v) {
            for (int u = x; u < x + size; ++u) {
                std::fill_n(picture.at(u, v), 3, static_cast<std::uint8_t>(grey));
            }
        }
    }
    return picture;
}

} // namespace

TEST(PictureMatches, SayWhereAThingIsInBoth) {
    const auto matches = pictureMatches(PictureFeatures(squares(1, 0, 0)), PictureFeatures(squares(1, 9, 4)));
    ASSERT_GT(matches.size(), 50U);
    const auto right = std::count_if(matches.begin(), matches.end(), [](const PictureMatch& match) {
        return (match.inB - match.inA - Eigen::Vector2d(9, 4)).norm() < 1;
    });
    EXPECT_GT(static_cast<double>(right), 0.9 * static_cast<double>(matches.size()));
}

TEST(PictureMatches, AreOnlyOfThingsWithinReach) {
    const PictureFeatures a(squares(1, 0, 0));
    const PictureFeatures b(squares(1, 9, 4));
    for (const PictureMatch& match : pictureMatches(a, b, 5)) {
        EXPECT_LE((match.inB - match.inA).norm(), 5.001);
    }
    EXPECT_GE(pictureMatches(a, b, 12).size(), pictureMatches(a, b).size());
}

TEST(PictureMatches, AreNoneWithoutTexture) {
    const PictureFeatures none(RgbImage(64, 64));
    EXPECT_TRUE(pictureMatches(none, PictureFeatures(squares(1, 0, 0)), 5).empty());
    EXPECT_TRUE(pictureMatches(none, none).empty());
}

TEST(ExactDisplacement, IsNothingForTheTrueDepth) {
    EXPECT_NEAR(quantile(exactDisplacements(kPlaneCamera, {}, {0.3, 0.1, 0}, plane(2), plane(2)), 1).value(),
                0, 1e-9);
}

TEST(ExactDisplacement, IsTheParallaxOfAWrongDepth) {
    // A camera at the origin, the photo 0.2 m to its right, a wall at 2 m that was taken to be at 4 m.
    const auto errors = exactDisplacements(kPlaneCamera, {}, {0.2, 0, 0}, plane(2), plane(4));
    const double expected = kPlaneCamera.intrinsics().fx * 0.2 * (1 / 2.0 - 1 / 4.0);
    EXPECT_NEAR(quantile(errors, 0.5).value(), expected, 0.1 * expected);
}

TEST(ExactDisplacement, OfAPhotoThatIsOnlyTurnedIsItsWholeParallax) {
    const auto errors = exactDisplacements(kPlaneCamera, {}, {0.2, 0, 0}, plane(2), {});
    const double expected = kPlaneCamera.intrinsics().fx * 0.2 / 2;
    EXPECT_NEAR(quantile(errors, 0.5).value(), expected, 0.15 * expected);
}

TEST(ExactDisplacement, LeavesOutWhereNoDepthIsKnown) {
    EXPECT_TRUE(exactDisplacements(kPlaneCamera, {}, {0.2, 0, 0}, plane(HUGE_VALF), plane(2)).empty());
}

TEST(MatchedDisplacement, FindsHowFarAPictureWasMoved) {
    const auto errors = matchedDisplacements(PictureFeatures(blobs(0, 0)), PictureFeatures(blobs(6, 3)));
    ASSERT_GT(errors.size(), 30U);
    EXPECT_NEAR(quantile(errors, 0.5).value(), std::hypot(6, 3), 0.3);
    EXPECT_NEAR(quantile(errors, 0.95).value(), std::hypot(6, 3), 1);
}

TEST(MatchedDisplacement, FindsNothingWithoutTexture) {
    const PictureFeatures even{RgbImage(64, 64)};
    const auto none = matchedDisplacements(even, even);
    EXPECT_TRUE(none.empty());
    EXPECT_FALSE(quantile(none, 0.5)); // not known, which is not 0
}

TEST(PlaceDisplacement, FindsAllPlacesOfAPictureThatWasMoved) {
    const PictureFeatures truth(blobs(0, 0));
    const PlaceDisplacements places = placeDisplacements(truth, PictureFeatures(blobs(6, 3)));
    EXPECT_LT(places.missedShare(), 0.02);
    EXPECT_NEAR(quantile(places.found, 0.5).value(), std::hypot(6, 3), 0.3);
    EXPECT_NEAR(quantile(places.found, 0.95).value(), std::hypot(6, 3), 1);
    EXPECT_GT(places.found.size(), matchedDisplacements(truth, PictureFeatures(blobs(6, 3))).size());
}

TEST(PlaceDisplacement, CountsWhatTheViewLacksAsMissed) {
    RgbImage half = blobs(0, 0);
    for (int y = 0; y < half.height(); ++y) {
        std::fill(half.at(0, y), half.at(half.width() / 2, y), std::uint8_t{0});
    }
    const PictureFeatures truth(blobs(0, 0));
    const PlaceDisplacements lacking = placeDisplacements(truth, PictureFeatures(half));
    EXPECT_NEAR(lacking.missedShare(), 0.5, 0.1);
    EXPECT_NEAR(quantile(lacking.found, 0.5).value(), 0, 0.01);
    const PlaceDisplacements other = placeDisplacements(truth, PictureFeatures(squares(9, 0, 0)));
    EXPECT_GT(other.missedShare(), 0.9) << "another room";
}

TEST(PlaceDisplacement, HasNoPlacesWithoutTexture) {
    const PictureFeatures even{RgbImage(64, 64)};
    EXPECT_EQ(placeDisplacements(even, even).missedShare(), 0);
    EXPECT_TRUE(placeDisplacements(even, even).found.empty());
    const PictureFeatures pixel{RgbImage(1, 1)};
    EXPECT_EQ(placeDisplacements(pixel, pixel).missed, 0U);
}

TEST(PictureMatches, KnowTheSizeOfTheirPicture) {
    const PictureFeatures features(RgbImage(64, 48));
    EXPECT_EQ(features.width(), 64);
    EXPECT_EQ(features.height(), 48);
}

TEST(PictureMatches, ALowerContrastGivesMoreFeatures) {
    RgbImage faint = squares(1, 0, 0);
    for (std::uint8_t& value : faint.values()) {
        value = static_cast<std::uint8_t>(100 + value / 12);
    }
    const auto count = [&](double contrast) {
        return pictureMatches(PictureFeatures(faint, contrast), PictureFeatures(faint, contrast)).size();
    };
    EXPECT_GT(count(0.01), count(PictureFeatures::kUsualContrast));
}

TEST(Displacements, OfPicturesOfDifferentSizesAreRefused) {
    test::expectError(ErrorKind::InvalidInput, "different sizes", [] {
        matchedDisplacements(PictureFeatures(RgbImage(64, 64)), PictureFeatures(RgbImage(64, 32)));
    });
    test::expectError(ErrorKind::InvalidInput, "different sizes", [] {
        placeDisplacements(PictureFeatures(RgbImage(64, 64)), PictureFeatures(RgbImage(64, 32)));
    });
    test::expectError(ErrorKind::InvalidInput, "different sizes", [] {
        exactDisplacements(kPlaneCamera, {}, {0, 0, 0}, DepthImage(8, 8), plane(2));
    });
    test::expectError(ErrorKind::InvalidInput, "different sizes", [] {
        exactDisplacements(kPlaneCamera, {}, {0, 0, 0}, plane(2), DepthImage(8, 8));
    });
}

TEST(Displacements, AreTakenAtEveryNthPixelOfEveryNthRow) {
    const auto at = [](int every) {
        return exactDisplacements(kPlaneCamera, {}, {0.01, 0, 0}, plane(2), plane(2.1F), every);
    };
    EXPECT_EQ(at(10).size(), 32U * 24U);
    EXPECT_EQ(at(7).size(), 46U * 35U);
    for (const Displacement& displacement : at(40)) {
        EXPECT_EQ(std::fmod(displacement.pixel.x(), 40), 0);
        EXPECT_EQ(std::fmod(displacement.pixel.y(), 40), 0);
    }
}

TEST(Displacements, QuantileIsReachedByTheShare) {
    std::vector<Displacement> displacements;
    for (int i = 100; i > 0; --i) {
        displacements.push_back({{0, 0}, static_cast<double>(i)});
    }
    EXPECT_EQ(quantile(displacements, 0), 1);
    EXPECT_EQ(quantile(displacements, 1), 100);
    EXPECT_NEAR(quantile(displacements, 0.95).value(), 95, 1);
}

} // namespace spherewalk::compare
