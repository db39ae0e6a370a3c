// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"

#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

Bytes depthFile(int width) {
    Image<float, 1> inverse(width, width / 2);
    for (std::size_t i = 0; i < inverse.values().size(); ++i) {
        inverse.values()[i] = 0.01F + 0.001F * static_cast<float>(i % 900);
    }
    return DepthMap(std::move(inverse)).serialised();
}

/// The file with the first occurrence of a text replaced by another.
Bytes replaced(const Bytes& bytes, const std::string& what, const std::string& by) {
    std::string content(bytes.begin(), bytes.end());
    content.replace(content.find(what), what.size(), by);
    return {content.begin(), content.end()};
}

RoomShape anyRoomShape(test::Random& random) {
    RoomShape room;
    for (int i = 0; i < 7; ++i) {
        const double angle = 2 * std::numbers::pi * i / 7;
        room.outline.push_back(random.uniform(2, 5) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    room.ceilingM = random.uniform(2, 4);
    return room;
}

} // namespace

TEST(DepthFile, IsRefusedWithAnotherHeaderNamingTheFile) {
    const Bytes good = depthFile(32);
    DepthMap::parse(good, "d.pgm");
    for (const auto& [what, by] : std::vector<std::pair<std::string, std::string>>{{"P5", "P6"},
                                                                                   {"1600", "1000"},
                                                                                   {"32 16", "32 15"},
                                                                                   {"32 16", "16 32"},
                                                                                   {"32 16", "64 32"},
                                                                                   {"32 16", "0 0"},
                                                                                   {"32 16", "-32 16"},
                                                                                   {"32 16", "99999999 16"},
                                                                                   {"32 16", "32"},
                                                                                   {"65535", "255"},
                                                                                   {"65535", ""}}) {
        SCOPED_TRACE(what + " -> " + by);
        test::expectError(ErrorKind::Corrupt, "d.pgm",
                          [&, w = what, b = by] { DepthMap::parse(replaced(good, w, b), "d.pgm"); });
    }
    Bytes longer = good;
    longer.push_back(0);
    test::expectError(ErrorKind::Corrupt, "another length", [&] { DepthMap::parse(longer, "d.pgm"); });
}

TEST(DepthFile, IsReadOrRefusedWhicheverByteIsChanged) {
    test::Random random(922);
    SCOPED_TRACE(random.seed());
    const Bytes good = depthFile(16);
    for (int i = 0; i < 3000; ++i) {
        Bytes changed = good;
        const auto last = static_cast<int>(i % 2 == 0 ? std::min<std::size_t>(80, good.size()) : good.size());
        changed[static_cast<std::size_t>(random.integer(0, last - 1))] =
            static_cast<Bytes::value_type>(random.integer(0, 255));
        try {
            const DepthMap map = DepthMap::parse(changed, "d.pgm");
            EXPECT_EQ(map.width(), 16);
            EXPECT_TRUE(std::ranges::all_of(map.inverseM().values(), [](float value) { return value > 0; }));
        } catch (const Error& error) {
            EXPECT_EQ(name(error.kind()), name(ErrorKind::Corrupt)) << error.sentence();
        }
    }
}

TEST(DepthFile, KeepsWhatIsInfinitelyNearOrBehindWithinItsRange) {
    Image<float, 1> inverse(16, 8);
    *inverse.at(0, 0) = std::numeric_limits<float>::infinity();
    *inverse.at(1, 0) = -5;
    *inverse.at(2, 0) = 0;
    const DepthMap map = DepthMap::parse(DepthMap(std::move(inverse)).serialised(), "d.pgm");
    EXPECT_FLOAT_EQ(*map.inverseM().at(0, 0), DepthMap::kSteps * DepthMap::kStepPerM);
    EXPECT_FLOAT_EQ(*map.inverseM().at(1, 0), DepthMap::kStepPerM);
    EXPECT_FLOAT_EQ(*map.inverseM().at(2, 0), DepthMap::kStepPerM);
}

TEST(RoomShape, IsAsFarHoweverItIsTurnedAndWhereverItLies) {
    for (unsigned seed = 930; seed < 940; ++seed) {
        test::Random random(seed);
        const RoomShape room = anyRoomShape(random);
        const Vector3d from(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.5, 1.5));
        const double angle = random.uniform(0, 6);
        const Vector3d movedM(1e6, -2e6, 30);
        const Eigen::AngleAxisd turn(angle, Vector3d::UnitZ());
        RoomShape moved = room;
        for (Eigen::Vector2d& corner : moved.outline) {
            corner = (turn * Vector3d(corner.x(), corner.y(), 0) + movedM).head<2>();
        }
        moved.floorM += movedM.z();
        moved.ceilingM += movedM.z();
        for (int i = 0; i < 200; ++i) {
            const Vector3d ray = random.direction();
            const double inverseM = inverseDistance(room, from, ray);
            EXPECT_NEAR(inverseDistance(moved, turn * from + movedM, turn * ray), inverseM, 1e-6) << seed;
            EXPECT_NEAR(inverseDistance(room, from, 7 * ray), inverseM, 1e-12) << seed;
            // What the ray meets is on a wall, the floor or the ceiling: from there it is no way to go.
            const Vector3d met = from + (1 - 1e-6) / inverseM * ray;
            EXPECT_GT(inverseDistance(room, met, ray), 1e4) << seed;
        }
    }
}

} // namespace spherewalk::render
