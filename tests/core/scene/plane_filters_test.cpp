// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"
#include "random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::scene {

namespace {

constexpr int kColumns = 96;
constexpr int kRows = 48;

Plane planeOf(auto value) {
    Plane plane(kColumns, kRows);
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            *plane.at(x, y) = static_cast<float>(value(x, y));
        }
    }
    return plane;
}

Plane randomPlane(test::Random& random) {
    return planeOf([&](int, int) { return random.uniform(0.1, 1); });
}

/// The plane as seen after a turn about the vertical.
Plane turnedBy(const Plane& plane, int columns) {
    return planeOf([&](int x, int y) { return *plane.at((x + columns) % kColumns, y); });
}

Plane scaledBy(const Plane& plane, float factor) {
    return planeOf([&](int x, int y) { return factor * *plane.at(x, y); });
}

/// The largest difference between two planes.
float apart(const Plane& a, const Plane& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        most = std::max(most, std::abs(a.values()[i] - b.values()[i]));
    }
    return most;
}

Plane blurred(Plane plane, int radius, int threads = 2) {
    blur(plane, radius, threads);
    return plane;
}

Plane filtered(const GuidedFilter& filter, Plane plane) {
    filter.apply(plane);
    return plane;
}

} // namespace

TEST(Blur, KeepsConstants) {
    const Plane plane = planeOf([](int, int) { return 0.3; });
    EXPECT_LT(apart(blurred(plane, 5), plane), 1e-6F);
}

TEST(Blur, IsTheMeanOfASquareOfPixels) {
    test::Random random(2);
    const Plane plane = randomPlane(random);
    const Plane result = blurred(plane, 2);
    for (const auto& [column, row] : {std::pair(0, 0), {1, 47}, {50, 20}, {95, 30}}) {
        double sum = 0;
        for (int j = -2; j <= 2; ++j) {
            for (int i = -2; i <= 2; ++i) {
                sum += static_cast<double>(
                    *plane.at((column + i + kColumns) % kColumns, std::clamp(row + j, 0, kRows - 1)));
            }
        }
        EXPECT_NEAR(*result.at(column, row), sum / 25, 1e-5) << column << ", " << row;
    }
}

TEST(Blur, KnowsNoSeam) {
    test::Random random(3);
    const Plane plane = randomPlane(random);
    EXPECT_LT(apart(blurred(turnedBy(plane, 37), 4), turnedBy(blurred(plane, 4), 37)), 1e-5F);
}

TEST(GuidedFilter, KeepsConstantsWhateverTheGuide) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        const Plane plane = planeOf([](int, int) { return 0.7; });
        const GuidedFilter filter(randomPlane(random), 4, 1e-3F, 2);
        EXPECT_LT(apart(filtered(filter, plane), plane), 2e-4F) << "seed " << seed;
    }
}

TEST(GuidedFilter, BlursTwiceWhereTheGuideIsEven) {
    test::Random random(6);
    const Plane plane = randomPlane(random);
    const GuidedFilter filter(planeOf([](int, int) { return 0.5; }), 3, 1e-3F, 2);
    EXPECT_LT(apart(filtered(filter, plane), blurred(blurred(plane, 3), 3)), 1e-3F);
}

TEST(GuidedFilter, KeepsTheEdgesOfItsGuide) {
    const Plane edge = planeOf([](int x, int) { return x >= 20 && x < 70 ? 1 : 0; });
    const GuidedFilter filter(edge, 4, 1e-3F, 2);
    test::Random random(7);
    Plane noisy = edge;
    for (float& value : noisy.values()) {
        value += static_cast<float>(random.normal(0.05));
    }
    const Plane result = filtered(filter, noisy);
    for (int y = 8; y < kRows - 8; ++y) {
        EXPECT_LT(*result.at(19, y), 0.1F);
        EXPECT_GT(*result.at(20, y), 0.9F);
    }
    EXPECT_LT(apart(result, edge), apart(noisy, edge));
}

TEST(GuidedFilter, IsLinear) {
    test::Random random(8);
    const Plane plane = randomPlane(random);
    const GuidedFilter filter(randomPlane(random), 4, 1e-2F, 2);
    EXPECT_LT(apart(filtered(filter, scaledBy(plane, 3)), scaledBy(filtered(filter, plane), 3)), 1e-4F);
}

TEST(GuidedFilter, IsTheSameForAnyNumberOfThreads) {
    test::Random random(9);
    const Plane guide = randomPlane(random);
    const Plane plane = randomPlane(random);
    EXPECT_EQ(filtered(GuidedFilter(guide, 4, 1e-3F, 1), plane),
              filtered(GuidedFilter(guide, 4, 1e-3F, 3), plane));
}

TEST(MedianFilter, GivesTheMiddleOfNineValues) {
    test::Random random(10);
    const Plane plane = randomPlane(random);
    const Plane result = median3x3(plane, 2);
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            int below = 0;
            int above = 0;
            for (int i = 0; i < 9; ++i) {
                const float value =
                    *plane.at((x + i % 3 - 1 + kColumns) % kColumns, std::clamp(y + i / 3 - 1, 0, kRows - 1));
                below += value < *result.at(x, y) ? 1 : 0;
                above += value > *result.at(x, y) ? 1 : 0;
            }
            ASSERT_LE(std::max(below, above), 4) << x << ", " << y;
        }
    }
}

TEST(MedianFilter, FollowsAnyChangeOfScaleThatKeepsTheOrder) {
    test::Random random(11);
    const Plane plane = randomPlane(random);
    const auto squared = [](const Plane& of) {
        return planeOf([&](int x, int y) { return *of.at(x, y) * *of.at(x, y); });
    };
    EXPECT_EQ(median3x3(squared(plane), 2), squared(median3x3(plane, 2)));
}

