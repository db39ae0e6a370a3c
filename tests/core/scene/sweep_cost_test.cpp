// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "sweep_cost.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::scene {

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 32;
constexpr int kDistances = 16;

using Costs = CostVolume<std::uint8_t>;
using Sums = CostVolume<std::int16_t>;

RgbImage evenPicture() {
    RgbImage picture(kWidth, kHeight);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{100});
    return picture;
}

RgbImage randomPicture(test::Random& random) {
    RgbImage picture(2 * kWidth, kWidth);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

Costs randomCosts(test::Random& random) {
    Costs costs(kWidth, kHeight, kDistances);
    for (std::uint8_t& cost : costs.values) {
        cost = static_cast<std::uint8_t>(random.integer(0, 170));
    }
    return costs;
}

/// The volume with pixel (x, y) taken from where the place function says.
template <class Value>
CostVolume<Value> rearranged(const CostVolume<Value>& volume, auto place) {
    CostVolume<Value> result(kWidth, kHeight, kDistances);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto [fromX, fromY] = place(x, y);
            std::copy_n(volume.at(fromX, fromY), kDistances, result.at(x, y));
        }
    }
    return result;
}

Sums aggregated(const Costs& costs, int threads = 2) {
    const RgbImage even = evenPicture();
    const SweepPicture guide(even, Eigen::Matrix3d::Identity(), kWidth, 1);
    return aggregatedOverPaths(costs, guide, {}, threads, {});
}

std::ptrdiff_t best(const Sums& sums, int x, int y) {
    return std::min_element(sums.at(x, y), sums.at(x, y) + kDistances) - sums.at(x, y);
}

/// Whether aggregation and this rearrangement may change places.
void expectSymmetric(auto place) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        const Costs costs = randomCosts(random);
        EXPECT_EQ(aggregated(rearranged(costs, place)).values, rearranged(aggregated(costs), place).values)
            << "seed " << seed;
    }
}

} // namespace

TEST(PathAggregation, IsSymmetricUnderMirroring) {
    expectSymmetric([](int x, int y) { return std::pair(kWidth - 1 - x, y); });
    expectSymmetric([](int x, int y) { return std::pair(x, kHeight - 1 - y); });
}

TEST(PathAggregation, IsTheSameForAnyNumberOfThreads) {
    test::Random random(4);
    const Costs costs = randomCosts(random);
    EXPECT_EQ(aggregated(costs, 1).values, aggregated(costs, 3).values);
}

TEST(PathAggregation, LeavesTheBestDistanceWhereAllPixelsAgree) {
    test::Random random(5);
    Costs costs(kWidth, kHeight, kDistances);
    std::vector<std::uint8_t> one(kDistances);
    std::ranges::generate(one, [&] { return static_cast<std::uint8_t>(random.integer(20, 170)); });
    one[5] = 3;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        std::ranges::copy(one, costs.values.begin() + i * kDistances);
    }
    const Sums sums = aggregated(costs);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            ASSERT_EQ(best(sums, x, y), 5) << x << ", " << y;
        }
    }
}

TEST(PathAggregation, DrawsAPixelThatSaysLittleToItsNeighbours) {
    Costs costs(kWidth, kHeight, kDistances);
    std::ranges::fill(costs.values, std::uint8_t{100});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            costs.at(x, y)[7] = 10;
        }
    }
    for (const auto& [x, y] : {std::pair(0, 16), {30, 10}, {63, 20}}) { // at the seam too
        std::fill_n(costs.at(x, y), kDistances, std::uint8_t{50});
        costs.at(x, y)[12] = 40;
        EXPECT_EQ(best(aggregated(costs), x, y), 7) << x << ", " << y;
    }
}

TEST(PathAggregation, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const RgbImage even = evenPicture();
    const SweepPicture guide(even, Eigen::Matrix3d::Identity(), kWidth, 1);
    test::expectError(ErrorKind::Stopped, "", [&] {
        aggregatedOverPaths(Costs(kWidth, kHeight, kDistances), guide, {}, 2, stop.get_token());
    });
}

TEST(SweepPicture, HasNoSlopesWhereThePictureIsEven) {
    test::Random random(6);
    const RgbImage even = evenPicture();
    const SweepPicture picture(even, random.rotation().toRotationMatrix(), kWidth, 2);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            ASSERT_NEAR(picture.brightness(x, y), 100, 1e-3);
            for (int value = 1; value < 4; ++value) {
                ASSERT_NEAR(picture.at(x, y)[value], 0, 1e-3);
            }
        }
    }
}

