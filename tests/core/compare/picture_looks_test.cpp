// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/compare/picture_looks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::compare {

namespace {

RgbImage evenPicture(int width, int height, std::uint8_t grey) {
    RgbImage picture(width, height);
    std::ranges::fill(picture.values(), grey);
    return picture;
}

/// Bright squares on dark grey, moved to the right.
RgbImage brightSquares(int right) {
    RgbImage picture = evenPicture(240, 180, 40);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column) {
            for (int y = 15 + 40 * row; y < 35 + 40 * row; ++y) {
                for (int x = 15 + 40 * column + right; x < 35 + 40 * column + right; ++x) {
                    std::fill_n(picture.at(x, y), 3, std::uint8_t{200});
                }
            }
        }
    }
    return picture;
}

RgbImage noise(int width, int height, unsigned seed) {
    test::Random random(seed);
    RgbImage picture(width, height);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

/// 0 in the left half.
MaskImage rightHalf(const RgbImage& picture) {
    MaskImage mask(picture.width(), picture.height());
    for (int y = 0; y < mask.height(); ++y) {
        std::fill(mask.at(mask.width() / 2, y), mask.at(mask.width() / 2, y) + mask.width() / 2,
                  std::uint8_t{255});
    }
    return mask;
}

/// `left` in the left half, `right` in the right one.
RgbImage halves(const RgbImage& left, const RgbImage& right) {
    RgbImage picture = left;
    for (int y = 0; y < picture.height(); ++y) {
        std::copy(right.at(right.width() / 2, y), right.row(y).data() + right.row(y).size(),
                  picture.at(picture.width() / 2, y));
    }
    return picture;
}

} // namespace

TEST(StructuralSimilarity, IsOneForEqualPicturesAndLessForOthers) {
    const RgbImage a = noise(64, 48, 1);
    EXPECT_NEAR(structuralSimilarity(a, a).value(), 1, 1e-6);
    EXPECT_LT(structuralSimilarity(a, noise(64, 48, 2)).value(), 0.2);
}

TEST(StructuralSimilarity, FollowsItsFormulaForEvenPictures) {
    const double c1 = 0.01 * 255 * 0.01 * 255;
    EXPECT_NEAR(structuralSimilarity(evenPicture(20, 20, 100), evenPicture(20, 20, 200)).value(),
                (2 * 100 * 200 + c1) / (100 * 100 + 200 * 200 + c1), 1e-4);
}

TEST(StructuralSimilarity, FallsAsAPictureIsMovedFarther) {
    const RgbImage truth = brightSquares(0);
    const double one = structuralSimilarity(truth, brightSquares(1)).value();
    const double five = structuralSimilarity(truth, brightSquares(5)).value();
    EXPECT_LT(one, 0.99);
    EXPECT_LT(five, one - 0.05);
}

TEST(StructuralSimilarity, LooksAtValidPixelsAlone) {
    const RgbImage truth = noise(64, 48, 1);
    const RgbImage wrongLeft = halves(noise(64, 48, 2), truth);
    EXPECT_LT(structuralSimilarity(truth, wrongLeft).value(), 0.7);
    EXPECT_NEAR(structuralSimilarity(truth, wrongLeft, rightHalf(truth)).value(), 1, 1e-6);
    EXPECT_FALSE(structuralSimilarity(truth, truth, MaskImage(64, 48)));
}

TEST(StructuralSimilarity, TakesPicturesOfOnePixelAndRefusesOtherSizes) {
    EXPECT_NEAR(structuralSimilarity(evenPicture(1, 1, 9), evenPicture(1, 1, 9)).value(), 1, 1e-6);
    const RgbImage a = noise(64, 48, 1);
    test::expectError(ErrorKind::InvalidInput, "one size",
                      [&] { structuralSimilarity(a, noise(48, 64, 1)); });
    test::expectError(ErrorKind::InvalidInput, "one size", [] { structuralSimilarity({}, {}); });
    test::expectError(ErrorKind::InvalidInput, "mask of 3 x 3",
                      [&] { structuralSimilarity(a, a, MaskImage(3, 3)); });
}

TEST(EdgeAgreement, FindsNothingFalseOrMissedInEqualPictures) {
    const EdgeAgreement same = edgeAgreement(brightSquares(0), brightSquares(0));
    EXPECT_EQ(same.falseShare, 0);
    EXPECT_EQ(same.missedShare, 0);
    EXPECT_GT(same.truthEdges, 1000U);
    EXPECT_EQ(same.viewEdges, same.truthEdges);
}

TEST(EdgeAgreement, ForgivesTwoPixelsAndNotFive) {
    const EdgeAgreement two = edgeAgreement(brightSquares(0), brightSquares(2));
    EXPECT_EQ(two.falseShare, 0);
    EXPECT_EQ(two.missedShare, 0);
    const EdgeAgreement five = edgeAgreement(brightSquares(0), brightSquares(5));
    EXPECT_GT(five.falseShare, 0.3); // the upright sides; the level ones lie on themselves
    EXPECT_GT(five.missedShare, 0.3);
}

TEST(EdgeAgreement, TellsFalseEdgesFromMissedOnes) {
    const RgbImage even = evenPicture(240, 180, 40);
    const EdgeAgreement invented = edgeAgreement(even, brightSquares(0));
    EXPECT_EQ(invented.falseShare, 1);
    EXPECT_EQ(invented.missedShare, 0);
    EXPECT_EQ(invented.truthEdges, 0U);
    const EdgeAgreement lost = edgeAgreement(brightSquares(0), even);
    EXPECT_EQ(lost.falseShare, 0);
    EXPECT_EQ(lost.missedShare, 1);
}

TEST(EdgeAgreement, CountsValidPixelsAlone) {
    const RgbImage truth = brightSquares(0);
    const RgbImage wrongLeft = halves(evenPicture(240, 180, 40), truth);
    EXPECT_GT(edgeAgreement(truth, wrongLeft).missedShare, 0.4);
    const EdgeAgreement right = edgeAgreement(truth, wrongLeft, rightHalf(truth));
    EXPECT_EQ(right.missedShare, 0);
    EXPECT_EQ(right.falseShare, 0) << "the border between both halves";
    EXPECT_GT(right.truthEdges, 300U);
}

TEST(EdgeAgreement, HasNoEdgesInEvenPicturesAndSinglePixels) {
    for (const int side : {1, 2, 50}) {
        const EdgeAgreement none = edgeAgreement(evenPicture(side, side, 7), evenPicture(side, side, 250));
        EXPECT_EQ(none.falseShare, 0);
        EXPECT_EQ(none.missedShare, 0);
        EXPECT_EQ(none.viewEdges + none.truthEdges, 0U);
    }
    test::expectError(ErrorKind::InvalidInput, "one size",
                      [] { edgeAgreement(evenPicture(3, 3, 0), evenPicture(3, 4, 0)); });
}

} // namespace spherewalk::compare
