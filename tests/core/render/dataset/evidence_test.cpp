// SPDX-License-Identifier: Apache-2.0
#include "dataset/evidence.h"
#include "each_target.h"
#include "layers/shown_errors.h"
#include "random.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

DepthMap noise(int width, test::Random& random) {
    Image<float, 1> inverse(width, width / 2);
    MaskImage sure(width, width / 2);
    for (std::size_t i = 0; i < inverse.values().size(); ++i) {
        inverse.values()[i] = static_cast<float>(random.uniform(0, 21));
        sure.values()[i] = random.integer(0, 12) != 0 ? 255 : 0;
    }
    return DepthMap(std::move(inverse), std::move(sure));
}

/// What the map's pixels say in a direction, looked at one by one.
KnownDepth expected(const DepthMap& map, const Vector3d& direction) {
    const int side = std::max(1, map.width() / 512);
    const EquirectSize size{map.width() / side, map.height() / side};
    const Eigen::Vector2d at = pixel(size, direction);
    const int x = (static_cast<int>(std::lround(at.x())) + size.width) % size.width;
    const int y = std::clamp(static_cast<int>(std::lround(at.y())), 0, size.height - 1);
    KnownDepth known{*map.inverseM().at(x * side + side / 2, y * side + side / 2), 0,
                     *map.sure().at(x * side + side / 2, y * side + side / 2) != 0, true};
    double least = HUGE_VAL;
    double greatest = 0;
    for (int row = -2; row <= 2; ++row) {
        for (int column = -2; column <= 2; ++column) {
            const int left = (x + column + size.width) % size.width * side;
            const int top = std::clamp(y + row, 0, size.height - 1) * side;
            for (int i = 0; i < side * side; ++i) {
                const double value = *map.inverseM().at(left + i % side, top + i / side);
                least = std::min(least, value);
                greatest = std::max(greatest, value);
                const bool isNear = std::abs(row) <= 1 && std::abs(column) <= 1;
                known.isAmongSure &= !isNear || *map.sure().at(left + i % side, top + i / side) != 0;
            }
        }
    }
    known.spreadM = greatest - least;
    return known;
}

} // namespace

TEST(DepthEvidence, SaysWhatTheMapsPixelsSay) {
    test::Random random(91);
    SCOPED_TRACE(random.seed());
    for (const int width : {16, 64, 1024, 1536}) {
        const DepthMap map = noise(width, random);
        const DepthEvidence evidence{DepthSteps(map)};
        constexpr std::size_t kCount = 300;
        Directions directions(kCount);
        std::vector<Vector3d> given;
        const Eigen::Quaterniond turn = random.rotation();
        for (std::size_t i = 0; i < kCount; ++i) {
            given.push_back(random.uniform(0.01, 100) * random.direction());
            directions.set(i, turn * given.back());
        }
        test::forEachTarget([&](const char* target) {
            std::vector<KnownDepth> known(kCount);
            look(evidence, turn.conjugate().toRotationMatrix(), directions, known);
            for (std::size_t i = 0; i < kCount; ++i) {
                const KnownDepth right = expected(map, given[i]);
                ASSERT_NEAR(known[i].inverseM, right.inverseM, 1e-5) << target << " " << width << " " << i;
                ASSERT_NEAR(known[i].spreadM, right.spreadM, 1e-5) << target << " " << width << " " << i;
                ASSERT_EQ(known[i].isSure, right.isSure) << target << " " << width << " " << i;
                ASSERT_EQ(known[i].isAmongSure, right.isAmongSure) << target << " " << width << " " << i;
            }
        });
    }
}

TEST(DepthEvidence, TakesDirectionsThatAreNoNumbers) {
    test::Random random(92);
    const DepthEvidence evidence{DepthSteps(noise(64, random))};
    Directions directions(1);
    directions.set(0, Vector3d::Constant(NAN));
    std::vector<KnownDepth> known(1);
    look(evidence, Eigen::Matrix3d::Identity(), directions, known);
    EXPECT_GT(known[0].inverseM, 0);
}

TEST(DepthSteps, AreThoseOfTheMapAndOfItsFile) {
    test::Random random(93);
    const DepthMap map = noise(64, random);
    const DepthSteps ofMap(map);
    const DepthSteps ofFile = DepthSteps::parse(map.serialised(), "d.pgm");
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            EXPECT_EQ(ofMap.row(y)[x], ofFile.row(y)[x]);
            EXPECT_EQ(DepthSteps::inverseM(ofMap.row(y)[x]), *map.inverseM().at(x, y));
            EXPECT_EQ(DepthSteps::isSure(ofMap.row(y)[x]), *map.sure().at(x, y) != 0);
        }
    }
    EXPECT_EQ(DepthMap(ofFile).inverseM(), map.inverseM());
    EXPECT_EQ(DepthMap(ofFile).sure(), map.sure());
}

TEST(DepthSteps, OfAFileWithZerosAreTheLeast) {
    test::Random random(94);
    Bytes bytes = noise(16, random).serialised();
    std::fill(bytes.end() - 4, bytes.end(), Bytes::value_type{});
    bytes.back() = Bytes::value_type{1};
    const DepthMap map = DepthMap::parse(bytes, "d.pgm");
    EXPECT_EQ(*map.inverseM().at(14, 7), static_cast<float>(DepthMap::kStepPerM));
    EXPECT_EQ(*map.inverseM().at(15, 7), static_cast<float>(DepthMap::kStepPerM));
    EXPECT_EQ(*map.sure().at(14, 7), 0);
    EXPECT_EQ(*map.sure().at(15, 7), 255);
}

} // namespace spherewalk::render