TEST(SweepPicture, RepeatsItsFirstColumnAndItsLastRow) {
    test::Random random(7);
    const RgbImage photo = randomPicture(random);
    const SweepPicture picture(photo, Eigen::Matrix3d::Identity(), kWidth, 2);
    for (int y = 0; y < kHeight; ++y) {
        EXPECT_TRUE(std::equal(picture.at(0, y), picture.at(0, y) + 4, picture.at(kWidth, y))) << y;
    }
    EXPECT_TRUE(std::equal(picture.at(0, kHeight - 1), picture.at(0, kHeight - 1) + picture.stride(),
                           picture.at(0, kHeight)));
}

TEST(SweepCost, IsNothingForAPhotoOfTheSamePlaceAtAnyDistance) {
    test::Random random(8);
    const RgbImage photo = randomPicture(random);
    const std::vector<PosedPicture> same{{&photo, {}}};
    const SweepCost cost({&photo, {}}, same, 1, kWidth, 2);
    for (const float inverseM : {0.01F, 0.3F, 2.0F}) {
        Image<float, 1> costs(kWidth, kHeight);
        Image<float, 1> inverse(kWidth, kHeight);
        std::ranges::fill(inverse.values(), inverseM);
        cost.all({&inverse, 1}, 2, {}, {&costs, 1});
        // Directions are known to a thousandth of a pixel, where neighbouring pixels differ by 255.
        EXPECT_LT(*std::ranges::max_element(costs.values()), 2) << inverseM;
    }
}

TEST(SweepCost, LiesBetweenNothingAndItsBound) {
    test::Random random(9);
    const RgbImage photo = randomPicture(random);
    const RgbImage other = randomPicture(random);
    const std::vector<PosedPicture> neighbours{{&other, {random.rotation(), {0.2, 0.1, 0}}},
                                               {&photo, {random.rotation(), {0, 0.3, 0.1}}}};
    const SweepCost cost({&photo, {}}, neighbours, 0.5, kWidth, 2);
    Image<float, 1> costs(kWidth, kHeight);
    Image<float, 1> inverse(kWidth, kHeight);
    std::ranges::generate(inverse.values(), [&] { return static_cast<float>(random.uniform(0.05, 3)); });
    cost.all({&inverse, 1}, 2, {}, {&costs, 1});
    EXPECT_GE(*std::ranges::min_element(costs.values()), 0);
    EXPECT_LE(*std::ranges::max_element(costs.values()), SweepCost::kMost);
}

TEST(SweepCost, OfSeveralDistancesAtATimeIsThatOfEachByItself) {
    test::Random random(10);
    const RgbImage photo = randomPicture(random);
    const RgbImage other = randomPicture(random);
    for (const double aheadM : {0.0, 0.01}) {
        const std::vector<PosedPicture> neighbours{{&other, {random.rotation(), {0.2, 0.1, 0}}, {aheadM}},
                                                   {&photo, {random.rotation(), {0, 0.3, 0.1}}, {aheadM}}};
        const SweepCost cost({&photo, {}, {aheadM}}, neighbours, 0.5, kWidth, 1);
        std::vector<Image<float, 1>> inverse(3, Image<float, 1>(kWidth, kHeight));
        std::vector<Image<float, 1>> costs = inverse;
        for (Image<float, 1>& plane : inverse) {
            std::ranges::generate(plane.values(),
                                  [&] { return static_cast<float>(random.uniform(0.05, 3)); });
        }
        cost.all(inverse, 2, {}, costs);
        for (std::size_t k = 0; k < inverse.size(); ++k) {
            Image<float, 1> alone(kWidth, kHeight);
            cost.all({&inverse[k], 1}, 1, {}, {&alone, 1});
            EXPECT_EQ(costs[k], alone) << k;
        }
        SweepCost::Scratch scratch(cost, 8);
        std::vector<float> part(8);
        cost.at({5, 24, 32}, 1, inverse[0].at(24, 5), SweepCost::Order::Any, scratch, part.data());
        EXPECT_TRUE(std::equal(part.begin(), part.end(), costs[0].at(24, 5)));
    }
}

/// Waves 26 pixels long, of a picture of 512.
RgbImage wavyPicture() {
    RgbImage picture(1024, 512);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector3d ray = direction({1024, 512}, Eigen::Vector2d(x, y));
            const double wave =
                std::sin(20 * ray.x()) + std::sin(20 * ray.y() + 1) + std::sin(20 * ray.z() + 2);
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(128 + 40 * wave));
        }
    }
    return picture;
}