TEST(MedianFilter, TakesOutASinglePixel) {
    const Plane even = planeOf([](int, int) { return 0.5; });
    Plane plane = even;
    *plane.at(0, 10) = 9;
    EXPECT_EQ(median3x3(plane, 2), even);
}

TEST(CrossFilter, GivesTheLeastAndTheMostOfFiveValuesAcrossTheSeam) {
    test::Random random(13);
    const Plane plane = randomPlane(random);
    for (const int reach : {1, 2, 16, kColumns / 2}) {
        const Plane least = leastOfCross(plane, reach, 2);
        const Plane most = mostOfCross(plane, reach, 2);
        for (int y = 0; y < kRows; ++y) {
            for (int x = 0; x < kColumns; ++x) {
                const auto five = {*plane.at(x, y), *plane.at((x + reach) % kColumns, y),
                                   *plane.at((x + kColumns - reach) % kColumns, y),
                                   *plane.at(x, std::max(0, y - reach)),
                                   *plane.at(x, std::min(kRows - 1, y + reach))};
                ASSERT_EQ(*least.at(x, y), std::min(five)) << reach << ": " << x << ", " << y;
                ASSERT_EQ(*most.at(x, y), std::max(five)) << reach << ": " << x << ", " << y;
            }
        }
    }
}

TEST(PlaneSmoothing, LeavesFlatSurfaces) {
    test::Random random(12);
    for (int example = 0; example < 10; ++example) {
        const double across = random.uniform(-1e-3, 1e-3);
        const double down = random.uniform(-1e-3, 1e-3);
        const Plane plane = planeOf([&](int x, int y) { return 0.5 + across * (x - 48) + down * y; });
        const Plane result = smoothedSurfaces(plane, 2);
        for (int y = 4; y < kRows - 4; ++y) {
            for (int x = 4; x < kColumns - 4; ++x) { // the seam is a step
                ASSERT_NEAR(*result.at(x, y), *plane.at(x, y), 2e-5F) << x << ", " << y;
            }
        }
    }
}

TEST(PlaneSmoothing, TakesNoiseOutOfASurface) {
    test::Random random(13);
    const Plane flat = planeOf([](int, int) { return 0.5; });
    Plane noisy = flat;
    for (float& value : noisy.values()) {
        value *= 1 + static_cast<float>(random.uniform(-0.004, 0.004));
    }
    const auto spread = [&](const Plane& plane) {
        double sum = 0;
        for (const float value : plane.values()) {
            sum += std::pow(static_cast<double>(value) - 0.5, 2);
        }
        return std::sqrt(sum);
    };
    EXPECT_LT(spread(smoothedSurfaces(noisy, 2)), 0.4 * spread(noisy));
}

TEST(PlaneSmoothing, NeverMixesTwoSurfaces) {
    const Plane step = planeOf([](int x, int) { return x >= 30 && x < 60 ? 0.8 : 0.4; });
    EXPECT_LT(apart(smoothedSurfaces(step, 2), step), 1e-6F);
}

TEST(PlaneSmoothing, IsTheSameAtAnyScaleAndTurn) {
    test::Random random(14);
    const Plane plane =
        planeOf([&](int x, int) { return (x < 40 ? 0.5 : 0.7) * random.uniform(0.99, 1.01); });
    const Plane result = smoothedSurfaces(plane, 2);
    EXPECT_EQ(smoothedSurfaces(scaledBy(plane, 4), 3), scaledBy(result, 4)); // a power of two: every bit
    EXPECT_EQ(smoothedSurfaces(turnedBy(plane, 51), 1), turnedBy(result, 51));
}

TEST(EvenedBorders, LoseTheirTeethWhereNothingIsSure) {
    constexpr int kWidth = 64;
    Plane wall(kWidth, 32);
    for (int y = 0; y < wall.height(); ++y) {
        for (int x = 0; x < kWidth; ++x) {
            *wall.at(x, y) = x < 20 + (y % 5 == 0 ? 2 : 0) ? 1.0F : 0.25F; // a tooth in each fifth row
        }
    }
    const MaskImage unsure(kWidth, wall.height());
    const Plane even = evenedBorders(wall, unsure, 2);
    EXPECT_EQ(even, evenedBorders(wall, unsure, 1));
    for (int y = 4; y < wall.height() - 4; ++y) {
        EXPECT_EQ(*even.at(19, y), 1) << y;
        EXPECT_EQ(*even.at(20, y), 0.25F) << y;
        EXPECT_EQ(*even.at(0, y), 1) << y; // the other border lies on the seam
        EXPECT_EQ(*even.at(kWidth - 1, y), 0.25F) << y;
    }
    MaskImage sure = unsure;
    std::fill(sure.values().begin(), sure.values().end(), std::uint8_t{255});
    EXPECT_EQ(evenedBorders(wall, sure, 1), wall);
}

TEST(EvenedBorders, AreThoseOfJumpsAlone) {
    Plane slant(64, 32);
    for (int y = 0; y < slant.height(); ++y) {
        for (int x = 0; x < slant.width(); ++x) {
            *slant.at(x, y) = 0.5F + 0.005F * static_cast<float>(std::abs(x - 32)) + (x == 9 ? 0.004F : 0);
        }
    }
    EXPECT_EQ(evenedBorders(slant, MaskImage(64, 32), 1), slant);
}

} // namespace spherewalk::scene
