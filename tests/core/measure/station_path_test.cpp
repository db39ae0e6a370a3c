// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "station_path.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::measure {

using Eigen::Vector3d;

namespace {

render::DatasetInfo takenAt(const std::vector<Vector3d>& places) {
    render::DatasetInfo info;
    for (const Vector3d& place : places) {
        info.photos.emplace_back().roomFromPhoto.translation = place;
    }
    return info;
}

} // namespace

TEST(StationPath, SerpentineVisitsEachPlaceOfAGridOnceWithoutJumps) {
    test::Random random(11);
    SCOPED_TRACE(random.seed());
    std::vector<Vector3d> places;
    for (int x = 0; x < 7; ++x) {
        for (int y = 0; y < 5; ++y) {
            // A centimetre of error does not break a row.
            places.emplace_back(0.2 * x + random.uniform(-0.01, 0.01), 0.2 * y + random.uniform(-0.01, 0.01),
                                1.2 + random.uniform(-0.01, 0.01));
            places.push_back(places.back()); // two photos of one place
        }
    }
    std::shuffle(places.begin(), places.end(), std::mt19937(3));
    const std::vector<Vector3d> path = serpentine(takenAt(places));
    ASSERT_EQ(path.size(), 35U);
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_LT((path[i] - path[i - 1]).norm(), 0.25) << i;
    }
    for (const Vector3d& place : places) {
        EXPECT_EQ(std::count(path.begin(), path.end(), place), 1);
    }
}

TEST(StationPath, IsWalkedToAndFro) {
    const StationPath path({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}});
    EXPECT_EQ(path.lengthM(), 3);
    EXPECT_EQ(path.at(0), Vector3d(0, 0, 0));
    EXPECT_EQ(path.at(1.5), Vector3d(1.5, 0, 0));
    EXPECT_EQ(path.at(2.5), Vector3d(2, 0.5, 0));
    EXPECT_EQ(path.at(3), Vector3d(2, 1, 0));
    EXPECT_EQ(path.at(4), Vector3d(2, 0, 0));
    EXPECT_EQ(path.at(5.5), Vector3d(0.5, 0, 0));
    EXPECT_EQ(path.at(6), Vector3d(0, 0, 0));
    EXPECT_EQ(path.at(601.5), Vector3d(1.5, 0, 0));
}

TEST(StationPath, OfOnePlaceStaysThere) {
    const StationPath path(serpentine(takenAt({{1, 2, 3}})));
    EXPECT_EQ(path.lengthM(), 0);
    EXPECT_EQ(path.at(0), Vector3d(1, 2, 3));
    EXPECT_EQ(path.at(17), Vector3d(1, 2, 3));
}

} // namespace spherewalk::measure