// With a step of 0.3 of the neighbours' distance from nearly endless: the poles and both baselines' ends
// among all pixels.
TEST(SweepCost, OfDistancesAPixelApartIsThatOfExactPlaces) {
    constexpr int kSize = 512;
    constexpr int kLayers = 33;
    constexpr int kAtATime = 64;
    test::Random random(12);
    const RgbImage photo = wavyPicture();
    const std::vector<PosedPicture> neighbours{{&photo, {random.rotation(), {0.5, 0.1, 0}}},
                                               {&photo, {random.rotation(), {0, 0.1, 0.5}}}};
    const SweepCost cost({&photo, {}}, neighbours, 1, kSize, 1);
    SweepCost::Scratch scratch(cost, kLayers * kAtATime);
    std::vector<float> inverse;
    for (int layer = 0; layer < kLayers; ++layer) {
        inverse.insert(inverse.end(), kAtATime, 1e-3F + 0.024F * static_cast<float>(layer));
    }
    std::vector<float> exact(inverse.size());
    std::vector<float> found(inverse.size());
    float worst = 0;
    for (int y = 0; y < kSize / 2; ++y) {
        for (int x = 0; x < kSize; x += kAtATime) {
            const SweepCost::RowPart part{y, x, x + kAtATime};
            cost.at(part, kLayers, inverse.data(), SweepCost::Order::Any, scratch, exact.data());
            cost.at(part, kLayers, inverse.data(), SweepCost::Order::BySteps, scratch, found.data());
            for (std::size_t i = 0; i < found.size(); ++i) {
                worst = std::max(worst, std::fabs(found[i] - exact[i]));
            }
        }
    }
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, 0.3F); // grey levels, of up to 68.8
}

TEST(SweepCost, IsTheSumOfWhatDiffersUpToALimit) {
    test::Random random(11);
    const RgbImage photo = randomPicture(random);
    const RgbImage other = randomPicture(random);
    const Eigen::Vector3d offset(0.2, 0.1, -0.1);
    const std::vector<PosedPicture> neighbours{{&other, {Eigen::Quaterniond::Identity(), offset}}};
    const SweepCost cost({&photo, {}}, neighbours, 1, kWidth, 1);
    const SweepPicture own(photo, Eigen::Matrix3d::Identity(), kWidth, 1);
    const SweepPicture its(other, Eigen::Matrix3d::Identity(), kWidth, 1);
    Image<float, 1> inverse(kWidth, kHeight);
    Image<float, 1> costs(kWidth, kHeight);
    std::ranges::generate(inverse.values(), [&] { return static_cast<float>(random.uniform(0.05, 3)); });
    cost.all({&inverse, 1}, 1, {}, {&costs, 1});
    constexpr EquirectSize kSize{kWidth, kHeight};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Eigen::Vector3d way = direction(kSize, Eigen::Vector2d(x, y));
            const Eigen::Vector2d at = pixel(kSize, way - static_cast<double>(*inverse.at(x, y)) * offset);
            const double u = at.x() < 0 ? at.x() + kWidth : at.x();
            const double v = std::max(0.0, at.y());
            const int left = std::min(static_cast<int>(u), kWidth - 1);
            const int above = std::min(static_cast<int>(v), kHeight - 1);
            double sum = 0;
            for (int c = 0; c < 4; ++c) {
                const auto value = [&](int i, int j) { return static_cast<double>(its.at(i, j)[c]); };
                const double over = std::lerp(value(left, above), value(left + 1, above), u - left);
                const double under = std::lerp(value(left, above + 1), value(left + 1, above + 1), u - left);
                constexpr double kLimits[] = {20, 12, 12, 16};
                constexpr double kWeights[] = {1, 1.5, 1.5, 0.8};
                const double difference = std::abs(own.at(x, y)[c] - std::lerp(over, under, v - above));
                sum += kWeights[c] * std::min(kLimits[c], difference);
            }
            ASSERT_NEAR(*costs.at(x, y), sum, 0.05)
                << x << ", " << y; // 1e-4 pixels, where pixels differ by 255
        }
    }
}

TEST(PictureSizes, AreHalvesOfEachOther) {
    const PictureSizes sizes(RgbImage(1000, 500));
    EXPECT_EQ(sizes.largest().width(), 1000);
    EXPECT_EQ(sizes.atLeast(2000).width(), 1000);
    EXPECT_EQ(sizes.atLeast(501).width(), 1000);
    EXPECT_EQ(sizes.atLeast(500).width(), 500);
    EXPECT_EQ(sizes.atLeast(64).width(), 125);
    EXPECT_EQ(sizes.atLeast(64).height(), 62);
    EXPECT_EQ(PictureSizes(RgbImage(16, 8)).atLeast(64).width(), 16);
}

} // namespace spherewalk::scene
